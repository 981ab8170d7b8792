// What the headers that C++ and GLSL both read begin with. LAYOUT_CONST makes a constant int, LAYOUT_UINT and
// LAYOUT_FLOAT the others; what stands between LAYOUT_BEGIN and LAYOUT_END lies in namespace facet::layout, where GLSL's
// types have their names.
#pragma once
#ifdef __cplusplus
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>

namespace facet::layout {
using glm::mat4;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = uint32_t;
}  // namespace facet::layout

#define LAYOUT_CONST inline constexpr int
#define LAYOUT_UINT inline constexpr uint
#define LAYOUT_FLOAT inline constexpr float
#define LAYOUT_BEGIN namespace facet::layout {
#define LAYOUT_END }
#else
#define LAYOUT_CONST const int
#define LAYOUT_UINT const uint
#define LAYOUT_FLOAT const float
#define LAYOUT_BEGIN
#define LAYOUT_END
#endif
