#include <cmath>

#include "optics/bsdf.hpp"
#include "optics/fresnel.hpp"
#include "optics/models.hpp"
#include "optics/ndf.hpp"
#include "optics/presets.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::DiffuseModel;
using optics::EnergyModel;
using optics::FresnelModel;
using optics::Masking;
using optics::NormalDistribution;
using shading::Define;

// ---- diffuse_albedo.glsl --------------------------------------------------------------------------------------------

Check checkAlbedo(const std::string& function, DiffuseModel model, double tolerance, const std::string& reason) {
  const bool eon = model == DiffuseModel::eon;
  Check check =
      absoluteCheck(function, "diffuse_albedo.glsl",
                    "out0.x = " + function + (eon ? "(in0.x, in0.y, vec3(0.8)).x;" : "(in0.x, in0.y);"), {"NoV", "r"});
  check.inputs = grid({0, 1e-4, 0.02, 0.2, 0.5, 0.8, 1}, {0, 0.3, 0.6, 1});
  check.twin = [model](CheckVectors in) {
    return CheckValues{optics::diffuseReturned(model, in[0].x, in[0].y, glm::dvec3(0.8f)).x /
                       (model == DiffuseModel::eon ? 1 : double(0.8f))};
  };
  check.tolerance = tolerance;
  check.reason = reason;
  return check;
}

// ---- ndf.glsl -------------------------------------------------------------------------------------------------------

Check checkBeckmannRational() {
  Check check = relativeCheck("V_BeckmannRational", "ndf.glsl", "out0.x = V_BeckmannRational(in0.x, in0.y, in0.z);",
                              {"NoV", "NoL", "alpha"});
  check.inputs = grid({minNoVFloat, 1e-3, 0.02, 0.5, 1}, {1e-4, 1e-2, 0.3, 1 - 1e-6, 1}, {1e-3, 3e-3, 0.03, 0.3, 1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::V_BeckmannRational(in[0].x, in[0].y, in[0].z)}; };
  allow(check, 64, "24 roundings; its two branches meet within 1e-6");
  return check;
}

// ---- energy.glsl ----------------------------------------------------------------------------------------------------

Check checkMissingOnAverage() {
  Check check = relativeCheck("missingOnAverage", "energy.glsl", "out0.x = missingOnAverage(in0.x);", {"alpha"});
  check.inputs = grid({0, 1e-4, 1e-3, 0.01, 0.1, 0.3, 0.7, 1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::missingOnAverageFit(in[0].x)}; };
  allow(check, 32, "12 roundings; log is the driver's. The fit's own error is tested in tests/optics/energy_test.cpp");
  check.clamped = "alpha >= 1e-3";
  return check;
}

Check checkKullaConty() {
  Check check = absoluteCheck("multipleScatterKullaConty", "energy.glsl",
                              "out0.x = multipleScatterKullaConty(in0.xxx, in0.y, in0.zw, missingOnAverage(0.5)).x;",
                              {"f0", "f90", "A", "B"});
  check.inputs = grid({0, 0.04, 0.5, 1}, {0, 1}, {0.1, 0.6, 0.9}, {0, 0.1, 0.1005});
  check.twin = [](CheckVectors in) {
    const optics::Dfg dfg{in[0].z, in[0].w};
    return CheckValues{
        optics::compensationOf(EnergyModel::kullaConty, dfg, 0.5, glm::dvec3(in[0].x), in[0].y).multiple.x};
  };
  allow(check, 32, "20 roundings of numbers up to 1; log is the driver's");
  return check;
}

Check checkKullaContyShape() {
  Check check = absoluteCheck("multipleShapeKullaConty", "energy.glsl",
                              "out0.x = multipleShapeKullaConty(in0.x, missingOnAverage(in0.y));", {"E(L)", "alpha"});
  check.inputs = grid({0, 0.3, 0.9, 0.9995, 1, 1.0005}, {0, 1e-3, 0.01, 0.1, 0.5, 1});
  check.twin = [](CheckVectors in) {
    return CheckValues{optics::multipleShape(EnergyModel::kullaConty, in[0].x, in[0].y)};
  };
  allow(check, 32, "of 1 / (1 - Eavg), at most 91: 16 roundings; log is the driver's");
  check.conditioning = [](CheckVectors in) { return 1 / std::max(optics::missingOnAverageFit(in[0].y), 0.011); };
  return check;
}

// ---- models.glsl ----------------------------------------------------------------------------------------------------

const optics::MetalPreset& gold() { return *optics::findMetal("gold"); }

std::string vec3Of(const glm::dvec3& v) {
  return "vec3(" + std::to_string(v.x) + ", " + std::to_string(v.y) + ", " + std::to_string(v.z) + ")";
}

std::vector<Define> definesOf(const optics::Models& models) {
  std::vector<Define> defines;
  const auto add = [&](const char* name, int value) {
    if (value != 0) defines.push_back({name, std::to_string(value)});
  };
  add("DIFFUSE_MODEL", static_cast<int>(models.diffuse));
  add("FRESNEL_MODEL", static_cast<int>(models.fresnel));
  add("NDF_MODEL", static_cast<int>(models.distribution));
  add("MASKING_MODEL", static_cast<int>(models.masking));
  add("ENERGY_MODEL", static_cast<int>(models.energy));
  if (models.fresnel == FresnelModel::schlick) return defines;
  defines.push_back({"CONDUCTOR_F0", vec3Of(gold().f0())});
  defines.push_back({"CONDUCTOR_ETA", vec3Of(gold().eta)});
  defines.push_back({"CONDUCTOR_K", vec3Of(gold().k)});
  defines.push_back({"CONDUCTOR_TINT", vec3Of(optics::tintFromF82(gold().f0(), gold().f82()))});
  return defines;
}

// The whole BSDF with other models; the table's entry stands for whatever the lobe has there.
Check checkModel(const std::string& name, const optics::Models& models, double tolerance, const std::string& reason) {
  Check check = relativeCheck("evaluateBsdf, " + name, "bsdf.glsl",
                              "Surface s = makeSurface(vec3(0.0, 0.0, 1.0), in0.xyz, vec3(0.9, 0.5, 0.1), in1.w, "
                              "in0.w, 1.0);\n"
                              "s.dfg = vec3(0.75, 0.125, 0.0);\n"
                              "#if ENERGY_MODEL == ENERGY_KULLA_CONTY\n"
                              "s.albedoL = 0.75;\n"
                              "#endif\n"
                              "out0.rgb = evaluateBsdf(s, in1.xyz);",
                              {"V.x", "V.y", "V.z", "perceptualRoughness", "L.x", "L.y", "L.z", "metallic"});
  check.probe.inputs = 2;
  check.probe.defines = definesOf(models);
  for (double NoV : {1.0, 0.7, 0.1, 1e-3})
    for (double NoL : {1.0, 0.6, 0.05, 1e-3, -0.1})
      for (double phi : {0.0, 1.4, 3.0})
        for (double r : {0.2, 0.5, 1.0})
          for (double metallic : {0.0, 0.5, 1.0}) {
            check.inputs.emplace_back(glm::vec3(around(NoV, 0)), r);
            check.inputs.emplace_back(glm::vec3(around(NoL, phi)), metallic);
          }
  check.twin = [models](CheckVectors in) {
    static const optics::Conductor conductor = {gold().eta, gold().k};
    optics::Surface surface{{double(0.9f), 0.5, double(0.1f)}, in[1].w, in[0].w, glm::dvec3(double(0.04f))};
    surface.models = models;
    surface.conductor = &conductor;
    const optics::Reflected f = reflect(surface, {0.75, 0.125}, {0, 0, 1}, xyzOf(in[0]), xyzOf(in[1]), 0.75);
    return valuesOf(f.specular + f.diffuse);
  };
  check.floor = 1e-6;  // Gaussian tails
  check.tolerance = tolerance;
  check.reason = reason;
  return check;
}

// What distant light is weighted with: LD in x, irradiance in y.
Check checkDistant(const std::string& name, EnergyModel energy) {
  Check check = absoluteCheck("irradianceAlbedo, " + name, "bsdf.glsl",
                              "Surface s = makeSurface(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), in0.xxx, in0.y, 0.75, "
                              "1.0);\n"
                              "s.dfg = vec3(in0.zw, 0.0);\n"
                              "out0.xy = vec2(prefilteredAlbedo(s).x, irradianceAlbedo(s).x);",
                              {"baseColor", "metallic", "A", "B"});
  check.probe.defines = definesOf({.energy = energy});
  check.inputs = grid({0, 0.04, 0.5, 1}, {0, 0.5, 1}, {0.3, 0.6, 0.9}, {0, 0.1, 0.1005});
  check.twin = [energy](CheckVectors in) {
    optics::Surface surface{glm::dvec3(in[0].x), in[0].y, 0.75};
    surface.models.energy = energy;
    const optics::DistantWeights weights = optics::distantWeights(surface, {in[0].z, in[0].w});
    return CheckValues{weights.prefiltered.x, weights.irradiance.x};
  };
  check.observe = [](CheckVectors, CheckVectors out) { return CheckValues{out[0].x, out[0].y}; };
  allow(check, 32, "24 roundings of numbers up to 3");
  return check;
}

}  // namespace

std::vector<Check> choiceChecks() {
  const char* const exact = "the shader's closed form against a quadrature, which is good to 1e-6";
  const char* const lobes = "about 100 roundings; |N x H| is off by 2 epsilon, over alpha = 0.04";
  return {
      checkAlbedo("albedoBurley", DiffuseModel::burley, 4e-6, exact),
      checkAlbedo("albedoFrostbite", DiffuseModel::frostbite, 4e-6, exact),
      checkAlbedo("albedoOrenNayar", DiffuseModel::orenNayar, 4e-5, "acos is the driver's, good to 7e-5 on Mesa"),
      checkAlbedo("albedoEon", DiffuseModel::eon, 1e-4, "acos is the driver's, good to 7e-5 on Mesa"),
      checkAlbedo("albedoCallOfDuty", DiffuseModel::callOfDuty, 5e-3, "the shader takes 16 samples"),
      checkBeckmannRational(),
      checkModel("Burley", {.diffuse = DiffuseModel::burley}, 3e-5, lobes),
      checkModel("Frostbite", {.diffuse = DiffuseModel::frostbite}, 3e-5, lobes),
      checkModel("Oren-Nayar", {.diffuse = DiffuseModel::orenNayar}, 3e-4,
                 "VoL - NoV NoL is off by an epsilon, over the larger cosine, 1e-3 at least"),
      checkModel("EON", {.diffuse = DiffuseModel::eon}, 3e-4, "as Oren-Nayar; acos is the driver's"),
      checkModel("Call of Duty", {.diffuse = DiffuseModel::callOfDuty}, 1e-4, "log2 and exp2 are the driver's"),
      checkModel("exact Fresnel", {.fresnel = FresnelModel::exact}, 3e-5, lobes),
      checkModel("F82-tint", {.fresnel = FresnelModel::f82Tint}, 3e-5, lobes),
      checkModel("Beckmann", {.distribution = NormalDistribution::beckmann}, 1e-4,
                 "down to 1e-6 the exponent, up to 14 + tan^2 / alpha^2's conditioning, takes part"),
      checkModel("Blinn", {.distribution = NormalDistribution::blinn}, 1e-4, "as Beckmann"),
      checkModel("approximate masking", {.masking = Masking::approximate}, 3e-5, lobes),
      checkModel("V-cavities", {.masking = Masking::cavity}, 3e-5, lobes),
      checkModel("remapped masking", {.masking = Masking::remapped}, 3e-5, lobes),
      checkMissingOnAverage(),
      checkKullaConty(),
      checkKullaContyShape(),
      checkModel("single scattering", {.energy = EnergyModel::none}, 3e-5, lobes),
      checkModel("Fdez-Aguera", {.energy = EnergyModel::fdezAguera}, 3e-5, lobes),
      checkModel("Kulla and Conty", {.energy = EnergyModel::kullaConty}, 3e-5, lobes),
      checkModel("Turquin", {.energy = EnergyModel::turquin}, 3e-5, lobes),
      checkDistant("single scattering", EnergyModel::none),
      checkDistant("Fdez-Aguera", EnergyModel::fdezAguera),
      checkDistant("Kulla and Conty", EnergyModel::kullaConty),
      checkDistant("Turquin", EnergyModel::turquin),
  };
}

}  // namespace facet::selftest
