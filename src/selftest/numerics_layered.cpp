#include <algorithm>
#include <cmath>

#include "optics/anisotropy.hpp"
#include "optics/bsdf.hpp"
#include "optics/sheen.hpp"
#include "selftest/layered_surface.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

// in0: V, metallic; in1: L, perceptualRoughness; in2: the layers; in3: base A, B, coat A, B; in4: sheen E at V and L:
// what a table or a texture would bring.
const std::string layeredBody = R"(
  vec3 V = in0.xyz, baseColor = vec3(1.0, 0.5, 0.1);
  float metallic = in0.w, perceptualRoughness = in1.w;
  vec4 layers = in2, dfg = in3;
  vec2 sheenAlbedo = in4.xy;
)" + std::string(layeredSurfaceText) +
                                R"(
  out0.rgb = evaluateBsdf(s, in1.xyz);
  out1.rgb = (prefilteredAlbedo(s) + irradianceAlbedo(s)) * layersLeft(s);
)";

Check checkLayers(const char* name, const optics::Models& models = {}) {
  Check check{name,
              {{"bsdf.glsl"}, layeredBody, 5, 2, allLayers},
              aroundLayers({"V.x", "V.y", "V.z", "metallic", "L.x", "L.y", "L.z", "perceptualRoughness"}),
              {}};
  for (const double NoV : {1.0, 0.6, 0.05})
    for (const double NoL : {1.0, 0.5, 0.02})
      for (const double phi : {0.4, 2.5, 3.5})
        for (const double r : {0.1, 0.5, 1.0})
          for (const glm::vec4& layers : {glm::vec4(0), {1, 0.5, 1, 0.8}, {0.5, 0.1, 0.5, 0.3}, {1, 1, 0, 1}})
            for (const double metallic : {0.0, 0.5, 1.0}) {
              // Any A, B, E would do: those of a smooth closed form.
              const double B = std::pow(1 - NoV, 5) * 0.5, A = 0.9 - 0.3 * r - B;
              const double sheen = layers.y > 0 ? 1 : 0;
              check.inputs.emplace_back(glm::vec3(around(NoV, 0.3)), metallic);
              check.inputs.emplace_back(glm::vec3(around(NoL, phi)), r);
              check.inputs.emplace_back(layers.x, layers.y, layers.z, layers.w);
              check.inputs.emplace_back(A, B, 0.9, 0.05);
              check.inputs.emplace_back(sheen * 0.4, sheen * 1.3, 0, 0);
            }
  check.twin = [models](CheckVectors in) {
    optics::Surface surface = layeredSurface({1, 0.5, float(0.1)}, in[0].w, in[1].w, in[2]);
    surface.models = models;
    // The shader has a grain, if of strength 0: Kulla and Conty's lobe is flat there, and is so where E is its mean.
    const double mean = 1 - optics::missingOnAverageFit(optics::alphaOf(surface));
    const optics::Albedos albedos{{in[3].x, in[3].y}, {in[3].z, in[3].w}, in[4].x, in[4].y, mean};
    const glm::dvec3 V = xyzOf(in[0]);
    const glm::dvec3 value = optics::evaluate(surface, albedos, {0, 0, 1}, V, xyzOf(in[1]));
    const optics::DistantWeights weights = optics::distantWeights(surface, albedos, V.z);
    const glm::dvec3 base = weights.prefiltered + weights.irradiance;
    return CheckValues{value.x, value.y, value.z, base.x, base.y, base.z};
  };
  check.observe = [](CheckVectors, CheckVectors out) {
    return CheckValues{out[0].x, out[0].y, out[0].z, out[1].x, out[1].y, out[1].z};
  };
  check.floor = 0.1;
  check.conditioning = [](CheckVectors in) {
    const double alpha = std::max(in[1].w * in[1].w, minAnalyticAlphaFloat);
    return 1 + 0.04 / alpha;
  };
  allow(check, 400,
        "sum of lobes of up to 60 roundings, cosines of large phases among them; H off by 2 epsilon, which D "
        "amplifies by 2 / alpha");
  return check;
}

Check checkLayersOfModels() {
  Check check = checkLayers("evaluateBsdf of all layers, Burley, exact Fresnel",
                            {.diffuse = optics::DiffuseModel::burley, .fresnel = optics::FresnelModel::exact});
  check.probe.defines.push_back({"DIFFUSE_MODEL", "1"});
  check.probe.defines.push_back({"FRESNEL_MODEL", "1"});
  return check;
}

// With a grain the lobe of further bounces is flat.
Check checkLayersOfEnergy() {
  Check check = checkLayers("evaluateBsdf of all layers, Kulla and Conty", {.energy = optics::EnergyModel::kullaConty});
  check.probe.defines.push_back({"ENERGY_MODEL", "3"});
  return check;
}

// Against the same 8 x 12 nodes in double precision, and against the integral that they stand for.
Check checkAnisotropicDfg(bool integral) {
  Check check =
      absoluteCheck(integral ? "dfgAnisotropic, against the integral" : "dfgAnisotropic", "anisotropy.glsl",
                    "out0.xy = dfgAnisotropic(in0.xyz, in1.xy);", {"V.x", "V.y", "V.z", "", "alpha.t", "alpha.b"}, 2);
  for (const double NoV : {0.0, 0.02, 0.3, 0.7, 1.0})
    for (const double phi : {0.0, 0.6, 1.57})
      for (const double r : {0.05, 0.3, 0.6, 1.0})
        for (const double strength : {0.0, 0.3, 0.7, 1.0}) {
          const optics::AnisotropicAlpha alpha = optics::alphaFromAnisotropy(r * r, strength);
          check.inputs.emplace_back(glm::vec3(around(NoV, phi)), 0);
          check.inputs.emplace_back(alpha.t, alpha.b, 0, 0);
        }
  check.clamped = "NoV >= 1e-4 (minNoV)";
  if (integral) {
    check.twin = [](CheckVectors in) {
      const optics::Dfg dfg = optics::integrateDfgAnisotropic(xyzOf(in[0]), {in[1].x, in[1].y});
      return CheckValues{dfg.A + dfg.B, dfg.B};
    };
    check.observe = [](CheckVectors, CheckVectors out) { return CheckValues{out[0].x + out[0].y, out[0].y}; };
    check.tolerance = 0.023;
    check.reason = "an approximation: 96 nodes where the integral has 4608: 0.015; A is raised by 0.008 on purpose";
    return check;
  }
  check.twin = [](CheckVectors in) {
    const optics::Dfg dfg = optics::integrateDfgAnisotropic(xyzOf(in[0]), {in[1].x, in[1].y}, 8, 12);
    return CheckValues{std::min(dfg.A + double(0.008f), std::max(1 - dfg.B, 0.0)), dfg.B};
  };
  check.conditioning = [](CheckVectors in) { return 64 + 4 / std::max(in[0].z, minNoVFloat); };
  allow(check, 1, "some 60 roundings of each of 96 nodes, sin and cos the driver's; 1 / NoV of V_GGX");
  return check;
}

}  // namespace

std::vector<Check> layeredChecks() {
  return {checkLayers("evaluateBsdf of all layers"), checkLayersOfModels(), checkLayersOfEnergy(),
          checkAnisotropicDfg(false), checkAnisotropicDfg(true)};
}

}  // namespace facet::selftest
