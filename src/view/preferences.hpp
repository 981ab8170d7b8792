#pragma once

// What the user has set about the window itself, kept in settings.json beside imgui.ini.

#include <filesystem>

#include "base/choice.hpp"
#include "base/error.hpp"

namespace facet::view {

enum class Theme { dark, light };

// What a drag with the left button does: the camera goes round the target with a level horizon, or freely; or the
// picture is moved, and nothing turns it.
enum class Hand { orbit, trackball, plane };
inline constexpr Choice<Hand> hands[] = {
    {Hand::orbit, "orbit", "orbit", "left drag: round the target; the horizon stays level"},
    {Hand::trackball, "trackball", "trackball", "left drag: round the target any way, over the poles, too"},
    {Hand::plane, "2d", "2D", "every drag moves the picture, the wheel zooms: for plans and charts"}};
static_assert(inOrder(hands));

struct Preferences {
  Theme theme = Theme::dark;
  float scale = 0;  // of letters and controls, [0.5, 4]; 0: the monitor's
  bool startWithLast = false, playOnOpening = false;
  int width = 0, height = 0;  // of the window as it was left; 0: not known
  Hand hand = Hand::orbit;

  bool operator==(const Preferences&) const = default;
};

// A missing file and missing entries leave what is usual. Errors: the file is no JSON object or holds another kind of
// value.
Result<Preferences> readPreferences(const std::filesystem::path& file);
// Errors: cannot be written.
Result<void> writePreferences(const std::filesystem::path& file, const Preferences& preferences);

}  // namespace facet::view
