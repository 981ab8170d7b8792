#include "optics/diffuse.hpp"
#include "optics/fresnel.hpp"
#include "optics/ndf.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

const Axis cosines = {0, 1e-7, 1e-4, 1e-3, 0.02, 0.1428571, 0.5, 0.9, 1 - 1e-6, 1};
const Axis roughnesses = {0, 1e-3, 0.05, 0.3, 0.7, 1};
const Axis lobeAlphas = {1e-3, 3e-3, 0.03, 0.3, 1};

// ---- fresnel.glsl ---------------------------------------------------------------------------------------------------

Check checkF0FromIor() {
  Check check = absoluteCheck("f0FromIor", "fresnel.glsl", "out0.x = f0FromIor(in0.x);", {"ior"});
  check.inputs = grid({0, 1e-3, 0.7, 1, 1 + 1e-6, 1.31, 1.5, 2.42, 50, 1e6, 1e18});
  check.twin = [](CheckVectors in) { return CheckValues{optics::f0FromIor(in[0].x)}; };
  allow(check, 4, "4 roundings of numbers up to 1");
  return check;
}

Check checkIorFromF0() {
  Check check = relativeCheck("iorFromF0", "fresnel.glsl", "out0.x = iorFromF0(in0.x);", {"f0"});
  check.inputs = grid({-0.1, 0, 1e-12, 0.02, 0.04, 0.5, 0.9, 0.999, 1 - 1e-5, 1, 1.1});
  check.twin = [](CheckVectors in) { return CheckValues{optics::iorFromF0(in[0].x)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    return 6 + 2 / std::max(1 - std::sqrt(std::clamp(in[0].x, 0.0, 1.0)), 1e-7);
  };
  check.reason = "1 - sqrt(f0) cancels as f0 nears 1";
  return check;
}

Check checkDielectric() {
  Check check = absoluteCheck("F_Dielectric", "fresnel.glsl", "out0.x = F_Dielectric(in0.x, in0.y);", {"VoH", "eta"});
  check.inputs = grid(cosines, {-1, 0, 1e-6, 0.4, 1 / 1.5, 0.99, 1, 1 + 1e-6, 1.01, 1.33, 1.5, 2.42, 50, 1e6});
  for (double eta : {0.5, 1 / 1.5, 0.9})  // about the critical angle
    for (double off : {-1e-3, -1e-6, 1e-6, 1e-4, 1e-2})
      check.inputs.emplace_back(std::sqrt(1 - eta * eta) + off, eta, 0, 0);
  check.twin = [](CheckVectors in) { return CheckValues{optics::F_Dielectric(in[0].x, in[0].y)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    const double eta = in[0].y, c2 = in[0].x * in[0].x, g2 = std::abs((eta - 1) * (eta + 1) + c2);
    const double parts = c2 > 0.5 ? eta * eta + 1 - c2 : std::abs(eta * eta - 1) + c2;
    return 8 + 4 * std::sqrt(parts / std::max({g2, parts * floatEpsilon, 1e-30}));
  };
  check.reason = "g = sqrt(eta^2 - 1 + c^2) cancels near the critical angle and where eta nears 1 at the horizon";
  return check;
}

Check checkConductor() {
  Check check = absoluteCheck("F_Conductor", "fresnel.glsl",
                              "out0.rgb = F_Conductor(in0.x, vec3(in0.y, 1.5, 0.2), vec3(in0.z, 0.0, 3.0));",
                              {"VoH", "eta", "k"});
  check.inputs = grid(cosines, {0.05, 0.5, 1, 1.5, 3, 1e3, 1e4}, {0, 1e-3, 0.5, 3, 1e3, 1e4});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::F_Conductor(in[0].x, {in[0].y, 1.5, double(0.2f)}, {in[0].z, 0, 3}));
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    const double eta = in[0].y, k = in[0].z, c2 = in[0].x * in[0].x, real = (eta - k) * (eta + k) - (1 - c2);
    const double parts = c2 > 0.5 ? eta * eta + k * k + 1 - c2 : std::abs(eta * eta - 1) + k * k + c2;
    return 16 + 8 * parts / std::max(std::hypot(real, 2 * eta * k), 1e-4 * parts);
  };
  check.reason = "16 roundings; eta^2 - k^2 - sin^2 cancels";
  return check;
}

Check check82Tint() {
  Check check = absoluteCheck("F_82Tint", "fresnel.glsl", "out0.rgb = F_82Tint(in0.x, in0.yyy, vec3(in0.z, 1.0, 0.0));",
                              {"VoH", "f0", "tint"});
  check.inputs = grid(cosines, {0, 0.04, 0.5, 0.95, 1}, {0, 0.3, 0.9, 1});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::F_82Tint(in[0].x, glm::dvec3(in[0].y), {in[0].z, 1, 0}));
  };
  allow(check, 12, "12 roundings of numbers up to 1");
  return check;
}

// ---- diffuse.glsl ---------------------------------------------------------------------------------------------------

// NoV, NoL, VoL, roughness; VoL of three azimuths.
std::vector<glm::vec4> diffuseInputs() {
  std::vector<glm::vec4> inputs;
  for (double NoV : {0.0, 1e-4, 0.02, 0.5, 0.95, 1.0})
    for (double NoL : {0.0, 1e-5, 1e-3, 0.1, 0.7, 1.0})
      for (double phi : {0.0, 1.2, pi})
        for (double r : roughnesses) {
          const double VoL = glm::dot(around(NoV, 0), around(NoL, phi));
          inputs.emplace_back(NoV, NoL, std::clamp(VoL, -1.0, 1.0), r);
        }
  return inputs;
}

Check checkDiffuse(const std::string& function, const std::string& extra, double tolerance, const std::string& reason,
                   double (*twin)(const optics::DiffuseAngles&, double r)) {
  Check check =
      absoluteCheck(function, "diffuse.glsl", "out0.x = " + function + "(in0.x, in0.y, in0.z, in0.w" + extra + ";",
                    {"NoV", "NoL", "VoL", "perceptualRoughness"});
  check.inputs = diffuseInputs();
  check.twin = [twin](CheckVectors in) { return CheckValues{twin({in[0].x, in[0].y, in[0].z}, in[0].w)}; };
  allow(check, tolerance, reason);
  return check;
}

// VoL - NoV NoL over the larger cosine.
double lobeConditioning(CheckVectors in) { return 1 + 0.5 / std::max({in[0].x, in[0].y, 1e-6}); }

Check checkFujii() {
  Check check = absoluteCheck("albedoFujii", "diffuse.glsl", "out0.x = albedoFujii(in0.x, in0.y);", {"NoX", "r"});
  check.inputs = grid(cosines, roughnesses);
  check.twin = [](CheckVectors in) { return CheckValues{optics::albedoFujii(in[0].x, in[0].y)}; };
  check.tolerance = 1e-4;
  check.reason = "acos is the driver's: GLSL leaves its precision open, Mesa's polynomial is good to 7e-5";
  return check;
}

// ---- ndf.glsl -------------------------------------------------------------------------------------------------------

// Over the peak, so that the error of a narrow lobe's foot counts as little as it matters.
Check checkDistribution(const std::string& function, double (*twin)(double sin2NoH, double alpha)) {
  Check check = absoluteCheck(function, "ndf.glsl", "out0.x = " + function + "(vec3(0.0, 0.0, 1.0), in0.xyz, in0.w);",
                              {"H.x", "H.y", "H.z", "alpha"});
  for (double alpha : lobeAlphas) {
    for (double sine : {0.0, 1e-7, 0.1 * alpha, alpha, 3 * alpha, 0.5, 0.99})
      if (sine < 1) check.inputs.emplace_back(glm::vec3(around(std::sqrt((1 - sine) * (1 + sine)), 0.7)), alpha);
    for (double cosine : {1e-3, 0.0, -0.2, -1.0}) check.inputs.emplace_back(glm::vec3(around(cosine, 2)), alpha);
  }
  check.twin = [twin](CheckVectors in) {
    const glm::dvec3 H = xyzOf(in[0]);
    const double lengths2 = glm::dot(H, H), alpha = in[0].w;
    return CheckValues{H.z > 0 ? twin((H.x * H.x + H.y * H.y) / lengths2, alpha) * pi * alpha * alpha : 0};
  };
  check.observe = [](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x * pi * in[0].w * in[0].w}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 16 + 4 / in[0].w; };
  check.reason = "of D / peak: 16 roundings; |N x H| is off by 2 epsilon, which the exponent amplifies by 2 / alpha";
  return check;
}

Check checkVisibility(const std::string& function, double (*twin)(double NoV, double NoL, double alpha),
                      double epsilons, const std::string& reason) {
  Check check =
      relativeCheck(function, "ndf.glsl", "out0.x = " + function + "(in0.x, in0.y, in0.z);", {"NoV", "NoL", "alpha"});
  check.inputs = grid({minNoVFloat, 1e-3, 0.02, 0.5, 1}, {1e-4, 1e-2, 0.3, 1 - 1e-6, 1}, lobeAlphas);
  check.twin = [twin](CheckVectors in) { return CheckValues{twin(in[0].x, in[0].y, in[0].z)}; };
  allow(check, epsilons, reason);
  return check;
}

Check checkCavity() {
  Check check = relativeCheck("V_Cavity", "ndf.glsl", "out0.x = V_Cavity(in0.x, in0.y, in0.z, in0.w);",
                              {"NoV", "NoL", "NoH", "VoH"});
  check.inputs = grid({1e-3, 0.1, 0.6, 1}, {1e-3, 0.02, 0.4, 1}, {-0.1, 0, 0.01, 0.6, 1}, {1e-3, 0.1, 0.7, 1});
  check.twin = [](CheckVectors in) {
    return CheckValues{optics::V_Cavity({glm::dvec3(0), in[0].x, in[0].y, in[0].z, in[0].w, 0})};
  };
  allow(check, 8, "8 roundings, nothing cancels");
  check.clamped = "NoV NoL >= 2.5e-7, VoH max(NoV, NoL) >= 5e-7";
  return check;
}

}  // namespace

std::vector<Check> modelChecks() {
  Check orenNayar = checkDiffuse(
      "Fd_OrenNayar", ")", 8, "8 roundings; VoL - NoV NoL is off by half an epsilon, over the larger cosine",
      [](const optics::DiffuseAngles& a, double r) { return optics::Fd_OrenNayar(a, optics::sigmaOrenNayar(r)); });
  orenNayar.conditioning = lobeConditioning;
  Check eon = checkDiffuse("Fd_Eon", ", vec3(0.8)).x", 1e-4 / floatEpsilon,
                           "acos as in albedoFujii; VoL - NoV NoL is off by half an epsilon, over the larger cosine",
                           [](const optics::DiffuseAngles& a, double r) { return optics::Fd_Eon(a, r, 0.8f); });
  eon.conditioning = [](CheckVectors in) { return 1 + 1e-3 * lobeConditioning(in); };
  return {
      checkF0FromIor(),
      checkIorFromF0(),
      checkDielectric(),
      checkConductor(),
      check82Tint(),
      checkDiffuse("Fd_Burley", ")", 16, "16 roundings of numbers up to 2", optics::Fd_Burley),
      checkDiffuse("Fd_Frostbite", ")", 16, "16 roundings of numbers up to 2", optics::Fd_Frostbite),
      orenNayar,
      checkFujii(),
      eon,
      checkDiffuse("Fd_CallOfDuty", ")", 256,
                   "log2 and exp2 are the driver's; the coefficients are as large as 59 and cancel; NoH is a quotient",
                   optics::Fd_CallOfDuty),
      checkDistribution("D_Beckmann", optics::D_BeckmannFromSin2),
      checkDistribution("D_Blinn", optics::D_BlinnFromSin2),
      checkVisibility("V_BeckmannCorrelated", optics::V_BeckmannCorrelated, 32,
                      "erfc is a fit with an error of 1.5e-7"),
      checkVisibility("V_SchlickGGX", optics::V_SchlickGGX, 12, "12 roundings, nothing cancels"),
      checkVisibility("V_SchlickRemapped", optics::V_SchlickRemapped, 16, "16 roundings, nothing cancels"),
      checkCavity(),
  };
}

}  // namespace facet::selftest
