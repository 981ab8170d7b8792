#include "optics/measured.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

constexpr double quarter = pi / 2;

// Two neighbours along an axis and the share of the second.
struct Axis {
  int low = 0, high = 0;
  double share = 0;
};

// Entry k lies at k.
Axis held(double x, int steps) {
  const double inside = std::clamp(x, 0.0, static_cast<double>(steps - 1));
  const int low = static_cast<int>(inside);
  return {low, std::min(low + 1, steps - 1), inside - low};
}

int wrapIndex(int index, int steps) { return (index % steps + steps) % steps; }

Axis wrapped(double x, int steps) {
  const double low = std::floor(x);
  const int index = wrapIndex(static_cast<int>(low), steps);
  return {index, (index + 1) % steps, x - low};
}

// Multilinear between the 2^n entries around a point; the last axis is the fastest.
template <size_t n>
glm::dvec3 interpolate(const MeasuredBrdf& brdf, const std::array<Axis, n>& axes, const std::array<int, n>& steps) {
  glm::dvec3 sum{0};
  double total = 0;
  for (size_t corner = 0; corner < size_t{1} << n; ++corner) {
    double weight = 1;
    size_t index = 0;
    for (size_t a = 0; a < n; ++a) {
      const bool high = corner >> a & 1;
      weight *= high ? axes[a].share : 1 - axes[a].share;
      index = index * static_cast<size_t>(steps[a]) + static_cast<size_t>(high ? axes[a].high : axes[a].low);
    }
    const glm::vec3& value = brdf.values[index];
    if (weight <= 0 || value.x < 0) continue;
    sum += weight * glm::dvec3(value);
    total += weight;
  }
  return total > 0 ? sum / total : glm::dvec3(0);
}

glm::dvec3 merlValue(const MeasuredBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L, LookUp lookUp) {
  const glm::dvec3 at = merlPosition(halfDifference(V, L), brdf.phiSteps);
  const std::array steps = {merlThetaSteps, merlThetaSteps, brdf.phiSteps};
  if (lookUp == LookUp::nearest) {
    const auto cell = [](double x, int count) { return std::clamp(static_cast<int>(x), 0, count - 1); };
    const int x = cell(at.x, steps[0]), y = cell(at.y, steps[1]), z = cell(at.z, steps[2]);
    const glm::vec3& value = brdf.values[static_cast<size_t>((x * steps[1] + y) * steps[2] + z)];
    return value.x < 0 ? glm::dvec3(0) : glm::dvec3(value);
  }
  return interpolate<3>(brdf, {held(at.x - 0.5, steps[0]), held(at.y - 0.5, steps[1]), wrapped(at.z - 0.5, steps[2])},
                        steps);
}

glm::dvec3 utiaValue(const MeasuredBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L, LookUp lookUp) {
  const glm::dvec2 atV = utiaPosition(V), atL = utiaPosition(L);
  if (lookUp == LookUp::nearest) {
    const auto entry = [](const glm::dvec2& at) {
      const int theta = std::clamp(static_cast<int>(at.x + 0.5), 0, utiaThetaSteps - 1);
      return theta * utiaPhiSteps + static_cast<int>(at.y + 0.5) % utiaPhiSteps;
    };
    const glm::vec3& value = brdf.values[static_cast<size_t>(entry(atL) * utiaDirections + entry(atV))];
    return value.x < 0 ? glm::dvec3(0) : glm::dvec3(value);
  }
  return interpolate<4>(brdf,
                        {held(atL.x, utiaThetaSteps), wrapped(atL.y, utiaPhiSteps), held(atV.x, utiaThetaSteps),
                         wrapped(atV.y, utiaPhiSteps)},
                        {utiaThetaSteps, utiaPhiSteps, utiaThetaSteps, utiaPhiSteps});
}

}  // namespace

size_t cellsOf(MeasuredKind kind, int phiSteps) {
  if (kind == MeasuredKind::utia) return static_cast<size_t>(utiaDirections) * utiaDirections;
  return static_cast<size_t>(merlThetaSteps) * merlThetaSteps * static_cast<size_t>(phiSteps);
}

// With S = L + V = 2 cos(theta_d) H and D = L - V = 2 sin(theta_d) d, d at right angles to H: the components of d
// along the meridian and the parallel of H, both times sin(theta_h), are -D.z / 2 and (V x L).z / |S|.
HalfDifference halfDifference(const glm::dvec3& V, const glm::dvec3& L) {
  const glm::dvec3 S = L + V, D = L - V;
  const double length = glm::length(S);
  const double across = V.x * D.y - V.y * D.x;
  HalfDifference angles;
  angles.thetaH = std::atan2(std::hypot(S.x, S.y), S.z);
  angles.thetaD = std::atan2(glm::length(D), length);
  if (across != 0 || D.z != 0) angles.phiD = std::atan2(2 * across, -D.z * length);
  if (angles.phiD < 0) angles.phiD += 2 * pi;
  if (angles.phiD >= 2 * pi) angles.phiD = 0;
  return angles;
}

Directions directionsFrom(const HalfDifference& angles) {
  const double sinH = std::sin(angles.thetaH), cosH = std::cos(angles.thetaH);
  const glm::dvec3 H(sinH, 0, cosH), meridian(cosH, 0, -sinH), parallel(0, 1, 0);
  const glm::dvec3 d = std::sin(angles.thetaD) * (std::cos(angles.phiD) * meridian + std::sin(angles.phiD) * parallel);
  return {std::cos(angles.thetaD) * H - d, std::cos(angles.thetaD) * H + d};
}

glm::dvec3 merlPosition(const HalfDifference& angles, int phiSteps) {
  double z = angles.phiD * merlPhiSteps / pi;
  if (z >= phiSteps) z -= phiSteps;
  return {merlThetaSteps * std::sqrt(angles.thetaH / quarter), merlThetaSteps * angles.thetaD / quarter, z};
}

HalfDifference merlAngles(const glm::dvec3& position) {
  const double root = position.x / merlThetaSteps;
  return {quarter * root * root, quarter * position.y / merlThetaSteps, pi * position.z / merlPhiSteps};
}

glm::dvec2 utiaPosition(const glm::dvec3& direction) {
  const double theta = std::atan2(std::hypot(direction.x, direction.y), direction.z);
  double phi = std::atan2(direction.y, direction.x);
  if (phi < 0) phi += 2 * pi;
  const double y = phi * utiaPhiSteps / (2 * pi);
  return {theta * (180 / pi) / 15, y >= utiaPhiSteps ? 0 : y};
}

glm::dvec3 utiaDirection(const glm::dvec2& position) {
  const double theta = position.x * 15 * (pi / 180), phi = position.y * 2 * pi / utiaPhiSteps;
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

double merlPairs(int x, int y) {
  const HalfDifference a = merlAngles({x + 0.5, y + 0.5, 0});
  return std::cos(a.thetaD) * std::sin(a.thetaD) * std::sin(a.thetaH) * (x + 0.5);
}

double utiaProjected(int theta) {
  const double from = std::max(theta - 0.5, 0.0), to = theta == utiaThetaSteps - 1 ? 6 : theta + 0.5;
  return std::pow(std::sin(to * 15 * degree), 2) - std::pow(std::sin(from * 15 * degree), 2);
}

glm::dvec3 measuredBrdf(const MeasuredBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L, LookUp lookUp) {
  if (!(V.z > 0 && L.z > 0)) return glm::dvec3(0);
  return brdf.kind == MeasuredKind::merl ? merlValue(brdf, V, L, lookUp) : utiaValue(brdf, V, L, lookUp);
}

}  // namespace facet::optics
