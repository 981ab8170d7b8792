#include <algorithm>
#include <cmath>

#include "ibl/layers.hpp"
#include "optics/color.hpp"
#include "optics/horizons.hpp"
#include "optics/lights.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "optics/zonal.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

// ---- lights.glsl ----------------------------------------------------------------------------------------------------

Check checkDistance() {
  Check check{"distanceAttenuation",
              {{"lights.glsl"}, "out0.x = distanceAttenuation(in0.x, in0.y);"},
              {"distance^2", "1 / range^2"},
              {}};
  for (double range : {0.0, 1e-3, 1.0, 10.0, 1e6})  // 0: none
    for (double distance : {0.0, 1e-9, 1e-6, 1e-3, 0.5, 0.999, 1.0, 1.001, 9.99, 1e3, 1e6, 1e15})
      check.inputs.emplace_back(distance * distance, range > 0 ? 1 / (range * range) : 0, 0, 0);
  // Times the squared distance: the window, which is what cancels near the end of the range.
  const auto inverse = [](double distance2) { return std::max(distance2, 1e-12); };
  check.twin = [=](CheckVectors in) {
    const double range = in[0].y > 0 ? 1 / std::sqrt(in[0].y) : 0;
    return CheckValues{optics::distanceAttenuation(std::sqrt(in[0].x), range) * inverse(in[0].x)};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x * inverse(in[0].x)}; };
  check.relative = false;
  check.tolerance = 8 * floatEpsilon;
  check.reason = "8 roundings of numbers up to 1; error of the value times the squared distance";
  check.clamped = "distance >= 1e-6 m";
  return check;
}

Check checkCone() {
  Check check{"coneAttenuation",
              {{"lights.glsl"}, "out0.x = coneAttenuation(in0.x, in0.y, in0.z);"},
              {"cos", "scale", "offset", "inner"},
              {}};
  for (const glm::dvec2 cone : {glm::dvec2(0, 0.02), {0, 0.785398}, {0.5, 0.50001}, {1.2, 1.570796}, {0, 1e-4}})
    for (double angle : {0.0, 0.5 * cone.x, cone.x, 0.5 * (cone.x + cone.y), cone.y, 1.001 * cone.y, 2.0, pi}) {
      const double width = 2 * std::sin((cone.y + cone.x) / 2) * std::sin((cone.y - cone.x) / 2);
      const double scale = 1 / std::max(width, 0.001);
      check.inputs.emplace_back(std::cos(angle), scale, -std::cos(cone.y) * scale, cone.x);
    }
  // From the angles that scale and offset stand for.
  check.twin = [](CheckVectors in) {
    const double cosOuter = std::clamp(-in[0].z / in[0].y, -1.0, 1.0), outer = std::acos(cosOuter);
    const double inner = std::acos(std::clamp(cosOuter + 1 / in[0].y, -1.0, 1.0));
    return CheckValues{optics::spotAttenuation(in[0].x, inner, outer)};
  };
  check.relative = false;
  check.tolerance = floatEpsilon;
  check.conditioning = [](CheckVectors in) { return 4 + 4 * in[0].y; };
  check.reason = "scale * cos + offset is the difference of two numbers as large as scale (at most 1000)";
  return check;
}

// ---- color.glsl -----------------------------------------------------------------------------------------------------

std::vector<glm::vec4> radiances() {
  std::vector<glm::vec4> inputs;
  for (double x : {0.0,  1e-42, 1e-38, 1e-10, 1e-6, 1e-4, 1e-3,  0.0031308, 0.01, 0.04, 0.08, 0.18, 0.5,
                   0.76, 0.8,   0.9,   1.0,   2.0,  11.2, 100.0, 65504.0,   1e6,  1e10, 1e15, 1e30})
    for (const glm::dvec3 tint :
         {glm::dvec3(1), {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0.5, 0.1}, {0.9, 1, 0.99}, {-1, 0.5, 1}})
      inputs.emplace_back(glm::vec3(x * tint), 0);
  return inputs;
}

Check checkSrgb() {
  Check check{"encodeSrgb", {{"color.glsl"}, "out0.rgb = encodeSrgb(in0.rgb);"}, {"r", "g", "b"}, radiances()};
  check.twin = [](CheckVectors in) { return valuesOf(optics::encodeSRGB(glm::clamp(xyzOf(in[0]), 0.0, 1.0))); };
  check.relative = false;
  check.tolerance = 64 * floatEpsilon;
  check.reason = "pow is exp2(y log2(x)), whose precision is the driver's; 64 epsilon are 1 / 500 of an 8-bit step";
  return check;
}

Check checkToneMapper(optics::ToneMapper mapper, const char* function, double tolerance, const char* reason) {
  Check check{function,
              {{"color.glsl"}, "out0.rgb = toneMap(" + std::to_string(static_cast<int>(mapper)) + ", in0.rgb);"},
              {"r", "g", "b"},
              radiances()};
  check.twin = [mapper](CheckVectors in) { return valuesOf(optics::toneMap(mapper, xyzOf(in[0]))); };
  check.relative = false;
  check.tolerance = tolerance;
  check.reason = reason;
  return check;
}

// ---- mapping.glsl ---------------------------------------------------------------------------------------------------

// Axes, both sides of the seam at -X, close to the poles, and points all over the sphere.
std::vector<glm::dvec3> directions() {
  std::vector<glm::dvec3> list;
  for (int axis = 0; axis < 3; ++axis)
    for (double sign : {1.0, -1.0}) {
      glm::dvec3 d(0);
      d[axis] = sign;
      list.push_back(d);
      for (double off : {1e-2, 1e-4, 1e-6, 1e-7, -1e-7, -1e-4}) {
        glm::dvec3 near = d;
        near[(axis + 1) % 3] = off;
        near[(axis + 2) % 3] = off / 3;
        list.push_back(glm::normalize(near));
      }
    }
  for (size_t i = 0; i < 200; ++i) list.push_back(optics::goldenSpiral(i, 200));
  return list;
}

std::vector<glm::vec4> directionInputs() {
  std::vector<glm::vec4> inputs;
  for (const glm::dvec3& d : directions()) inputs.emplace_back(glm::vec3(d), 0);
  return inputs;
}

// Where on the sphere a position of the map is, in radians: free of the seam, and of longitude at the poles.
CheckValues onSphere(double u, double v, double level) {
  return {level * std::cos(2 * pi * u), level * std::sin(2 * pi * u), pi * v};
}

Check checkToEquirect() {
  Check check{"equirectFromDirection",
              {{"mapping.glsl"}, "out0.xy = equirectFromDirection(in0.xyz);"},
              {"x", "y", "z"},
              directionInputs()};
  check.twin = [](CheckVectors in) {
    const glm::dvec2 uv = optics::equirectFromDirection(xyzOf(in[0]));
    return onSphere(uv.x, 1 - uv.y, std::hypot(in[0].x, in[0].z));
  };
  check.observe = [](CheckVectors in, CheckVectors out) {
    return onSphere(out[0].x, out[0].y, std::hypot(in[0].x, in[0].z));
  };
  check.relative = false;
  check.tolerance = 32 * floatEpsilon;
  check.reason = "angles up to pi, atan's precision is the driver's; 32 epsilon are 1 / 400 of a texel of a 4096 map";
  return check;
}

std::vector<glm::vec4> cubeInputs() {
  std::vector<glm::vec4> inputs;
  for (int face = 0; face < 6; ++face)
    for (double s : {-1.0, -0.999, -0.3, 0.0, 1e-7, 0.7, 1.0})
      for (double t : {-1.0, -0.6, 0.0, 0.2, 1.0}) inputs.emplace_back(face, s, t, 0);
  return inputs;
}

glm::dvec3 cubeDirection(const glm::dvec4& in) {
  return optics::directionFromCube({static_cast<int>(in.x), {(in.y + 1) / 2, (in.z + 1) / 2}});
}

Check checkFromCube() {
  Check check{"directionFromCube",
              {{"mapping.glsl"}, "out0.xyz = directionFromCube(int(in0.x), in0.yz);"},
              {"face", "s", "t"},
              cubeInputs()};
  check.twin = [](CheckVectors in) { return valuesOf(cubeDirection(in[0])); };
  check.observe = [](CheckVectors, CheckVectors out) { return valuesOf(glm::normalize(xyzOf(out[0]))); };
  check.relative = false;
  check.tolerance = 1e-12;
  check.reason = "only signs and places change";
  return check;
}

Check checkCubeDensity() {
  Check check{"cubeSolidAngleDensity",
              {{"mapping.glsl"}, "out0.x = cubeSolidAngleDensity(in0.yz);"},
              {"face", "s", "t"},
              cubeInputs()};
  // The cube of the direction's cosine to the face's axis.
  check.twin = [](CheckVectors in) {
    const glm::dvec3 d = glm::abs(cubeDirection(in[0]));
    return CheckValues{std::pow(std::max({d.x, d.y, d.z}), 3)};
  };
  check.tolerance = 8 * floatEpsilon;
  check.reason = "8 roundings, nothing cancels";
  return check;
}

Check checkCubeTexel() {
  Check check{"cubeTexelSolidAngle",
              {{"mapping.glsl"}, "out0.x = cubeTexelSolidAngle((in0.xy * 2.0 + 1.0) / in0.z - 1.0, in0.z);"},
              {"column", "row", "size"},
              {}};
  for (const int size : {8, 32, 256})
    for (const int column : {0, 1, size / 2, size - 1})
      for (const int row : {0, size / 3, size - 1}) check.inputs.emplace_back(column, row, size, 0);
  check.twin = [](CheckVectors in) {
    return CheckValues{
        optics::cubeTexelSolidAngle(static_cast<int>(in[0].x), static_cast<int>(in[0].y), static_cast<int>(in[0].z))};
  };
  check.tolerance = 2e-4;
  check.reason = "a series in the texel's size, cut after its square, at size 8";
  return check;
}

Check checkFrame() {
  Check check{
      "frameAround",
      {{"mapping.glsl"}, "mat3 m = frameAround(in0.xyz); out0.xyz = m[0]; out1.xyz = m[1]; out2.xyz = m[2];", 1, 3},
      {"n.x", "n.y", "n.z"},
      directionInputs()};
  check.inputs.emplace_back(1, 0, -0.0f, 0);
  // Unit columns, at right angles, right-handed, the last one n itself.
  check.twin = [](CheckVectors in) { return CheckValues{1, 1, 0, 0, 0, 1, in[0].x, in[0].y, in[0].z}; };
  check.observe = [](CheckVectors, CheckVectors out) {
    const glm::dvec3 x = xyzOf(out[0]), y = xyzOf(out[1]), z = xyzOf(out[2]);
    return CheckValues{glm::dot(x, x),
                       glm::dot(y, y),
                       glm::dot(x, y),
                       glm::dot(x, z),
                       glm::dot(y, z),
                       glm::dot(glm::cross(x, y), z),
                       z.x,
                       z.y,
                       z.z};
  };
  check.relative = false;
  check.tolerance = 8 * floatEpsilon;
  check.reason = "8 roundings of numbers up to 1; n is unit only to an epsilon";
  return check;
}

// ---- environment_layers.glsl ----------------------------------------------------------------------------------------

Check checkLayer() {
  Check check{"findLdLayer",
              {{"environment_layers.glsl"},
               "int layer; float weight;\n"
               "findLdLayer(in0.x, layer, weight);\n"
               "out0.xy = vec2(layer, weight);"},
              {"perceptualRoughness"},
              {}};
  for (int i = 0; i <= 200; ++i) check.inputs.emplace_back(i / 200.0, 0, 0, 0);
  for (const ibl::Layer& layer : ibl::layers)
    for (double off : {-1e-7, 1e-7}) check.inputs.emplace_back(layer.perceptualRoughness + off, 0, 0, 0);
  check.inputs.emplace_back(-3, 0, 0, 0);
  check.inputs.emplace_back(7, 0, 0, 0);
  // Layer and weight as one number, which is continuous; and whether the layer above exists.
  check.twin = [](CheckVectors in) {
    const double r = std::clamp(in[0].x, 0.0, 1.0);
    size_t i = 0;
    while (i + 2 < ibl::layers.size() && ibl::layers[i + 1].perceptualRoughness <= r) ++i;
    const auto alpha = [](double roughness) { return roughness * roughness; };
    const double low = alpha(ibl::layers[i].perceptualRoughness), high = alpha(ibl::layers[i + 1].perceptualRoughness);
    return CheckValues{static_cast<double>(i) + (alpha(r) - low) / (high - low), 1};
  };
  check.observe = [](CheckVectors, CheckVectors out) {
    const bool inside = out[0].x >= 0 && out[0].x <= static_cast<double>(ibl::layers.size()) - 2;
    return CheckValues{out[0].x + out[0].y, inside ? 1.0 : 0.0};
  };
  check.relative = false;
  check.tolerance = 32 * floatEpsilon;
  check.reason = "differences of alphas, 0.19 apart at 1, lose 3 bits";
  return check;
}

// ---- zonal.glsl -----------------------------------------------------------------------------------------------------

// From a cell that is a point to one that is a third of the sphere, across the horizon and at both ends.
Check zonalCheck(std::string name, const std::string& call) {
  Check check = relativeCheck(std::move(name), "zonal.glsl", "out0.x = " + call + ";", {"cos", "variance", "alpha"});
  check.inputs =
      grid({-1, -0.3, -0.01, -1e-6, 0, 1e-6, 0.01, 0.0999, 0.3, 0.7, 1}, {0, 1e-12, 1e-6, 0.003, 0.3}, {0.64, 1});
  // Near the lower end of the spread what is above the horizon cancels.
  check.conditioning = [](CheckVectors in) {
    const double halfWidth = std::sqrt(3 * in[0].y), above = in[0].x + halfWidth;
    return std::abs(in[0].x) < halfWidth ? 1 + halfWidth / above : 1;
  };
  allow(check, 16, "12 roundings, two of them of what cancels");
  return check;
}

Check checkSpreadCosine() {
  Check check = zonalCheck("spreadCosine", "spreadCosine(in0.x, in0.y)");
  check.twin = [](CheckVectors in) -> CheckValues { return {optics::spreadCosine(in[0].x, in[0].y)}; };
  return check;
}

Check checkSpreadKernel() {
  Check check = zonalCheck("spreadZonalKernel", "spreadZonalKernel(in0.x, in0.y, in0.z * in0.z)");
  check.twin = [](CheckVectors in) -> CheckValues { return {optics::spreadZonalKernel(in[0].x, in[0].y, in[0].z)}; };
  return check;
}

// ---- horizons.glsl --------------------------------------------------------------------------------------------------

Check checkOpenArc() {
  Check check =
      absoluteCheck("openArc", "horizons.glsl", "out0.x = openArc(keptHorizon(in0.x, in0.y), in0.y);", {"h", "n"});
  check.inputs = grid({-pi, -1.6, -0.5, -1e-4, 0, 0.3, 1.2, pi / 2, pi}, {-pi / 2, -1, -1e-4, 0, 0.7, pi / 2});
  check.twin = [](CheckVectors in) -> CheckValues {
    return {optics::openArc(optics::keptHorizon(in[0].x, in[0].y), in[0].y)};
  };
  allow(check, 16, "8 roundings; the precision of sin and cos is the driver's");
  return check;
}

Check checkInterreflection() {
  Check check = relativeCheck("interreflection", "horizons.glsl", "out0.xyz = interreflection(in0.x, in0.yzw);",
                              {"share", "r", "g", "b"});
  for (const double share : {1e-6, 1e-3, 0.1, 0.5, 0.9, 1.0})
    for (const double albedo : {0.0, 0.04, 0.5, 0.96, 1.0}) check.inputs.emplace_back(share, albedo, 1 - albedo, 0.5);
  check.twin = [](CheckVectors in) -> CheckValues {
    const glm::dvec3 gain = optics::interreflection(in[0].x, glm::dvec3(in[0].y, in[0].z, in[0].w));
    return {gain.x, gain.y, gain.z};
  };
  allow(check, 64, "a cubic whose terms cancel by a fifth");
  return check;
}

}  // namespace

Check checkDiscWidth() {
  Check check = relativeCheck("alphaOfDisc", "lights.glsl", "out0.x = alphaOfDisc(in0.x, in0.y);", {"alpha", "radius"});
  check.inputs = grid({0, 1e-6, 1e-3, 0.01, 0.3, 1}, {1e-6, 0.00465, 0.02, 0.1});
  check.twin = [](CheckVectors in) -> CheckValues { return {optics::alphaOfDisc(in[0].x, in[0].y)}; };
  allow(check, 8, "8 roundings");
  return check;
}

// About +Z, whose frame is the axes themselves.
Check checkDiscPoint() {
  Check check = absoluteCheck("directionInDisc", "lights.glsl",
                              "out0.xyz = directionInDisc(vec3(0.0, 0.0, 1.0), in0.x, in0.yz);", {"radius", "u", "v"});
  check.inputs = grid({1e-4, 0.00465, 0.02, 0.1}, {0, 0.25, 1}, {0, 0.1, 0.5, 0.9});
  check.twin = [](CheckVectors in) -> CheckValues {
    const optics::DiscPoint p = optics::pointInDisc(in[0].x, in[0].y, in[0].z);
    return {std::sin(p.theta) * std::cos(p.phi), std::sin(p.theta) * std::sin(p.phi), std::cos(p.theta)};
  };
  allow(check, 32, "the precision of sin and cos is the driver's");
  return check;
}

Check checkLuminance() {
  Check check = relativeCheck("luminance", "luminance.glsl", "out0.x = luminance(in0.xyz);", {"r", "g", "b"});
  check.inputs = grid({0, 1e-6, 0.3, 1, 1e6}, {0, 1e-6, 0.3, 1}, {0, 0.7, 1e4});
  check.twin = [](CheckVectors in) -> CheckValues { return {optics::luminance(xyzOf(in[0]))}; };
  allow(check, 4, "three products and their sum");
  return check;
}

// in0 texel; in1 exposure, sRGB or not, factor, backdrop's weight; of Reinhard.
Check checkDisplayed() {
  Check check = absoluteCheck("displayed", "display.glsl",
                              "out0 = displayed(in0, vec4(in1.x, 1.0, in1.y, in1.z), vec4(0.2, 0.5, 0.9, in1.w));",
                              {"r", "g", "b", "a", "exposure", "srgb", "factor", "backdrop"}, 2);
  for (const double a : {0.0, 0.25, 1.0, 4.0})
    for (const double srgb : {0.0, 1.0})
      for (const double backdrop : {0.0, 1.0})
        for (const double factor : {1.0, 0.25})
          for (const double exposure : {1.0, 8.0}) {
            check.inputs.emplace_back(0.7 * a, 0.01 * a, 3 * a, a);
            check.inputs.emplace_back(exposure, srgb, factor, backdrop);
          }
  check.twin = [](CheckVectors in) -> CheckValues {
    const glm::dvec4 texel = in[0] * in[1].z;
    const glm::dvec3 behind(double(0.2f), 0.5, double(0.9f));
    const double a = std::clamp(texel.w, 0.0, 1.0);
    const glm::dvec3 color = a > 0 ? glm::dvec3(texel) / a : glm::dvec3(0);
    glm::dvec3 shown = glm::clamp(color, 0.0, 1.0);
    if (in[1].y > 0.5) shown = optics::toneMap(optics::ToneMapper::reinhard, color * in[1].x);
    const bool over = in[1].w > 0.5;
    if (in[1].y > 0.5)
      shown = optics::encodeSRGB(over ? glm::mix(behind, shown, a) : shown);
    else if (over)
      shown = glm::mix(optics::encodeSRGB(behind), shown, a);
    return {shown.x, shown.y, shown.z, over ? 1 : a};
  };
  allow(check, 64, "16 roundings, and pow, whose precision is the driver's");
  return check;
}

// in0 texel; in1 the ends' binary logarithms.
Check checkLightInFalseColors() {
  Check check = absoluteCheck("displayedLuminance", "display.glsl",
                              "out0.rgb = displayed(in0, vec4(in1.xy, 4.0, 1.0), vec4(0.0)).rgb;",
                              {"r", "g", "b", "a", "from", "to"}, 2);
  for (const glm::dvec2 ends : {glm::dvec2(-10, 6), glm::dvec2(0, 1), glm::dvec2(-32, 20)})
    for (const double a : {0.25, 1.0})
      for (const double value : {0.0, 1e-30, 1e-3, 0.18, 1.0, 40.0, 65504.0, 1e30}) {
        check.inputs.emplace_back(0.7 * value * a, value * a, 0.2 * value * a, a);
        check.inputs.emplace_back(ends, 0, 0);
      }
  check.twin = [](CheckVectors in) {
    const double value = std::max(optics::luminance(xyzOf(in[0]) / in[0].w), double{1e-37f});
    return valuesOf(optics::falseColor((std::log2(value) - in[1].x) / (in[1].y - in[1].x)));
  };
  allow(check, 1024,
        "log2, whose precision is the driver's, of numbers up to 100 octaves from 1, and 8 times the share");
  return check;
}

Check checkFalseColor() {
  Check check = absoluteCheck("falseColor", "false_color.glsl", "out0.rgb = falseColor(in0.x);", {"share"}, 1);
  for (const double share : {-1.0, 0.0, 0.01, 0.0625, 0.125, 0.3, 0.5, 0.77, 0.99, 1.0, 2.0, 1e30})
    check.inputs.emplace_back(share, 0, 0, 0);
  check.twin = [](CheckVectors in) { return valuesOf(optics::falseColor(in[0].x)); };
  allow(check, 32, "8 times the share, and 4 roundings of numbers up to 1");
  return check;
}

std::vector<Check> lightChecks() { return {checkDistance(), checkCone(), checkDiscWidth(), checkDiscPoint()}; }

std::vector<Check> displayChecks() {
  using optics::ToneMapper;
  const char* few = "8 roundings of numbers up to 1";
  const char* limit = "16 roundings of numbers near 1, and radiances above 1e6 count as 1e6, 4e-6 from the limit";
  return {
      checkLuminance(),
      checkDisplayed(),
      checkLightInFalseColors(),
      checkFalseColor(),
      checkSrgb(),
      checkToneMapper(ToneMapper::none, "toneMap", floatEpsilon, "clamped only"),
      checkToneMapper(ToneMapper::reinhard, "toneReinhard", 8 * floatEpsilon, few),
      checkToneMapper(ToneMapper::uncharted2, "toneUncharted2", 64 * floatEpsilon, limit),
      checkToneMapper(ToneMapper::aces, "toneAces", 64 * floatEpsilon, limit),
      checkToneMapper(ToneMapper::agx, "toneAgx", 256 * floatEpsilon,
                      "terms up to 40 add up to 1, and the precision of log2 and pow is the driver's; 256 epsilon are "
                      "1 / 130 of an 8-bit step"),
      checkToneMapper(ToneMapper::pbrNeutral, "toneNeutral", 16 * floatEpsilon, "16 roundings of numbers near 1"),
      checkToneMapper(ToneMapper::reinhardPower, "toneReinhardPower", 64 * floatEpsilon,
                      "two powers of the driver's, of numbers up to 1")};
}

std::vector<Check> mappingChecks() {
  return {checkToEquirect(), checkFromCube(),     checkCubeDensity(),  checkCubeTexel(), checkFrame(),
          checkLayer(),      checkSpreadCosine(), checkSpreadKernel(), checkOpenArc(),   checkInterreflection()};
}

}  // namespace facet::selftest
