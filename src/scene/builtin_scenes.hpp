#pragma once

// Scenes that need no file. They are written as .glb in memory and take the loader's ordinary way.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/camera.hpp"

namespace facet::scene {

struct BuiltinScene {
  std::string_view name;
  std::string_view description;  // one line
  std::string_view environment;  // the one that it is made for, as --env takes it
  OrbitCamera camera;            // frames it in a square or wider picture
};
std::span<const BuiltinScene> builtinScenes();

// The row of that name, with or without "builtin:" before it; nullptr if there is none.
const BuiltinScene* findBuiltinScene(std::string_view name);

// A .glb. An error names the scenes that exist.
//   spheres  7 x 7 spheres of one colour, roughness 0 ... 1 to the right, metallic 0 ... 1 upwards; four point lights.
//   tutorial the chart that many begin with, as it has it: builtin_tutorial.hpp.
//   furnace  2 x 11 spheres, roughness 0 ... 1 to the right; white metal (F0 = 1) above, white dielectric below.
//   ndf      3 x 6 metal spheres: GGX, Beckmann, Blinn, roughness 0.15 ... 1 to the right; one point light. Each
//            material names its distribution (FACET_materials_models).
//   metals   a sphere for each metal preset, which it names likewise: --fresnel exact takes its complex index.
//   poster   a polished trefoil among spheres of many materials on a stone turntable, whose vertex colours hold the
//            occlusion of the sky by what stands on it.
//   robot    a robot of sweeps in a room with a corridor, in its walk, with textures from noise: builtin_robot.hpp.
//   crowd    100,000 nodes in a tree, all drawing one mesh; palette: 1,000 materials; marbles: 100 draws of small
//   textured
//            triangles. What large scenes cost.
Result<std::vector<uint8_t>> builtinScene(std::string_view name);

}  // namespace facet::scene
