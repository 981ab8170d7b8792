#pragma once

// Numerical stability: the functions of the shader chunks, run on this very GPU over ordinary and extreme inputs,
// against their twins in double precision (src/optics/). The engine of `facet selftest` and of
// tests/selftest/numerics_gl_test.cpp.

#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "selftest/shader_probe.hpp"

namespace facet::selftest {

using CheckVectors = std::span<const glm::dvec4>;
using CheckValues = std::vector<double>;

// One function of a chunk. Inputs are rounded to float before the twin sees them, so that only arithmetic is compared.
struct Check {
  std::string name;  // of the GLSL function
  Probe probe;
  std::vector<std::string> inputNames = {};  // of in0.x, in0.y, ..., in1.x, ...; empty: not shown
  std::vector<glm::vec4> inputs = {};        // probe.inputs for each evaluation
  // What the function should give. Where the shader clamps an argument, the twin gets the clamped one (`clamped`).
  std::function<CheckValues(CheckVectors in)> twin = {};
  // Textures or buffers that the function reads: made and bound before it runs, and kept until it has.
  std::function<std::shared_ptr<const void>()> bind = {};
  // What is held against it; none: as many leading components of out0, out1, ... as the twin has values.
  std::function<CheckValues(CheckVectors in, CheckVectors out)> observe = {};
  // error = |got - expected|, divided by max(|expected|, floor) where relative. Allowed: tolerance * conditioning(in).
  bool relative = true;
  double floor = 1e-30;
  double tolerance = 0;
  std::function<double(CheckVectors in)> conditioning = {};  // none: 1
  std::string reason = {};                                   // of tolerance and conditioning
  std::string clamped = {};                                  // which arguments the twin gets clamped; may be empty
};

struct CheckResult {
  std::string name, reason, clamped;
  bool relative = true;
  size_t evaluations = 0;
  // Where the error is the largest share of what is allowed.
  double error = 0, allowed = 0, got = 0, expected = 0;
  std::string input;
  size_t nonFinite = 0;        // values that are NaN or infinite where the twin's is not
  std::string firstNonFinite;  // the input of the first one
  bool passed = false;
};

// The whole table. Costs some ten milliseconds of quadrature.
std::vector<Check> numericalChecks();

// Errors: the shader does not compile.
Result<CheckResult> runCheck(const Check& check, const shading::ShaderReader& reader);

}  // namespace facet::selftest
