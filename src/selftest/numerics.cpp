#include "selftest/numerics.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdio>

#include "selftest/numerics_checks.hpp"

namespace facet::selftest {

namespace {

std::string describeInput(const Check& check, CheckVectors in) {
  std::string text;
  for (size_t i = 0; i < check.inputNames.size(); ++i) {
    if (check.inputNames[i].empty()) continue;
    char number[32];
    std::snprintf(number, sizeof number, "%.9g", in[i / 4][static_cast<int>(i % 4)]);
    text += (text.empty() ? "" : ", ") + check.inputNames[i] + " " + number;
  }
  return text;
}

CheckValues leadingComponents(CheckVectors out, size_t count) {
  CheckValues values(count);
  for (size_t i = 0; i < count; ++i) values[i] = out[i / 4][static_cast<int>(i % 4)];
  return values;
}

// Books one evaluation.
void judge(const Check& check, CheckVectors in, CheckVectors out, CheckResult& result) {
  const CheckValues expected = check.twin(in);
  const CheckValues got = check.observe ? check.observe(in, out) : leadingComponents(out, expected.size());
  assert(got.size() == expected.size());
  const double allowed = check.tolerance * (check.conditioning ? check.conditioning(in) : 1.0);
  for (size_t i = 0; i < got.size(); ++i) {
    if (!std::isfinite(got[i])) {
      if (result.nonFinite++ == 0) result.firstNonFinite = describeInput(check, in);
      continue;
    }
    const double scale = check.relative ? std::max(std::abs(expected[i]), check.floor) : 1.0;
    const double error = std::abs(got[i] - expected[i]) / scale;
    if (result.input.empty() || error * result.allowed > result.error * allowed) {
      result.error = error;
      result.allowed = allowed;
      result.got = got[i];
      result.expected = expected[i];
      result.input = describeInput(check, in);
    }
  }
}

}  // namespace

std::vector<Check> numericalChecks() {
  std::vector<Check> checks = surfaceChecks();
  for (auto more :
       {modelChecks(), choiceChecks(), lobeChecks(), layerChecks(), layeredChecks(), transmittedChecks(), lightChecks(),
        samplingChecks(), displayChecks(), mappingChecks(), measuredChecks(), lookUpChecks()})
    checks.insert(checks.end(), more.begin(), more.end());
  return checks;
}

Result<CheckResult> runCheck(const Check& check, const shading::ShaderReader& reader) {
  const std::shared_ptr<const void> bound = check.bind ? check.bind() : nullptr;
  const Result<std::vector<glm::vec4>> outputs = runProbe(check.probe, check.inputs, reader);
  if (!outputs) return tl::unexpected(outputs.error());
  const std::vector<glm::dvec4> in(check.inputs.begin(), check.inputs.end()), out(outputs->begin(), outputs->end());
  const auto width = static_cast<size_t>(check.probe.inputs), outWidth = static_cast<size_t>(check.probe.outputs);
  CheckResult result;
  result.name = check.name;
  result.reason = check.reason;
  result.clamped = check.clamped;
  result.relative = check.relative;
  result.evaluations = in.size() / width;
  for (size_t i = 0; i < result.evaluations; ++i)
    judge(check, CheckVectors(in).subspan(i * width, width), CheckVectors(out).subspan(i * outWidth, outWidth), result);
  result.passed = result.evaluations > 0 && result.nonFinite == 0 && result.error <= result.allowed;
  return result;
}

}  // namespace facet::selftest
