#pragma once

// What is drawn over a picture, as lines in the world: pure, no OpenGL.

#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/draw_list.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::frame {

// A line, or a dot where its ends are one point; as shaders/passes/overlay.vert.glsl reads it.
struct OverlayLine {
  glm::vec3 from = glm::vec3(0);  // metres from the list's origin
  float width = 1;                // pixels
  glm::vec3 to = glm::vec3(0);
  float hidden = 0;                // what is left of its alpha behind surfaces, [0, 1]
  glm::vec4 color = glm::vec4(1);  // display values; straight alpha
};
static_assert(sizeof(OverlayLine) == 12 * sizeof(float));

// As many as any driver takes in one storage buffer.
inline constexpr size_t mostOverlayLines = (size_t{1} << 27) / sizeof(OverlayLine);

struct OverlayLines {
  std::vector<OverlayLine> lines;
  std::optional<double> gridSpacing;  // metres; where there is a grid
  std::string remark;                 // what has nothing to show, or too much of it; empty: nothing
};

struct OverlayScene {
  const scene::Model& model;
  const DrawList& list;
  int scene = 0;                  // that the list is of
  std::optional<scene::Sun> sun;  // of the environment, where it is a light of its own
  double environmentRotationDeg = 0;
  double aspect = 1;  // of the picture, for cameras without one
  int joint = -1;     // node: of a skeleton's, whose influence is shown; -1: of none
};

// Errors: the placement names no animation of the model.
Result<OverlayLines> overlayLines(const OverlayScene& of, const Placement& placement, const Overlays& overlays);

// 1, 2 or 5 times a power of ten: the least of which no more than 20 fit into the length.
double gridSpacing(double length);

}  // namespace facet::frame
