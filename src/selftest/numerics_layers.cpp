#include "optics/layers.hpp"
#include "optics/microfacet.hpp"
#include "optics/transmission.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

// ---- transmission.glsl ----------------------------------------------------------------------------------------------

Check checkRefracted() {
  Check check = absoluteCheck("refractedDirection", "transmission.glsl",
                              "out0.xyz = refractedDirection(in0.xyz, vec3(0.0, 0.0, 1.0), in0.w);",
                              {"V.x", "V.y", "V.z", "eta"});
  for (double eta : {-1.0, 0.0, 1e-3, 0.4, 1 / 1.5, 0.95, 1.0, 1.05, 1.5, 2.42, 1e6, 1e-30})
    for (double NoV : {1e-4, 0.02, 0.3, 0.74, 0.9, 1.0}) check.inputs.emplace_back(glm::vec3(around(NoV, 0.4)), eta);
  check.twin = [](CheckVectors in) {
    glm::dvec3 L(0);
    return optics::refracted(xyzOf(in[0]), {0, 0, 1}, in[0].w, L) ? valuesOf(L) : CheckValues{0, 0, 0};
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    const double eta2 = in[0].w * in[0].w, cos2 = std::abs(1 - (1 - in[0].z * in[0].z) / std::max(eta2, 1e-12));
    return 16 + 4 * std::max(1.0, 1 / std::max(eta2, 1e-12)) / std::max(std::sqrt(cos2), 1e-3);
  };
  check.reason = "16 roundings; 1 - sin^2 / eta^2 cancels near the critical angle";
  return check;
}

// The height of the lobe, to which errors at its foot are held.
double lobePeak(double alpha) { return 1 / (pi * alpha * alpha); }

Check checkVolume() {
  Check check = absoluteCheck("volumeTransmittance", "transmission.glsl",
                              "out0.rgb = volumeTransmittance(vec3(in0.x, 1.0, 0.0), in0.y, in0.z);",
                              {"color", "1 / attenuationDistance", "distance"});
  check.inputs = grid({0, 1e-6, 0.2, 0.99, 1}, {0, 1e-6, 0.5, 100, 1e6}, {0, 1e-6, 0.01, 1, 50, 1e6});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::volumeTransmittance({in[0].x, 1, 0}, in[0].y > 0 ? 1 / in[0].y : 0, in[0].z));
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    const double exponent = -in[0].y * in[0].z * std::log2(std::max(in[0].x, 1e-30));
    return 16 + 8 * std::min(exponent, 200.0);
  };
  check.reason = "exp2(x) of an exponent x is off by x epsilon; log2 and exp2 are the driver's";
  check.clamped = "distance / attenuationDistance <= 1e6";
  return check;
}

Check checkDispersion() {
  Check check = relativeCheck("dispersedIors", "transmission.glsl", "out0.rgb = dispersedIors(in0.x, in0.y);",
                              {"ior", "dispersion"});
  check.inputs = grid({1, 1.0001, 1.33, 1.5, 2.42, 50}, {0, 0.1, 0.36, 2.04, 100});
  check.twin = [](CheckVectors in) { return valuesOf(optics::dispersedIors(in[0].x, in[0].y)); };
  allow(check, 16, "8 roundings; ior - halfSpread cancels by half an order where the spread is exaggerated");
  return check;
}

Check checkTransmissionRoughness() {
  Check check = absoluteCheck("transmissionRoughness", "transmission.glsl",
                              "out0.x = transmissionRoughness(in0.x, in0.y);", {"perceptualRoughness", "ior"});
  check.inputs = grid({0, 0.3, 1}, {0, 1, 1.1, 1.33, 1.5, 3});
  check.twin = [](CheckVectors in) { return CheckValues{optics::transmissionRoughness(in[0].x, in[0].y)}; };
  allow(check, 4, "4 roundings of numbers up to 2");
  return check;
}

// ---- layers.glsl ----------------------------------------------------------------------------------------------------

Check checkCoatLobe() {
  Check check =
      absoluteCheck("coatLobe", "layers.glsl", "out0.x = coatLobe(vec3(0.0, 0.0, 1.0), in0.xyz, in1.xyz, in0.w);",
                    {"V.x", "V.y", "V.z", "alpha", "L.x", "L.y", "L.z"}, 2);
  for (double alpha : {0.0, 1e-3, 0.03, 0.3, 1.0})
    for (double NoV : {-0.2, 1e-4, 0.05, 0.5, 1.0})
      for (double NoL : {-0.3, 1e-4, 0.1, 0.5, 1.0})
        for (double phi : {0.1, 1.0, 0.1 + pi}) {
          check.inputs.emplace_back(glm::vec3(around(NoV, 0.1)), alpha);
          check.inputs.emplace_back(glm::vec3(around(NoL, phi)), 0);
        }
  const auto alphaOf = [](CheckVectors in) { return std::max(in[0].w, minAnalyticAlphaFloat); };
  const auto scale = [=](CheckVectors in) {
    return std::max(1.0, lobePeak(alphaOf(in)) / (4 * std::max(in[0].z, minNoVFloat)));
  };
  check.twin = [=](CheckVectors in) {
    optics::Angles angles =
        optics::anglesBetween({0, 0, 1}, glm::normalize(xyzOf(in[0])), glm::normalize(xyzOf(in[1])));
    angles.NoV = std::clamp(angles.NoV, minNoVFloat, 1.0);
    if (angles.NoL <= 0) return CheckValues{0};
    const double D = optics::D_GGX(angles, alphaOf(in));
    const double V = optics::V_SmithGGXCorrelated(angles.NoV, angles.NoL, alphaOf(in));
    return CheckValues{D * V * optics::F_Coat(angles.VoH) * angles.NoL / scale(in)};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x / scale(in)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [=](CheckVectors in) {
    const double sum = std::max(glm::length(xyzOf(in[0]) + xyzOf(in[1])), 1e-4);
    return 40 + 8 / (alphaOf(in) * sum) + 4 / std::max(std::abs(in[0].z), minNoVFloat) +
           4 / std::max(std::abs(in[1].z), 1e-4);
  };
  check.reason = "of f over its peak: as evaluateBsdf";
  check.clamped = "NoV to [1e-4, 1] (minNoV), alpha >= 1e-3 (minAnalyticAlpha)";
  return check;
}

Check checkFactor(const std::string& function, const std::string& arguments, const std::vector<std::string>& names,
                  const std::vector<glm::vec4>& inputs, double (*twin)(const glm::dvec4&)) {
  Check check = absoluteCheck(function, "layers.glsl", "out0.x = " + function + "(" + arguments + ");", names);
  check.inputs = inputs;
  check.twin = [twin](CheckVectors in) { return CheckValues{twin(in[0])}; };
  allow(check, 12, "12 roundings of numbers up to 1");
  return check;
}

std::vector<Check> factorChecks() {
  return {
      checkFactor("F_Coat", "in0.x", {"VoH"}, grid({-0.1, 0, 1e-4, 0.5, 1, 1.001}),
                  [](const glm::dvec4& in) { return optics::F_Coat(in.x); }),
      checkCoatLobe(),
      checkFactor("layerTransmittance", "in0.x, in0.y", {"weight", "albedoV"}, grid({0, 0.5, 1}, {0, 0.5, 1, 4}),
                  [](const glm::dvec4& in) { return optics::layerTransmittance(in.x, in.y); }),
  };
}

}  // namespace

std::vector<Check> layerChecks() {
  std::vector<Check> checks = {checkRefracted(), checkVolume(), checkDispersion(), checkTransmissionRoughness()};
  for (const Check& check : factorChecks()) checks.push_back(check);
  return checks;
}

}  // namespace facet::selftest
