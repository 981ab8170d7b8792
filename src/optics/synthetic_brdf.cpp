#include "optics/synthetic_brdf.hpp"

#include <algorithm>
#include <cmath>

#include "base/parallel.hpp"
#include "optics/measured_holes.hpp"
#include "optics/point_sets.hpp"

namespace facet::optics {

namespace {

constexpr AnalyticBrdf metal(double roughness, const glm::dvec3& f0) {
  return {.f0 = f0, .alpha = {roughness * roughness, roughness * roughness}};
}
constexpr AnalyticBrdf plastic(double roughness, const glm::dvec3& albedo) {
  return {.f0 = glm::dvec3(0.04), .albedo = albedo, .alpha = {roughness * roughness, roughness * roughness}};
}
constexpr glm::dvec3 grey(0.8), gold(0.95, 0.73, 0.35), red(0.5, 0.1, 0.05), blue(0.1, 0.2, 0.5);

constexpr AnalyticBrdf lambertOnly{
    .f0 = glm::dvec3(0), .f90 = glm::dvec3(0), .albedo = glm::dvec3(0.5, 0.4, 0.3), .alpha = {1, 1}};

constexpr SyntheticBrdf table[] = {
    {"lambert", "matte, albedo 0.5 0.4 0.3", MeasuredKind::merl, lambertOnly},
    {"ggx-0.1", "metal of roughness 0.1 (alpha 0.01)", MeasuredKind::merl, metal(0.1, grey)},
    {"ggx-0.2", "metal of roughness 0.2 (alpha 0.04)", MeasuredKind::merl, metal(0.2, grey)},
    {"ggx-0.35", "metal of roughness 0.35 (alpha 0.1225)", MeasuredKind::merl, metal(0.35, gold)},
    {"ggx-0.5", "metal of roughness 0.5 (alpha 0.25)", MeasuredKind::merl, metal(0.5, gold)},
    {"ggx-0.7", "metal of roughness 0.7 (alpha 0.49)", MeasuredKind::merl, metal(0.7, grey)},
    {"ggx-1", "metal of roughness 1 (alpha 1)", MeasuredKind::merl, metal(1, grey)},
    {"plastic-0.2", "red plastic, roughness 0.2", MeasuredKind::merl, plastic(0.2, red)},
    {"plastic-0.5", "blue plastic, roughness 0.5", MeasuredKind::merl, plastic(0.5, blue)},
    {"utia-lambert", "matte, albedo 0.5 0.4 0.3, as UTIA has it", MeasuredKind::utia, lambertOnly},
    {"utia-ggx-0.7", "metal of roughness 0.7 (alpha 0.49), as UTIA has it", MeasuredKind::utia, metal(0.7, grey)},
    {"utia-brushed", "brushed metal, alpha 0.6 along the tangent, 0.25 across, turned by 30 degrees",
     MeasuredKind::utia, AnalyticBrdf{.f0 = grey, .alpha = {0.6, 0.25}, .phi = pi / 6}},
    {"utia-satin", "blue cloth with a sheen of alpha 0.8 and 0.4", MeasuredKind::utia,
     AnalyticBrdf{.f0 = glm::dvec3(0.06), .albedo = blue, .alpha = {0.8, 0.4}}},
};

glm::dvec3 merlCell(const AnalyticBrdf& formula, int x, int y, int z) {
  if (!merlCellReachesAbove(x, y, z)) return glm::dvec3(missingValue);
  const auto at = [&](double u, double v, double w) { return directionsFrom(merlAngles({x + u, y + v, z + w})); };
  const auto above = [](const Directions& pair) { return pair.V.z > 0 && pair.L.z > 0; };
  const Directions centre = at(0.5, 0.5, 0.5);
  if (above(centre)) return analyticBrdf(formula, centre.V, centre.L);
  constexpr int n = 3;
  glm::dvec3 sum{0};
  int count = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const Directions pair = at((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / (n * n) + 0.5) / n);
    if (!above(pair)) continue;
    sum += analyticBrdf(formula, pair.V, pair.L);
    ++count;
  }
  return count > 0 ? sum / static_cast<double>(count) : glm::dvec3(missingValue);
}

}  // namespace

std::span<const SyntheticBrdf> syntheticBrdfs() { return table; }

const SyntheticBrdf* findSynthetic(std::string_view name) {
  const auto found = std::find_if(std::begin(table), std::end(table), [&](const auto& b) { return b.name == name; });
  return found == std::end(table) ? nullptr : found;
}

MeasuredBrdf makeMeasured(const AnalyticBrdf& formula, MeasuredKind kind, std::string_view name) {
  MeasuredBrdf brdf{.name = std::string(name), .kind = kind, .values = {}, .counts = {}};
  brdf.values.resize(cellsOf(kind));
  if (kind == MeasuredKind::merl) {
    parallelFor(merlThetaSteps, [&](size_t x) {
      glm::vec3* out = &brdf.values[x * merlThetaSteps * merlPhiSteps];
      for (int y = 0; y < merlThetaSteps; ++y)
        for (int z = 0; z < merlPhiSteps; ++z) *out++ = glm::vec3(merlCell(formula, static_cast<int>(x), y, z));
    });
  } else {
    parallelFor(utiaDirections, [&](size_t l) {
      const auto entry = [](size_t i) { return utiaDirection({i / utiaPhiSteps, i % utiaPhiSteps}); };
      for (size_t v = 0; v < utiaDirections; ++v)
        brdf.values[l * utiaDirections + v] = glm::vec3(analyticBrdf(formula, entry(v), entry(l)));
    });
  }
  brdf.counts.negative =
      static_cast<size_t>(std::count_if(brdf.values.begin(), brdf.values.end(), [](const auto& v) { return v.x < 0; }));
  return brdf;
}

std::vector<Directions> testPairs(size_t n) {
  const double lowest = std::cos(utiaLastTheta * pi / 180);
  std::vector<Directions> pairs;
  pairs.reserve(n);
  for (uint32_t i = 1; pairs.size() < n; ++i) {
    const Directions pair =
        directionsFrom(merlAngles({merlThetaSteps * radicalInverse(i, 2), merlThetaSteps * radicalInverse(i, 3),
                                   2 * merlPhiSteps * radicalInverse(i, 5)}));
    if (pair.V.z <= lowest || pair.L.z <= lowest) continue;
    const double phi = 2 * pi * radicalInverse(i, 7), c = std::cos(phi), s = std::sin(phi);
    const auto turn = [&](const glm::dvec3& d) { return glm::dvec3(c * d.x - s * d.y, s * d.x + c * d.y, d.z); };
    pairs.push_back({turn(pair.V), turn(pair.L)});
  }
  return pairs;
}

GridError gridError(const MeasuredBrdf& brdf, const AnalyticBrdf& formula, LookUp lookUp,
                    const std::vector<Directions>& pairs) {
  double relative = 0, off = 0, whole = 0;
  for (const Directions& pair : pairs) {
    const glm::dvec3 f = analyticBrdf(formula, pair.V, pair.L);
    const glm::dvec3 d = measuredBrdf(brdf, pair.V, pair.L, lookUp) - f;
    relative += glm::dot(d / f, d / f) / 3;
    off += glm::dot(d, d) * pair.L.z * pair.L.z;
    whole += glm::dot(f, f) * pair.L.z * pair.L.z;
  }
  return {std::sqrt(relative / static_cast<double>(pairs.size())), std::sqrt(off / whole)};
}

}  // namespace facet::optics
