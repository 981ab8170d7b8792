#include "frame/measured_gpu.hpp"
#include "layout.h"
#include "optics/microfacet.hpp"
#include "optics/synthetic_brdf.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::pi;

Check checkArcTangent() {
  Check check = relativeCheck("arcTangent", "arc_tangent.glsl", "out0.x = arcTangent(in0.x, in0.y);", {"y", "x"});
  const Axis sides = {0, 1e-30, 1e-10, 1e-3, 0.2, 0.41421, 0.41422, 0.7, 1, 1.5, 1e3, 1e10, 1e30};
  for (const double y : sides)
    for (const double x : sides)
      for (const double signY : {1.0, -1.0})
        for (const double signX : {1.0, -1.0})
          if ((x > 0 || y > 0) && (y > 0 || signY > 0) && (x > 0 || signX > 0))
            check.inputs.emplace_back(signY * y, signX * x, 0, 0);
  check.twin = [](CheckVectors in) { return CheckValues{std::atan2(in[0].x, in[0].y)}; };
  // Below the smallest float the quotient is 0.
  check.floor = 1e-37;
  allow(check, 8, "the series is off by 2e-7 at most; quotient, square, ten products");
  return check;
}

// in0 V, in1 L. By the cell's measure: phi_d as a point of the circle with radius sin(theta_h) sin(theta_d), which is
// what rounding V and L moves.
std::vector<glm::vec4> pairsOfDirections() {
  std::vector<glm::vec4> inputs;
  for (const double NoV : {1e-3, 0.3, 0.99999, 1.0})
    for (const double NoL : {1e-3, 0.05, 0.3, 0.7, 1.0})
      for (const double phi : {0.0, 1e-3, 1.0, 3.14, 5.0}) {
        inputs.emplace_back(glm::vec3(around(NoV, 0.4)), 0);
        inputs.emplace_back(glm::vec3(around(NoL, 0.4 + phi)), 0);
      }
  return inputs;
}

Check checkHalfDifference() {
  Check check = absoluteCheck("halfDifference", "measured.glsl", "out0.xyz = halfDifference(in0.xyz, in1.xyz);",
                              {"V.x", "V.y", "V.z", "", "L.x", "L.y", "L.z"}, 2);
  check.inputs = pairsOfDirections();
  const auto values = [](double thetaH, double thetaD, double phi, const optics::HalfDifference& exact) {
    const double radius = std::sin(exact.thetaH) * std::sin(exact.thetaD);
    return CheckValues{thetaH, thetaD, radius * std::cos(phi), radius * std::sin(phi)};
  };
  check.twin = [=](CheckVectors in) {
    const optics::HalfDifference exact = optics::halfDifference(xyzOf(in[0]), xyzOf(in[1]));
    return values(exact.thetaH, exact.thetaD, exact.phiD, exact);
  };
  check.observe = [=](CheckVectors in, CheckVectors out) {
    const optics::HalfDifference exact = optics::halfDifference(xyzOf(in[0]), xyzOf(in[1]));
    return values(out[0].x, out[0].y, out[0].z, exact);
  };
  check.conditioning = [](CheckVectors in) { return 1 + 2 / glm::length(xyzOf(in[0]) + xyzOf(in[1])); };
  allow(check, 8, "roundings of L + V and L - V, over the length of L + V; arcTangent");
  return check;
}

Check checkMerlPosition() {
  Check check = relativeCheck("merlPosition", "measured.glsl", "out0.xyz = merlPosition(in0.xyz, in0.w);",
                              {"theta_h", "theta_d", "phi_d", "phi steps"});
  check.inputs =
      grid({0, 1e-8, 1e-3, 0.5, 1.57}, {0, 1e-4, 0.7, 1.57}, {0, 1e-5, 1, 3.1415, 3.1417, 6.283}, {180, 360});
  check.twin = [](CheckVectors in) {
    return valuesOf(optics::merlPosition({in[0].x, in[0].y, in[0].z}, static_cast<int>(in[0].w)));
  };
  check.floor = 180;  // of a turn's cells: past a half turn 180 are taken off
  allow(check, 4, "three products, a root, a difference; of phi_d in cells of half a turn");
  return check;
}

Check checkUtiaPosition() {
  Check check =
      absoluteCheck("utiaPosition", "measured.glsl", "out0.xy = utiaPosition(in0.xyz);", {"d.x", "d.y", "d.z"});
  for (const double cosine : {0.0, 1e-4, 0.3, 0.9, 0.9999999, 1.0})
    for (const double phi : {0.0, 1e-4, 1.0, 2.0, 3.14159, 4.0, 6.2831})
      check.inputs.emplace_back(glm::vec3(around(cosine, phi)), 0);
  const auto values = [](const glm::dvec2& at, CheckVectors in) {
    const double phi = at.y * 2 * pi / optics::utiaPhiSteps, sine = std::hypot(in[0].x, in[0].y);
    return CheckValues{at.x, sine * std::cos(phi), sine * std::sin(phi)};
  };
  check.twin = [=](CheckVectors in) { return values(optics::utiaPosition(xyzOf(in[0])), in); };
  check.observe = [=](CheckVectors in, CheckVectors out) { return values(out[0], in); };
  allow(check, 32, "arcTangent, times 12 / pi and 24 / pi, of at most 6 cells and a turn");
  return check;
}

Check checkAxes() {
  Check check = absoluteCheck("heldAxis, wrappedAxis", "measured.glsl",
                              "GridAxis held = heldAxis(in0.x, int(in0.y)), wrapped = wrappedAxis(in0.x, int(in0.y));\n"
                              "out0 = vec4(held.low, held.high, held.share, 0.0);\n"
                              "out1 = vec4(wrapped.low, wrapped.high, wrapped.share, 0.0);",
                              {"x", "steps"});
  check.probe.outputs = 2;
  check.inputs = grid({-0.5, -0.25, 0, 0.5, 1, 2.75, 3, 3.25}, {4});
  check.twin = [](CheckVectors in) {
    const double x = in[0].x, steps = in[0].y, inside = std::clamp(x, 0.0, steps - 1), low = std::floor(inside);
    const double turn = std::floor(x), index = std::fmod(turn + steps, steps);
    return CheckValues{low,   std::min(low + 1, steps - 1), inside - low, 0,
                       index, std::fmod(index + 1, steps),  x - turn};
  };
  check.observe = [](CheckVectors, CheckVectors out) {
    return CheckValues{out[0].x, out[0].y, out[0].z, 0, out[1].x, out[1].y, out[1].z};
  };
  allow(check, 0, "whole numbers and quarters");
  return check;
}

// A table as the GPU has it, made when it is first asked for.
struct Table {
  optics::MeasuredBrdf brdf;
  std::shared_ptr<const frame::MeasuredOnGpu> onGpu;
};
using TableSource = std::function<const Table&()>;

TableSource tableOf(const char* name) {
  return [name, made = std::make_shared<Table>()]() -> const Table& {
    if (!made->brdf.values.empty()) return *made;
    const optics::SyntheticBrdf& found = *optics::findSynthetic(name);
    const optics::MeasuredBrdf whole = optics::makeMeasured(found.formula, found.kind, found.name);
    made->brdf = frame::unpackMeasured(frame::packMeasured(whole), whole);
    return *made;
  };
}

Check checkLookUp(const std::string& name, const char* table, optics::LookUp lookUp) {
  Check check = relativeCheck(name, "measured_table.glsl", "out0.xyz = measuredBrdf(in0.xyz, in1.xyz);",
                              {"V.x", "V.y", "V.z", "", "L.x", "L.y", "L.z"}, 2);
  const bool utia = optics::findSynthetic(table)->kind == optics::MeasuredKind::utia;
  const bool nearest = lookUp == optics::LookUp::nearest;
  if (utia) check.probe.defines.push_back({"UTIA_BRDF"});
  if (nearest) check.probe.defines.push_back({"MEASURED_NEAREST"});
  // Nearest: a tenth of a cell from the middle, so that rounding leaves no cell; there are none on the horizon.
  const auto near = [&](int cell) { return cell + (utia ? 0.1 : 0.6); };
  for (int i = 0; nearest && i < 500; ++i) {
    const auto index = [&](double step, int steps) { return static_cast<int>(std::fmod(i * step, 1.0) * steps); };
    optics::Directions pair;
    if (utia)
      pair = {optics::utiaDirection({near(index(0.754877, 5)), near(index(0.569840, 48))}),
              optics::utiaDirection({near(index(0.381966, 5)), near(index(0.618034, 48))})};
    else
      pair = optics::directionsFrom(optics::merlAngles(
          {near(5 + index(0.754877, 60)), near(2 + index(0.569840, 60)), near(index(0.381966, 180))}));
    if (pair.V.z < 0.1 || pair.L.z < 0.1) continue;
    check.inputs.emplace_back(glm::vec3(pair.V), 0);
    check.inputs.emplace_back(glm::vec3(pair.L), 0);
  }
  if (!nearest)
    for (const optics::Directions& pair : optics::testPairs(500)) {
      check.inputs.emplace_back(glm::vec3(pair.V), 0);
      check.inputs.emplace_back(glm::vec3(pair.L), 0);
    }
  const TableSource source = tableOf(table);
  check.bind = [source] {
    const auto onGpu = frame::uploadMeasured(source().brdf);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::measuredBinding, onGpu->buffer.id());
    return onGpu;
  };
  check.twin = [source, lookUp](CheckVectors in) {
    return valuesOf(optics::measuredBrdf(source().brdf, xyzOf(in[0]), xyzOf(in[1]), lookUp));
  };
  if (nearest) {
    allow(check, 4, "the cell's own value: a product");
  } else {
    allow(check, 4096,
          "where a pair lies is off by 1e-4 of a cell, from one of which to the next values change manifold");
  }
  return check;
}

}  // namespace

std::vector<Check> measuredChecks() {
  using enum optics::LookUp;
  return {checkArcTangent(),
          checkHalfDifference(),
          checkMerlPosition(),
          checkUtiaPosition(),
          checkAxes(),
          checkLookUp("lookUpMeasured, MERL", "plastic-0.2", interpolated),
          checkLookUp("lookUpMeasured, MERL, nearest", "plastic-0.2", nearest),
          checkLookUp("lookUpMeasured, UTIA", "utia-brushed", interpolated),
          checkLookUp("lookUpMeasured, UTIA, nearest", "utia-brushed", nearest)};
}

}  // namespace facet::selftest
