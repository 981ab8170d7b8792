#pragma once

// Runs one function of a shader chunk over an array on this very GPU, so that C++ can judge it. The chunk is the
// production file; only the entry point is made here.

#include <glm/glm.hpp>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "shading/assembler.hpp"

namespace facet::selftest {

struct Probe {
  std::vector<std::string> chunks;  // "microfacet.glsl"
  std::string body;                 // GLSL statements: read in0, in1, ... (vec4), write out0, out1, ... (vec4)
  int inputs = 1, outputs = 1;      // vec4 per element
  std::vector<shading::Define> defines = {};
};

// inputs.size() = elements * probe.inputs; returns elements * probe.outputs values. Errors: the shader does not
// compile.
Result<std::vector<glm::vec4>> runProbe(const Probe& probe, std::span<const glm::vec4> inputs,
                                        const shading::ShaderReader& reader);

// The chunks that it is assembled from, of shaders/; none where one is missing.
std::vector<std::string> probeFiles(const Probe& probe, const shading::ShaderReader& reader);

// The same values, and the least that `repeat` runs of the shader take, each waited for [ms].
struct TimedProbe {
  std::vector<glm::vec4> values;
  double milliseconds = 0;
};
Result<TimedProbe> timeProbe(const Probe& probe, std::span<const glm::vec4> inputs, const shading::ShaderReader& reader,
                             int repeat);

}  // namespace facet::selftest
