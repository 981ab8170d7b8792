#pragma once

// Shading chunks of distant light run over an array, with an environment's tables bound.

#include "ibl/tables.hpp"
#include "selftest/shader_probe.hpp"

namespace facet::selftest {

// One of the draws that a picture gathers; elements are pixels of one row.
struct ProbedDraw {
  int index = 0, draws = 1, seed = 0;
};

// body: as Probe's, with those chunks at hand; the environment is not turned, radiance is in
// stored values (times tables.radianceScale it is the map's), imageLight() in the map's.
Result<std::vector<glm::vec4>> probeLight(
    const ibl::Tables& tables, const shading::ShaderReader& reader, const std::vector<shading::Define>& defines,
    const std::string& body, std::span<const glm::vec4> inputs, int width = 1, int outputs = 1,
    const std::vector<std::string>& chunks = {"image_light.glsl", "dfg_table.glsl"}, const ProbedDraw& draw = {});

// Texels of a level of an RGBA32F cube, face by face.
std::vector<glm::vec4> readCubeLevel(const gl::Texture& cube, int level);
// int L dw over a level of tables.cube, in the map's units.
glm::dvec3 cubeFlux(const ibl::Tables& tables, int level);

}  // namespace facet::selftest
