#pragma once

// Environments that need no file. They cost milliseconds, are the same on every machine to float rounding, and are
// documented by figures that the tests hold.

#include <span>
#include <string_view>

#include "base/error.hpp"
#include "scene/environment.hpp"

namespace facet::scene {

struct BuiltinEnvironment {
  std::string_view name;
  std::string_view description;  // one line
};
std::span<const BuiltinEnvironment> builtinEnvironments();

// name: "studio", "sky", "white", with or without "builtin:" before it. An error names those that exist.
//   studio  512 x 256. Softboxes in a dark room: a large key light left of the camera, a strip to the right, one
//           overhead, two strips behind; floor and walls a soft gradient. Key light 10, mean 0.73.
//   sky     1024 x 512. Clear sky after Preetham, Shirley, Smits 1999 (turbidity 2.5) over a grey ground; the sun 40
//           degrees high, behind the left shoulder of a camera at theta 0. A level white Lambertian surface in the open
//           has radiance 1. The sun disc (0.533 degrees) is spread over its texels such that its energy is exact: up to
//           5e4, near the end of half-float's range.
//   white   64 x 32, radiance 1.
Result<Environment> builtinEnvironment(std::string_view name);

// The sun of "sky": direction to it, and irradiance on a surface that faces it (linear Rec. 709).
glm::dvec3 builtinSunDirection();
glm::dvec3 builtinSunIrradiance();

}  // namespace facet::scene
