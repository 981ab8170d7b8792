#pragma once

// A surface with every layer and change of the lobes: in GLSL, and its twin.

#include <string>
#include <vector>

#include "optics/bsdf.hpp"
#include "shading/assembler.hpp"

namespace facet::selftest {

// Statements that make `Surface s`, N = +Z, of vec3 V, vec3 baseColor, float metallic, float perceptualRoughness, vec4
// layers (layerNames), vec4 dfg (A and B of the base, of the coat) and vec2 sheenAlbedo (E at V and L).
extern const char* const layeredSurfaceText;
extern const std::vector<std::string> layerNames;
// Names of a check's inputs, with those of `layers` between.
std::vector<std::string> aroundLayers(std::vector<std::string> before, const std::vector<std::string>& after = {});
extern const std::vector<shading::Define> allLayers;

optics::Surface layeredSurface(const glm::dvec3& baseColor, double metallic, double perceptualRoughness,
                               const glm::dvec4& layers);

}  // namespace facet::selftest
