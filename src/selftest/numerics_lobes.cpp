#include "optics/anisotropy.hpp"
#include "optics/iridescence.hpp"
#include "optics/quadrature.hpp"
#include "optics/sheen.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

// ---- anisotropy.glsl ------------------------------------------------------------------------------------------------

const std::vector<glm::dvec2> alphaPairs = {{1e-3, 1e-3}, {1, 1e-3}, {1e-2, 0.5}, {0.3, 0.3}, {1, 1}};
optics::AnisotropicAlpha alphaOf(const glm::dvec4& v) { return {v.x, v.y}; }

Check checkAlphaMapping() {
  Check check = relativeCheck("alphaFromAnisotropy", "anisotropy.glsl", "out0.xy = alphaFromAnisotropy(in0.x, in0.y);",
                              {"alpha", "strength"});
  check.inputs = grid({0, 1e-6, 0.1, 1}, {0, 1e-3, 0.5, 1});
  check.twin = [](CheckVectors in) {
    const optics::AnisotropicAlpha alpha = optics::alphaFromAnisotropy(in[0].x, in[0].y);
    return CheckValues{alpha.t, alpha.b};
  };
  allow(check, 4, "4 roundings, nothing cancels");
  return check;
}

Check checkAnisotropicD() {
  Check check = absoluteCheck("D_GGXAnisotropic", "anisotropy.glsl", "out0.x = D_GGXAnisotropic(in1.xyz, in0.xy);",
                              {"alpha.t", "alpha.b", "", "", "H.x", "H.y", "H.z"}, 2);
  for (const glm::dvec2& alpha : alphaPairs)
    for (double phi : {0.0, 0.6, pi / 2, 4.0})
      for (double slope : {0.0, 0.1, 1.0, 5.0, 1e3, -1.0}) {
        // Slopes in units of the lobe; -1: below the horizon.
        const glm::dvec3 H(slope * alpha.x * std::cos(phi), slope * alpha.y * std::sin(phi), slope < 0 ? -1 : 1);
        check.inputs.emplace_back(alpha.x, alpha.y, 0, 0);
        check.inputs.emplace_back(glm::vec3(glm::normalize(H)), 0);
      }
  check.twin = [](CheckVectors in) {
    const optics::AnisotropicAlpha alpha = alphaOf(in[0]);
    return CheckValues{optics::D_GGXAnisotropic(xyzOf(in[1]), alpha) * pi * alpha.t * alpha.b};
  };
  check.observe = [](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x * pi * in[0].x * in[0].y}; };
  allow(check, 16, "of D / peak: 16 roundings, nothing cancels");
  return check;
}

Check checkAnisotropicV() {
  Check check =
      relativeCheck("V_GGXAnisotropic", "anisotropy.glsl", "out0.x = V_GGXAnisotropic(in1.xyz, in2.xyz, in0.xy);",
                    {"alpha.t", "alpha.b", "", "", "V.x", "V.y", "V.z", "", "L.x", "L.y", "L.z"}, 3);
  for (const glm::dvec2& alpha : alphaPairs)
    for (double NoV : {minNoVFloat, 0.02, 0.5, 1.0})
      for (double NoL : {1e-5, 1e-3, 0.3, 1.0})
        for (double phi : {0.1, 1.5, 3.0}) {
          check.inputs.emplace_back(alpha.x, alpha.y, 0, 0);
          check.inputs.emplace_back(glm::vec3(around(NoV, 0.2)), 0);
          check.inputs.emplace_back(glm::vec3(around(NoL, phi)), 0);
        }
  check.twin = [](CheckVectors in) {
    return CheckValues{optics::V_GGXAnisotropic(xyzOf(in[1]), xyzOf(in[2]), alphaOf(in[0]))};
  };
  allow(check, 12, "12 roundings, nothing cancels");
  check.clamped = "alpha >= 1e-3 (minAnalyticAlpha), NoV >= 1e-4 (minNoV)";
  return check;
}

Check checkAnisotropicG1() {
  Check check = relativeCheck("G1_GGXAnisotropic", "anisotropy.glsl", "out0.x = G1_GGXAnisotropic(in1.xyz, in0.xy);",
                              {"alpha.t", "alpha.b", "", "", "X.x", "X.y", "X.z"}, 2);
  for (const glm::dvec2& alpha : alphaPairs)
    for (double cosine : {-0.1, 1e-6, 1e-3, 0.1, 0.7, 1.0})
      for (double phi : {0.0, 0.8, pi / 2}) {
        check.inputs.emplace_back(alpha.x, alpha.y, 0, 0);
        check.inputs.emplace_back(glm::vec3(around(cosine, phi)), 0);
      }
  check.twin = [](CheckVectors in) { return CheckValues{optics::G1_GGXAnisotropic(xyzOf(in[1]), alphaOf(in[0]))}; };
  // Near the normal |alpha X.xy|^2 + X.z^2 takes X for a unit vector, which it is to an epsilon.
  allow(check, 12, "12 roundings, nothing cancels");
  return check;
}

Check checkAnisotropicSample() {
  Check check = absoluteCheck("sampleVisibleNormalAnisotropic", "anisotropy.glsl",
                              "out0.xyz = sampleVisibleNormalAnisotropic(in1.xyz, in0.xy, in0.zw);",
                              {"alpha.t", "alpha.b", "u.x", "u.y", "V.x", "V.y", "V.z"}, 2);
  for (const glm::dvec2& alpha : alphaPairs)
    for (double NoV : {minNoVFloat, 0.02, 0.5, 1.0})
      for (uint32_t i = 0; i < 16; ++i) {
        const glm::dvec2 u = optics::hammersley(i, 16);
        check.inputs.emplace_back(alpha.x, alpha.y, u.x, u.y + 0.02);
        check.inputs.emplace_back(glm::vec3(around(NoV, 0.7)), 0);
      }
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::sampleVisibleGGXAnisotropic(xyzOf(in[1]), alphaOf(in[0]), {in[0].z, in[0].w}));
  };
  allow(check, 128, "64 roundings, sin and cos are the driver's; far below the distance of samples");
  return check;
}

// ---- sheen.glsl -----------------------------------------------------------------------------------------------------

const Axis sheenAlphas = {0, 1e-3, 0.0025, 0.05, 0.36, 1};
const Axis sheenCosines = {-0.1, 0, 1e-30, 1e-6, 1e-4, 1e-2, 0.3, 0.5 - 1e-6, 0.5, 0.8, 1 - 1e-6, 1};

Check checkCharlieD() {
  Check check = absoluteCheck("D_Charlie", "sheen.glsl", "out0.x = D_Charlie(in0.x, in0.y);", {"NoH", "alpha"});
  check.inputs = grid(sheenCosines, sheenAlphas);
  const auto peak = [](double alpha) { return optics::D_Charlie(0, alpha); };
  check.twin = [peak](CheckVectors in) { return CheckValues{optics::D_Charlie(in[0].x, in[0].y) / peak(in[0].y)}; };
  check.observe = [peak](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x / peak(in[0].y)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 64 + 2 / std::max(in[0].y, 1e-3); };
  check.reason = "of D / peak: pow is exp2(y log2(x)), the driver's, and y is 1 / (2 alpha)";
  check.clamped = "alpha >= 1e-3 (minSheenAlpha)";
  return check;
}

Check checkCharlieLambda() {
  Check check =
      relativeCheck("Lambda_Charlie", "sheen.glsl", "out0.x = Lambda_Charlie(in0.x, in0.y);", {"cosine", "alpha"});
  check.inputs = grid(sheenCosines, sheenAlphas);
  check.twin = [](CheckVectors in) { return CheckValues{optics::Lambda_Charlie(in[0].x, in[0].y)}; };
  allow(check, 512, "exp of numbers up to 21, made from sums of numbers up to 25; pow is the driver's");
  return check;
}

Check checkCharlieV() {
  Check check =
      relativeCheck("V_Charlie", "sheen.glsl", "out0.x = V_Charlie(in0.x, in0.y, in0.z);", {"NoV", "NoL", "alpha"});
  check.inputs = grid({-0.1, 0, 1e-4, 0.02, 0.6, 1}, {0, 1e-6, 1e-3, 0.3, 1}, sheenAlphas);
  check.twin = [](CheckVectors in) { return CheckValues{optics::V_Charlie(in[0].x, in[0].y, in[0].z)}; };
  allow(check, 512, "as Lambda_Charlie");
  check.clamped = "cosines >= 1e-4 (minNoV)";
  return check;
}

Check checkSheenScaling() {
  Check check =
      absoluteCheck("sheenScaling", "sheen.glsl", "out0.x = sheenScaling(vec3(0.5 * in0.x, in0.x, 0.0), in0.y, in0.z);",
                    {"sheenColor", "albedoV", "albedoL"});
  check.inputs = grid({0, 0.3, 1}, {0, 0.5, 1, 4}, {0, 0.2, 1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::sheenScaling(in[0].x, in[0].y, in[0].z)}; };
  allow(check, 4, "4 roundings of numbers up to 1");
  return check;
}

Check checkSheenGuard() {
  Check check =
      relativeCheck("sheenGainGuard", "sheen.glsl", "out0.x = sheenGainGuard(in0.x, in0.y);", {"albedoV", "albedoL"});
  check.inputs = grid({0, 0.5, 1, 1 + 1e-6, 4}, {0, 0.2, 1.1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::sheenGainGuard(in[0].x, in[0].y)}; };
  allow(check, 2, "one division");
  return check;
}

// ---- iridescence.glsl -----------------------------------------------------------------------------------------------

Check checkInterference() {
  Check check = absoluteCheck("interferenceColor", "iridescence.glsl",
                              "out0.rgb = interferenceColor(in0.x, vec3(0.0, 3.14159265, 1.0));", {"path"});
  check.inputs = grid({0, 1e-3, 50, 200, 550, 1000, 2500, 6000, 2e4, 1e5, 1e30});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::interferenceColor(in[0].x, {0, double(3.14159265f), 1}));
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 64 + 0.1 * std::min(in[0].x, 1e4); };
  check.reason = "the cosine's argument is 0.014 path and off by 4 epsilon of itself; cos and exp are the driver's";
  return check;
}

Check checkFilm() {
  Check check = absoluteCheck("F_ThinFilm", "iridescence.glsl",
                              "out0.rgb = F_ThinFilm(in0.x, 1.0, in0.y, in0.z, vec3(in0.w, 0.04, 0.9));",
                              {"VoH", "film ior", "thickness", "f0"});
  check.inputs = grid({0, 1e-4, 0.02, 0.2, 0.6, 1}, {1, 1.1, 1.3, 1.8, 3}, {0, 0.01, 0.03, 100, 400, 1200, 1e5, 1e30},
                      {0, 0.1, 0.6, 1});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::F_ThinFilm(in[0].x, 1, in[0].y, in[0].z, {in[0].w, double(0.04f), double(0.9f)}));
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    // cos2 = sqrt(1 - sin^2 / ior^2) is off by epsilon / cos2; the path by that much of 2 ior thickness.
    const double sin2 = (1 - in[0].x * in[0].x) / (in[0].y * in[0].y), cos2 = std::sqrt(std::max(1 - sin2, 1e-7));
    const double toInfinity = 1 - std::sqrt(std::min(in[0].w, 0.9999));  // of which the base's index is 2 / toInfinity
    return 128 + 8 / cos2 + 0.4 * std::min(in[0].y * in[0].z, 1e4) / std::max(cos2, 0.01) + 0.1 / toInfinity;
  };
  check.reason =
      "100 roundings; the optical path is off by an epsilon and turns the cosines by 0.014 of it; the index of an f0 "
      "near "
      "1 is 2 / (1 - sqrt(f0))";
  check.clamped = "thickness <= 1e5 nm";
  return check;
}

Check checkF0FromSchlick() {
  Check check =
      absoluteCheck("f0FromSchlick", "iridescence.glsl", "out0.x = f0FromSchlick(in0.xxx, in0.y).x;", {"F", "VoH"});
  check.inputs = grid({0, 0.04, 0.5, 1, 1.2}, {0, 0.02, 0.1, 0.5, 1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::f0FromSchlick(glm::dvec3(in[0].x), in[0].y).x}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 8 + 4 / std::max(1 - std::pow(1 - in[0].y, 5), 1e-4); };
  check.reason = "8 roundings over 1 - (1 - VoH)^5";
  return check;
}

}  // namespace

std::vector<Check> lobeChecks() {
  return {
      checkAlphaMapping(), checkAnisotropicD(),  checkAnisotropicV(),  checkAnisotropicG1(), checkAnisotropicSample(),
      checkCharlieD(),     checkCharlieLambda(), checkCharlieV(),      checkSheenScaling(),  checkSheenGuard(),
      checkInterference(), checkFilm(),          checkF0FromSchlick(),
  };
}

}  // namespace facet::selftest
