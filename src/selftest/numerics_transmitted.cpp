#include "optics/microfacet.hpp"
#include "optics/transmitted.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

Check checkAlpha() {
  Check check =
      absoluteCheck("transmittedAlpha", "transmitted.glsl", "out0.x = transmittedAlpha(in0.x, in0.y, in0.z > 0.5);",
                    {"perceptualRoughness", "ior", "volume"});
  check.inputs = grid({0, 1e-3, 0.3, 1}, {0, 1, 1.001, 1.33, 1.5, 3, 100}, {0, 1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::transmittedAlpha(in[0].x, in[0].y, in[0].z > 0.5)}; };
  allow(check, 8, "8 roundings of numbers up to 2");
  return check;
}

Check checkLobe() {
  Check check = absoluteCheck("transmittedLobe", "transmitted.glsl",
                              "out0.x = transmittedLobe(vec3(0.0, 0.0, 1.0), in0.xyz, in1.xyz, in0.w);",
                              {"V.x", "V.y", "V.z", "alpha", "L.x", "L.y", "L.z"}, 2);
  for (double alpha : {0.0, 1e-4, 1e-3, 0.03, 0.3, 1.0})
    for (double NoV : {-0.2, 1e-3, 0.05, 0.5, 1.0})
      for (double NoL : {-1.0, -0.5, -0.1, -1e-3, 0.3})
        for (double phi : {0.1, 1.0, 0.1 + pi}) {
          check.inputs.emplace_back(glm::vec3(around(NoV, 0.1)), alpha);
          check.inputs.emplace_back(glm::vec3(around(NoL, phi)), 0);
        }
  const auto alphaOf = [](CheckVectors in) { return in[0].w > 0 ? std::max(in[0].w, minAnalyticAlphaFloat) : 0; };
  const auto scale = [=](CheckVectors in) {
    const double alpha = std::max(alphaOf(in), minAnalyticAlphaFloat);
    return std::max(1.0, 1 / (pi * alpha * alpha) / (4 * std::max(in[0].z, minNoVFloat)));
  };
  check.twin = [=](CheckVectors in) {
    const glm::dvec3 V = glm::normalize(xyzOf(in[0])), L = glm::normalize(xyzOf(in[1]));
    return CheckValues{optics::transmittedLobe(V, L, alphaOf(in)) / scale(in)};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x / scale(in)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [=](CheckVectors in) {
    const glm::dvec3 L = xyzOf(in[1]);
    const double sum = std::max(glm::length(xyzOf(in[0]) + glm::dvec3(L.x, L.y, -L.z)), 1e-4);
    return 40 + 8 / (std::max(alphaOf(in), minAnalyticAlphaFloat) * sum) +
           4 / std::max(std::abs(in[0].z), minNoVFloat) + 4 / std::max(std::abs(in[1].z), 1e-4);
  };
  check.reason = "of f over its peak: as evaluateBsdf";
  check.clamped = "alpha >= 1e-3 (minAnalyticAlpha)";
  return check;
}

Check checkVariance() {
  Check check = relativeCheck("behindVariance", "transmitted.glsl", "out0.x = behindVariance(int(in0.x));", {"level"});
  check.inputs = grid({0, 1, 2, 5, 13});
  check.twin = [](CheckVectors in) { return CheckValues{optics::behindVariance(int(in[0].x))}; };
  allow(check, 8, "4 roundings; half cancels at level 0; exp2 is the driver's");
  return check;
}

Check checkLevel() {
  Check check = absoluteCheck(
      "findBehindLevel", "transmitted.glsl",
      "int level; float weight; findBehindLevel(in0.x, int(in0.y), level, weight); out0.x = float(level) + weight;",
      {"variance", "levels"});
  check.inputs = grid({0, 1e-4, 0.2, 1.0 / 3, 0.34, 1, 2.0833333, 40, 9.08, 1e4, 1e9}, {1, 2, 5, 14});
  check.twin = [](CheckVectors in) {
    const optics::BehindLevel found = optics::findBehindLevel(in[0].x, int(in[0].y));
    return CheckValues{found.level + found.weight};  // continuous where the level changes
  };
  allow(check, 64, "the share of a level: 16 roundings of numbers up to four times the level's variance; its log2");
  return check;
}

}  // namespace

std::vector<Check> transmittedChecks() { return {checkAlpha(), checkLobe(), checkVariance(), checkLevel()}; }

}  // namespace facet::selftest
