#pragma once

// builtin:robot: a robot grown from rules walks through a room into a corridor, whose lamps come on before it.

#include <cstdint>
#include <vector>

#include "scene/make/walk.hpp"

namespace facet::scene {

inline constexpr double robotFilm = 24;     // seconds: twenty periods of its gait, then it begins anew
inline constexpr double robotStart = -5.2;  // where it begins on the Z axis
inline constexpr Gait robotGait = {};

// A .glb with the animation "walk" and the camera "film". Nodes "left ankle" and "right ankle" are its ankles.
std::vector<uint8_t> robot();

}  // namespace facet::scene
