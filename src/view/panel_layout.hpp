#pragma once

// How wide the parts at the window's sides are: pure.

#include <map>
#include <optional>
#include <string>

namespace facet::view {

enum class Side { left, right };

// What the user has chosen; remembered in imgui.ini.
struct PanelLayout {
  float leftEms = 18, rightEms = 21;     // widths in font sizes
  Side last = Side::right;               // opened last: it stays where only one has room
  std::map<std::string, bool> sections;  // that were opened or folded
  std::optional<Side> folded;            // for want of room; not remembered
};

inline constexpr float leastLeftEms = 12, leastRightEms = 17, leastPictureEms = 20, foldedEms = 1.8f;

struct SideWidths {
  float left = 0, right = 0;  // pixels; 0: not shown
  std::optional<Side> folded;
};

// In a window of that width. Below a picture of leastPictureEms the sides become narrower, down to their least widths;
// then the one that was not opened last is folded to a strip of foldedEms; the other one goes over the picture rather
// than below its least width. What is wished stays, for a wider window.
SideWidths sideWidths(const PanelLayout& wished, bool leftShown, bool rightShown, float width, float em);

}  // namespace facet::view
