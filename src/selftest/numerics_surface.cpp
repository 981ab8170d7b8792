#include <algorithm>
#include <cmath>
#include <map>

#include "constants.h"
#include "optics/alpha_mask.hpp"
#include "optics/bent_normal.hpp"
#include "optics/bsdf.hpp"
#include "optics/diffuse.hpp"
#include "optics/footprint.hpp"
#include "optics/fresnel.hpp"
#include "optics/normal_spread.hpp"
#include "optics/quadrature.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

constexpr double minAnalyticAlpha = layout::minAnalyticAlpha, minNoV = layout::minNoV;

const double alphas[] = {0, 1e-3, 2e-3, 1e-2, 0.1, 0.5, 1};
const double perceptualRoughnesses[] = {0, 0.03, 0.1, 0.5, 1};
const double f0s[] = {0, 0.04, 0.5, 1};

// Around N, at the angle whose sine and cosine are given.
glm::dvec3 tilted(const glm::dvec3& N, double sine, double cosine, double phi) {
  const glm::dvec3 T = glm::normalize(glm::cross(std::abs(N.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0), N));
  return sine * (std::cos(phi) * T + std::sin(phi) * glm::cross(N, T)) + cosine * N;
}
glm::dvec3 tiltedByCosine(const glm::dvec3& N, double cosine, double phi) {
  return tilted(N, std::sqrt((1 - cosine) * (1 + cosine)), cosine, phi);
}

// Along an axis dot products are exact, so that a cosine may be 0; the other one rounds.
const glm::dvec3 normals[] = {{0, 0, 1}, glm::normalize(glm::dvec3(0.3, -0.5, 0.81))};
bool isAxis(const glm::dvec3& N) { return N.z == 1; }

Check checkD() {
  Check check{
      "D_GGX", {{"microfacet.glsl"}, "out0.x = D_GGX(in0.xyz, in1.xyz, max(in0.w, minAnalyticAlpha));", 2}, {}, {}};
  check.inputNames = {"N.x", "N.y", "N.z", "alpha", "H.x", "H.y", "H.z"};
  for (const glm::dvec3& N : normals)
    for (double alpha : alphas) {
      const auto add = [&](const glm::dvec3& H) {
        check.inputs.emplace_back(glm::vec3(N), alpha);
        check.inputs.emplace_back(glm::vec3(H), 0);
      };
      for (double phi : {0.3, 2.0, 5.0}) {
        for (double sine : {0.0, 1e-7, 3e-4, 0.1 * alpha, alpha, 10 * alpha, 0.1, 0.5, 0.99})
          if (sine < 1) add(tilted(N, sine, std::sqrt((1 - sine) * (1 + sine)), phi));
        for (double cosine : {1 - 1e-7, 0.01, -0.01, -0.5, -1.0}) add(tiltedByCosine(N, cosine, phi));
      }
      if (isAxis(N)) add({1, 0, 0});
    }
  check.twin = [](CheckVectors in) {
    return CheckValues{optics::D_GGX(xyzOf(in[0]), xyzOf(in[1]), std::max(in[0].w, minAnalyticAlpha))};
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 16 + 4 / std::max(in[0].w, minAnalyticAlpha); };
  check.reason = "16 roundings, and |N x H| is off by up to 2 epsilon: D changes by 2 / alpha times that";
  check.clamped = "alpha >= 1e-3 (minAnalyticAlpha)";
  return check;
}

Check checkV() {
  Check check{"V_SmithGGXCorrelated",
              {{"microfacet.glsl"},
               "out0.x = V_SmithGGXCorrelated(clamp(in0.x, minNoV, 1.0), in0.y, max(in0.z, minAnalyticAlpha));"},
              {"NoV", "NoL", "alpha"},
              {}};
  for (double alpha : alphas)
    for (double NoV : {-0.3, 0.0, 1e-4, 1e-3, 0.02, 0.5, 1.0})
      for (double NoL : {0.0, 1e-30, 1e-7, 1e-4, 0.02, 0.5, 1.0}) check.inputs.emplace_back(NoV, NoL, alpha, 0);
  check.twin = [](CheckVectors in) {
    return CheckValues{
        optics::V_SmithGGXCorrelated(std::clamp(in[0].x, minNoV, 1.0), in[0].y, std::max(in[0].z, minAnalyticAlpha))};
  };
  check.tolerance = 16 * floatEpsilon;
  check.reason = "16 roundings, nothing cancels";
  check.clamped = "NoV >= 1e-4 (minNoV), alpha >= 1e-3 (minAnalyticAlpha)";
  return check;
}

Check checkG1() {
  Check check{"G1_GGX", {{"microfacet.glsl"}, "out0.x = G1_GGX(in0.x, in0.y);"}, {"NoX", "alpha"}, {}};
  for (double alpha : {1e-6, 1e-3, 1e-2, 0.1, 0.5, 1.0})
    for (double NoX : {0.0, 1e-6, 1e-4, 1e-3, 0.02, 0.5, 1.0}) check.inputs.emplace_back(NoX, alpha, 0, 0);
  check.twin = [](CheckVectors in) { return CheckValues{optics::G1_GGX(in[0].x, in[0].y)}; };
  check.tolerance = 12 * floatEpsilon;
  check.reason = "12 roundings, nothing cancels; alpha >= 1e-6 is all that the table's pass asks for";
  return check;
}

Check checkF() {
  Check check{"F_Schlick",
              {{"fresnel.glsl"}, "out0.rgb = F_Schlick(in0.x, vec3(in0.y, 0.04, 1.0), in0.z);"},
              {"VoH", "f0", "f90"},
              {}};
  for (double f90 : {0.0, 1.0})
    for (double f0 : f0s)
      for (double VoH : {-0.1, 0.0, 1e-7, 1e-3, 0.1, 0.5, 0.9, 0.999, 1 - 1e-7, 1.0, 1 + 1e-6})
        check.inputs.emplace_back(VoH, f0, f90, 0);
  check.twin = [](CheckVectors in) {
    const glm::dvec3 F = optics::F_Schlick(in[0].x, glm::dvec3(in[0].y, float(0.04), 1), in[0].z);
    return CheckValues{F.x, F.y, F.z};
  };
  check.relative = false;
  check.tolerance = 8 * floatEpsilon;
  check.reason = "8 roundings of numbers up to 1";
  return check;
}

Check checkNormalSpread() {
  Check check{"roughnessOverPixel",
              {{"normal_spread.glsl"}, "out0.x = roughnessOverPixel(in0.x, in1.xyz, in1.w * in1.yzx);", 2},
              {"perceptual roughness", "-", "-", "-", "dNdx.x", "dNdx.y", "dNdx.z", "dNdy"},
              {}};
  for (const double r : perceptualRoughnesses)
    for (const double dx : {0.0, 1e-6, 1e-3, 0.05, 0.3, 2.0})
      for (const double dy : {0.0, 0.5, 1.0}) {
        check.inputs.emplace_back(r, 0, 0, 0);
        check.inputs.emplace_back(dx, -0.3 * dx, 0.1 * dx, dy);
      }
  check.twin = [](CheckVectors in) {
    const glm::dvec3 dx(in[1]);
    return CheckValues{optics::roughnessOverPixel(in[0].x, dx, in[1].w * glm::dvec3(dx.y, dx.z, dx.x))};
  };
  check.tolerance = 12 * floatEpsilon;
  check.reason = "12 roundings, nothing cancels";
  return check;
}

Check checkFootprintReads() {
  Check check{"footprintReads",
              {{"footprint.glsl"}, "out0.xy = footprintReads(in0.xy, in0.zw, in1.x);", 2},
              {"dx.u", "dx.v", "dy.u", "dy.v", "most stretch"},
              {}};
  // Away from where the number of reads changes. Lengths below a texel, huge ones and such that overflow are among
  // them.
  for (const double length : {0.0, 1e-8, 0.4, 1.0, 3.7, 900.0, 1e15})
    for (const double across : {0.0, 0.06, 0.15, 0.29, 0.7, 1.0})
      for (const double turn : {0.0, 0.3, 2.0})
        for (const double most : {1.0, 8.0}) {
          const glm::dvec2 dx = length * glm::dvec2(std::cos(turn), std::sin(turn));
          check.inputs.emplace_back(dx.x, dx.y, -across * dx.y, across * dx.x);
          check.inputs.emplace_back(most, 0, 0, 0);
          check.inputs.emplace_back(across * dx.x, across * dx.y, -dx.y, dx.x + 0.1 * dx.y);
          check.inputs.emplace_back(most, 0, 0, 0);
        }
  check.twin = [](CheckVectors in) {
    const glm::dvec4 d(in[0]);
    const optics::FootprintReads reads = optics::footprintReads({d.x, d.y}, {d.z, d.w}, in[1].x);
    return CheckValues{reads.count, reads.scale};
  };
  check.tolerance = 16 * floatEpsilon;
  check.reason = "8 roundings, and an area that cancels by half at most";
  return check;
}

Check checkMaskAlpha() {
  Check check{"maskAlpha", {{"alpha_mask.glsl"}, "out0.x = maskAlpha(in0.x, in0.y);"}, {"share", "pivot"}, {}};
  for (const double share : {0.0, 1e-6, 0.01, 0.25, 0.4999, 0.5, 0.50001, 0.7, 0.99, 1.0})
    for (const double pivot : {0.0, 0.1, 0.5, 0.77, 0.9, 1.0}) check.inputs.emplace_back(share, pivot, 0, 0);
  check.twin = [](CheckVectors in) { return CheckValues{optics::maskAlpha(in[0].x, in[0].y)}; };
  check.relative = false;
  check.tolerance = 4 * floatEpsilon;
  check.reason = "4 roundings of numbers up to 1";
  return check;
}

Check checkBentNormal() {
  Check check{"bentNormal",
              {{"bent_normal.glsl"}, "out0.xyz = bentNormal(in0.xyz, vec3(0.0, 0.0, 1.0), in1.xyz);", 2},
              {"N.x", "N.y", "N.z", "-", "V.x", "V.y", "V.z", "-"},
              {}};
  const auto direction = [](double theta, double phi) {
    return glm::vec4(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta), 0);
  };
  for (const double normal : {0.0, 0.3, 0.8, 1.3, 1.7, 2.5})
    for (const double view : {0.0, 0.5, 1.2, 1.5, 1.57})
      for (const double phi : {0.1, 1.7, 3.0}) {
        check.inputs.push_back(direction(normal, phi));
        check.inputs.push_back(direction(view, 0.4));
      }
  check.twin = [](CheckVectors in) {
    const glm::dvec3 N = optics::bentNormal(in[0], {0, 0, 1}, in[1]);
    return CheckValues{N.x, N.y, N.z};
  };
  check.tolerance = 64 * floatEpsilon;
  check.reason = "the mirror direction cancels near the surface";
  return check;
}

Check checkLambert() {
  Check check{"Fd_Lambert", {{"diffuse.glsl"}, "out0.x = Fd_Lambert();"}, {}, {glm::vec4(0)}};
  check.twin = [](CheckVectors) { return CheckValues{optics::Fd_Lambert()}; };
  check.tolerance = 2 * floatEpsilon;
  check.reason = "pi and the quotient are rounded";
  return check;
}

// f0 and pairs A, B as a table may hold them: a mirror's, a rough one's (A + B = 1 - ln 2 at least), and one that
// rounding to half floats put above 1.
std::vector<glm::vec4> energyInputs() {
  std::vector<glm::vec4> inputs;
  for (double f0 : f0s)
    for (const glm::dvec2 dfg :
         {glm::dvec2(1, 0), {0, 1}, {0.5, 0.5}, {0.99, 1e-4}, {0.307, 0}, {0.3, 1e-3}, {0.6, 0.2}, {0.9, 0.1005}})
      inputs.emplace_back(f0, dfg.x, dfg.y, 0);
  return inputs;
}

Check energyCheck(const std::string& function, double (*twin)(const optics::Dfg&, double f0)) {
  Check check{
      function, {{"energy.glsl"}, "out0.x = " + function + "(in0.xxx, in0.yz).x;"}, {"f0", "A", "B"}, energyInputs()};
  check.twin = [twin](CheckVectors in) { return CheckValues{twin({in[0].y, in[0].z}, in[0].x)}; };
  check.relative = false;
  check.tolerance = 16 * floatEpsilon;
  check.reason = "up to 16 roundings of numbers up to 3; 1 - (A + B) cancels, but counts as itself";
  return check;
}

// Of the surface that GLSL and C++ make of the inputs' w.
Check bsdfCheck(const std::string& name, const std::string& makeSurface, bool glossiness,
                optics::Surface (*surfaceOf)(CheckVectors)) {
  Check check{name,
              {{"bsdf.glsl"},
               "Surface s = " + makeSurface +
                   ";\n"
                   "s.dfg = in3.xyz;\n"
                   "out0.rgb = evaluateBsdf(s, in2.xyz);",
               4},
              {"N.x", "N.y", "N.z", glossiness ? "f0.g" : "metallic", "V.x", "V.y", "V.z",
               glossiness ? "glossiness" : "perceptualRoughness", "L.x", "L.y", "L.z", "baseColor.r", "A", "B"},
              {}};
  std::map<std::pair<double, double>, optics::Dfg> tables;
  const auto tableAt = [&](double NoV, double r) {
    const auto [entry, isNew] = tables.try_emplace({std::max(NoV, 0.0), r});
    if (isNew) entry->second = optics::integrateDfg(std::max(NoV, 0.0), r * r, 1e-6);
    return entry->second;
  };
  for (const glm::dvec3& N : normals)
    for (double NoV : {1.0, 0.7, 0.1, 1e-3, 0.0, -0.2}) {
      if (NoV == 0 && !isAxis(N)) continue;
      const glm::dvec3 V = tiltedByCosine(N, NoV, 0.4);
      std::vector<glm::dvec3> lights = {V, -V, tiltedByCosine(N, std::max(NoV, 1e-3), 0.4 + pi)};
      for (double NoL : {1.0, 0.6, 0.05, 1e-3, -0.1})
        for (double phi : {0.4, 1.4, 0.4 + 0.97 * pi}) lights.push_back(tiltedByCosine(N, NoL, phi));
      if (isAxis(N)) lights.emplace_back(0, 1, 0);
      for (const glm::dvec3& L : lights)
        for (double r : perceptualRoughnesses)
          for (double metallic : {0.0, 0.5, 1.0})
            for (double baseColor : {0.0, 0.8, 1.0}) {
              const optics::Dfg dfg = tableAt(NoV, r);
              check.inputs.insert(check.inputs.end(),
                                  {glm::vec4(glm::vec3(N), metallic), glm::vec4(glm::vec3(V), glossiness ? 1 - r : r),
                                   glm::vec4(glm::vec3(L), baseColor), glm::vec4(dfg.A, dfg.B, 0, 0)});
            }
    }
  check.twin = [surfaceOf](CheckVectors in) {
    optics::Angles angles = optics::anglesBetween(xyzOf(in[0]), xyzOf(in[1]), xyzOf(in[2]));
    angles.NoV = std::clamp(angles.NoV, minNoV, 1.0);
    angles.NoL = std::min(angles.NoL, 1.0);
    if (glm::length(xyzOf(in[1]) + xyzOf(in[2])) <= 1e-6) angles.NoH = 0;
    optics::Surface surface = surfaceOf(in);
    surface.perceptualRoughness = std::max(surface.perceptualRoughness, std::sqrt(minAnalyticAlpha));
    const optics::Reflected reflected = optics::reflect(surface, {in[3].x, in[3].y}, angles);
    const glm::dvec3 sum = reflected.specular + reflected.diffuse;
    return CheckValues{sum.x, sum.y, sum.z};
  };
  check.floor = 1e-2;
  check.tolerance = floatEpsilon;
  check.conditioning = [surfaceOf](CheckVectors in) {
    const double alpha = std::max(optics::alphaOf(surfaceOf(in)), minAnalyticAlpha);
    const double NoV = std::max(glm::dot(xyzOf(in[0]), xyzOf(in[1])), minNoV);
    const double NoL = std::max(glm::dot(xyzOf(in[0]), xyzOf(in[2])), 1e-4);
    const double sum = std::max(glm::length(xyzOf(in[1]) + xyzOf(in[2])), 1e-4);
    return 40 + 8 / (alpha * sum) + 4 / NoL + 4 / NoV;
  };
  check.reason =
      "40 roundings; H = (V + L) / |V + L| is off by 2 epsilon / |V + L|, which D amplifies by 2 / alpha; the cosines "
      "are "
      "off by an epsilon";
  check.clamped = "NoV to [1e-4, 1] (minNoV), alpha >= 1e-3 (minAnalyticAlpha); |V + L| <= 1e-6: no specular part";
  return check;
}

Check checkBsdf() {
  return bsdfCheck("evaluateBsdf", "makeSurface(in0.xyz, in1.xyz, vec3(in2.w, 0.5, 0.0), in0.w, in1.w, 1.0)", false,
                   [](CheckVectors in) {
                     return optics::Surface{{in[2].w, 0.5, 0}, in[0].w, in[1].w};
                   });
}

Check checkSpecularGlossiness() {
  return bsdfCheck(
      "makeSpecularGlossinessSurface",
      "makeSpecularGlossinessSurface(in0.xyz, in1.xyz, vec3(in2.w, 0.5, 0.0), vec4(0.25, in0.w, 0.0, in1.w), "
      "1.0)",
      true, [](CheckVectors in) {
        return optics::specularGlossinessSurface({in[2].w, 0.5, 0}, {0.25, in[0].w, 0}, in[1].w);
      });
}

Check checkIrradianceAlbedo() {
  Check check{"irradianceAlbedo",
              {{"bsdf.glsl"},
               "Surface s = makeSurface(vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, 1.0), in0.xxx, in0.y, 0.5, 1.0);\n"
               "s.dfg = vec3(in0.zw, 0.0);\n"
               "out0.x = irradianceAlbedo(s).x;"},
              {"baseColor", "metallic", "A", "B"}};
  for (const glm::vec4& in : energyInputs())
    for (double metallic : {0.0, 0.5, 1.0}) check.inputs.emplace_back(in.x, metallic, in.y, in.z);
  check.twin = [](CheckVectors in) {
    const optics::Surface surface{glm::dvec3(in[0].x), in[0].y, 0.5};
    return CheckValues{optics::distantWeights(surface, {in[0].z, in[0].w}).irradiance.x};
  };
  check.relative = false;
  check.tolerance = 16 * floatEpsilon;
  check.reason = "16 roundings of numbers up to 1";
  return check;
}

Check checkVisibleNormal() {
  Check check{"sampleVisibleNormal",
              {{"microfacet.glsl"}, "out0.xyz = sampleVisibleNormal(in0.xyz, in0.w, in1.xy);", 2},
              {"V.x", "V.y", "V.z", "alpha", "u.x", "u.y"}};
  for (double alpha : {1e-5, 1e-3, 0.1, 0.5, 1.0})
    for (double NoV : {minNoV, 0.02, 0.5, 1.0})
      for (uint32_t i = 0; i < 16; ++i) {
        check.inputs.emplace_back(glm::vec3(tiltedByCosine({0, 0, 1}, NoV, 0.7)), alpha);
        check.inputs.emplace_back(glm::vec2(optics::hammersley(i, 16)), 0, 0);
      }
  check.twin = [](CheckVectors in) {
    const glm::dvec3 H = optics::sampleVisibleGGX(xyzOf(in[0]), in[0].w, {in[1].x, in[1].y});
    return CheckValues{H.x, H.y, H.z};
  };
  check.relative = false;
  check.tolerance = 64 * floatEpsilon;
  check.reason =
      "32 roundings, and the precision of sin and cos is the driver's: 8e-6, far below the distance of samples";
  return check;
}

Check checkMeanDirection() {
  Check check{"specularMeanDirection",
              {{"image_light.glsl"},
               "Surface s = makeSurface(in0.xyz, in1.xyz, vec3(1.0), 1.0, 0.5, 1.0);\n"
               "s.dfg = vec3(1.0, 0.0, in0.w);\n"
               "out0.xyz = specularMeanDirection(s);",
               2},
              {"N.x", "N.y", "N.z", "tilt", "V.x", "V.y", "V.z"}};
  for (const glm::dvec3& N : normals)
    for (double NoV : {1.0, 1 - 1e-6, 0.9, 0.3, 1e-3, -0.2})
      for (double tilt : {0.0, 0.5, 1.0}) {  // from N to the mirror direction
        check.inputs.emplace_back(glm::vec3(N), tilt);
        check.inputs.emplace_back(glm::vec3(tiltedByCosine(N, NoV, 1.1)), 0);
      }
  check.twin = [](CheckVectors in) {
    const glm::dvec3 N = xyzOf(in[0]), mirror = glm::reflect(-xyzOf(in[1]), N), away = mirror - N * glm::dot(N, mirror);
    const double angle = std::asin(std::min(in[0].w * glm::length(away), 1.0));
    const glm::dvec3 d = std::cos(angle) * N + std::sin(angle) * away / std::max(glm::length(away), 1e-30);
    return CheckValues{d.x, d.y, d.z};
  };
  check.relative = false;
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) {
    const double sine = in[0].w * glm::length(glm::cross(xyzOf(in[0]), xyzOf(in[1])));
    return 8 + 4 / std::sqrt(std::max(1 - sine * sine, 4e-7));
  };
  check.reason = "8 roundings; the normal part is the root of 1 - sine^2, which cancels where the sine nears 1";
  return check;
}

}  // namespace

std::vector<Check> surfaceChecks() {
  return {
      checkD(),
      checkV(),
      checkG1(),
      checkF(),
      checkNormalSpread(),
      checkFootprintReads(),
      checkMaskAlpha(),
      checkBentNormal(),
      checkLambert(),
      energyCheck(
          "singleScatterAlbedo",
          [](const optics::Dfg& dfg, double f0) { return optics::energyFdezAguera(dfg, glm::dvec3(f0)).single.x; }),
      energyCheck(
          "multipleScatterAlbedo",
          [](const optics::Dfg& dfg, double f0) { return optics::energyFdezAguera(dfg, glm::dvec3(f0)).multiple.x; }),
      energyCheck("energyCompensation",
                  [](const optics::Dfg& dfg, double f0) { return optics::compensationTurquin(dfg, glm::dvec3(f0)).x; }),
      checkBsdf(),
      checkSpecularGlossiness(),
      checkIrradianceAlbedo(),
      checkVisibleNormal(),
      checkMeanDirection(),
  };
}

}  // namespace facet::selftest
