#pragma once

#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/choice.hpp"
#include "scene/edit.hpp"

namespace facet::frame {

// Which axis of a model points up.
enum class UpAxis { y, z, x };
inline constexpr Choice<UpAxis> upAxes[] = {{UpAxis::y, "y", "Y", "as glTF has it"},
                                            {UpAxis::z, "z", "Z", "as CAD and maps have it: X stays"},
                                            {UpAxis::x, "x", "X", "Z stays"}};
static_assert(inOrder(upAxes));

// What is changed of a model without changing its file. It is scaled first, then turned up, turned about X, Y and Z of
// the world in this order, and moved.
struct Arrangement {
  scene::Edits edits;
  std::vector<std::string> only;  // nodes, by name or index; empty: all
  UpAxis up = UpAxis::y;
  glm::dvec3 rotationDeg = glm::dvec3(0);
  glm::dvec3 position = glm::dvec3(0);  // metres
  double scale = 1;                     // [1e-9, 1e9]

  bool operator==(const Arrangement&) const = default;
};

}  // namespace facet::frame
