#pragma once

// What differs between two models: for who has exported one anew.

#include <string>
#include <vector>

#include "scene/model.hpp"

namespace facet::scene {

// A line each, of things that are told apart by their names: "material 'brass': roughnessFactor 0.3 -> 0.5", "node
// 'arm': is gone", "triangles: 120 -> 96", "size: 1 x 2 x 1 m -> 100 x 200 x 100 m". Empty: nothing that is looked at:
// counts, names, size, placements, vertices, materials' numbers and textures, lights, cameras, durations.
std::vector<std::string> changesBetween(const Model& before, const Model& after);

}  // namespace facet::scene
