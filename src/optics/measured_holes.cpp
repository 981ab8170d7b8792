#include "optics/measured_holes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "base/parallel.hpp"
#include "optics/color.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

constexpr double smallestValue = 1e-6;  // [1/sr] counts as black: added, so that 0 has a logarithm
constexpr int horizonReach = 8;         // [cells] at most from a cell across the horizon to one above it
constexpr double lastCosine = 0.2588190451025207 + 1e-6;  // of utiaLastTheta

struct AxisSteps {
  int steps;
  bool wraps;
};
struct Grid {
  std::array<AxisSteps, 4> axes;
  size_t count;
  int reach;  // how far a value is continued [cells]
  std::span<const AxisSteps> used() const { return std::span(axes).first(count); }
};
Grid gridOf(const MeasuredBrdf& brdf) {
  if (brdf.kind == MeasuredKind::utia)
    return {{{{utiaThetaSteps, false}, {utiaPhiSteps, true}, {utiaThetaSteps, false}, {utiaPhiSteps, true}}}, 4, 1};
  return {{{{merlThetaSteps, false}, {merlThetaSteps, false}, {brdf.phiSteps, true}, {}}}, 3, 3};
}

using Place = std::array<int, 4>;

Place placeOf(const Grid& grid, size_t index) {
  Place place{};
  for (size_t a = grid.count; a-- > 0;) {
    const auto steps = static_cast<size_t>(grid.axes[a].steps);
    place[a] = static_cast<int>(index % steps);
    index /= steps;
  }
  return place;
}
size_t indexOf(const Grid& grid, const Place& place) {
  size_t index = 0;
  for (size_t a = 0; a < grid.count; ++a)
    index = index * static_cast<size_t>(grid.axes[a].steps) + static_cast<size_t>(place[a]);
  return index;
}

Directions centreOf(const MeasuredBrdf& brdf, const Place& p) {
  if (brdf.kind == MeasuredKind::utia) return {utiaDirection({p[2], p[3]}), utiaDirection({p[0], p[1]})};
  return directionsFrom(merlAngles({p[0] + 0.5, p[1] + 0.5, p[2] + 0.5}));
}

// The cell of the pair with V and L exchanged; itself where the grid has no other.
size_t exchanged(const Grid& grid, const MeasuredBrdf& brdf, const Place& p) {
  if (brdf.kind == MeasuredKind::utia) return indexOf(grid, {p[2], p[3], p[0], p[1]});
  if (brdf.phiSteps == merlPhiSteps) return indexOf(grid, p);
  return indexOf(grid, {p[0], p[1], (p[2] + merlPhiSteps) % brdf.phiSteps});
}

// ln f and its slope by cells, at the nearest measured cell on one side of a hole.
struct Side {
  int distance = 0;  // 0: there is none
  glm::dvec3 value{0};
  std::optional<glm::dvec3> slope;  // away from the hole; none: the cell beyond is missing, too
};
Side sideOf(const Grid& grid, const std::vector<glm::vec3>& values, const Place& from, size_t axis, int step,
            int farthest) {
  const int steps = grid.axes[axis].steps;
  const bool wraps = grid.axes[axis].wraps;
  int stride = 1;
  for (size_t a = axis + 1; a < grid.count; ++a) stride *= grid.axes[a].steps;
  const int base = static_cast<int>(indexOf(grid, from)) - from[axis] * stride;
  const auto at = [&](int distance) -> const glm::vec3* {
    int place = from[axis] + step * distance;
    if (wraps) place = (place + steps) % steps;
    if (distance >= steps || place < 0 || place >= steps) return nullptr;
    const glm::vec3& value = values[static_cast<size_t>(base + place * stride)];
    return value.x < 0 ? nullptr : &value;
  };
  const auto logarithm = [](const glm::vec3& value) { return glm::log(glm::dvec3(value) + smallestValue); };
  for (int distance = 1; distance <= std::min(farthest, steps - 1); ++distance) {
    const glm::vec3* value = at(distance);
    if (!value) continue;
    Side side{distance, logarithm(*value), {}};
    if (const glm::vec3* next = at(distance + 1)) side.slope = logarithm(*next) - side.value;
    return side;
  }
  return {};
}

// A cubic through both sides with their slopes, each at most three times the chord's and not against it.
glm::dvec3 between(const Side& low, const Side& high) {
  const double h = low.distance + high.distance, t = low.distance / h;
  glm::dvec3 result;
  for (int c = 0; c < 3; ++c) {
    const double chord = (high.value[c] - low.value[c]) / h;
    const auto limited = [&](std::optional<glm::dvec3> slope, double sign) {
      if (!slope) return chord;
      const double own = sign * (*slope)[c];
      return own * chord <= 0 ? 0 : std::copysign(std::min(std::abs(own), 3 * std::abs(chord)), chord);
    };
    const double a = limited(low.slope, -1), b = limited(high.slope, 1);
    const double u = 1 - t;
    result[c] = low.value[c] * u * u * (1 + 2 * t) + high.value[c] * t * t * (3 - 2 * t) + h * t * u * (a * u - b * t);
  }
  return result;
}

enum class Filled : uint8_t { nothing, between, continued };
struct Guess {
  Filled how = Filled::nothing;
  glm::vec3 value{missingValue};
};

Guess guessAt(const Grid& grid, const std::vector<glm::vec3>& values, const Place& place, bool anyDistance,
              int farthest) {
  glm::dvec3 inside{0}, outside{0};
  double insideWeight = 0, outsideWeight = 0;
  int nearest = 1 << 30;
  for (size_t a = 0; a < grid.count; ++a) {
    const Side low = sideOf(grid, values, place, a, -1, farthest), high = sideOf(grid, values, place, a, 1, farthest);
    if (low.distance > 0 && high.distance > 0) {
      const double weight = 1.0 / (low.distance * high.distance);
      inside += weight * between(low, high);
      insideWeight += weight;
    }
    for (const Side& side : {low, high}) {
      if (side.distance == 0) continue;
      const double weight = 1.0 / (side.distance * side.distance);
      outside += weight * side.value;
      outsideWeight += weight;
      nearest = std::min(nearest, side.distance);
    }
  }
  const auto linear = [](const glm::dvec3& log) { return glm::vec3(glm::max(glm::exp(log) - smallestValue, 0.0)); };
  if (insideWeight > 0) return {Filled::between, linear(inside / insideWeight)};
  if (outsideWeight > 0 && (anyDistance || nearest <= grid.reach))
    return {Filled::continued, linear(outside / outsideWeight)};
  return {};
}

// What the light of a cell's pairs counts in the bihemispherical reflectance, up to a common factor.
double weightOf(const MeasuredBrdf& brdf, const Place& p) {
  if (brdf.kind == MeasuredKind::utia) return utiaProjected(p[0]) * utiaProjected(p[2]);
  const Directions pair = centreOf(brdf, p);
  return std::max(pair.V.z, 0.0) * std::max(pair.L.z, 0.0) * merlPairs(p[0], p[1]);
}

// tan(theta_h), tan(theta_d) and |cos(phi_d)| where cells begin.
struct MerlTangents {
  std::array<double, merlThetaSteps> thetaH, thetaD;
  std::array<double, merlPhiSteps + 1> phi;
  MerlTangents() {
    for (int k = 0; k < merlThetaSteps; ++k) {
      thetaH[static_cast<size_t>(k)] = std::tan(merlAngles({k, 0, 0}).thetaH);
      thetaD[static_cast<size_t>(k)] = std::tan(merlAngles({0, k, 0}).thetaD);
    }
    for (int k = 0; k <= merlPhiSteps; ++k)
      phi[static_cast<size_t>(k)] = std::abs(std::cos(merlAngles({0, 0, k}).phiD));
  }
};

double guessedEnergy(const Grid& grid, const MeasuredBrdf& brdf) {
  const size_t slabs = static_cast<size_t>(grid.axes[0].steps), slab = brdf.values.size() / slabs;
  std::vector<double> whole(slabs, 0.0);
  parallelFor(slabs, [&](size_t s) {
    for (size_t i = s * slab; i < (s + 1) * slab; ++i)
      if (brdf.values[i].x >= 0) whole[s] += weightOf(brdf, placeOf(grid, i)) * luminance(glm::dvec3(brdf.values[i]));
  });
  double total = 0, guessed = 0;
  for (const double sum : whole) total += sum;
  for (const uint32_t i : brdf.guess.cells)
    guessed += weightOf(brdf, placeOf(grid, i)) * luminance(glm::dvec3(brdf.values[i]));
  return total > 0 ? guessed / total : 0;
}

}  // namespace

// Both directions are above the horizon where tan(theta_d) tan(theta_h) |cos(phi_d)| < 1: of a cell first at its least
// angles, at the end nearer to phi_d = pi / 2 or 3 pi / 2.
bool merlCellReachesAbove(int x, int y, int z) {
  static const MerlTangents tangents;
  const int within = z % merlPhiSteps;
  return tangents.thetaH[static_cast<size_t>(x)] * tangents.thetaD[static_cast<size_t>(y)] *
             tangents.phi[static_cast<size_t>(within < merlPhiSteps / 2 ? within + 1 : within)] <
         1;
}

size_t fillHoles(MeasuredBrdf& brdf) {
  brdf.guess = {};
  const Grid grid = gridOf(brdf);
  // Missing cells that reach above the horizon, the holes among them.
  std::vector<uint32_t> open;
  std::vector<uint8_t> hole;
  for (size_t i = 0; i < brdf.values.size(); ++i) {
    if (brdf.values[i].x >= 0) continue;
    const Place p = placeOf(grid, i);
    if (brdf.kind == MeasuredKind::merl && !merlCellReachesAbove(p[0], p[1], p[2])) {
      ++brdf.guess.belowHorizon;
      continue;
    }
    const Directions centre = centreOf(brdf, p);
    open.push_back(static_cast<uint32_t>(i));
    hole.push_back(centre.V.z > 0 && centre.L.z > 0);
  }
  if (open.empty()) return 0;
  MeasuredGuess& guess = brdf.guess;
  std::vector<Guess> guesses(open.size());
  std::vector<bool> mirrored(open.size());
  for (size_t k = 0; k < open.size(); ++k) {
    guesses[k].value = brdf.values[exchanged(grid, brdf, placeOf(grid, open[k]))];
    mirrored[k] = guesses[k].value.x >= 0;
  }
  const auto apply = [&] {
    for (size_t k = 0; k < open.size(); ++k) brdf.values[open[k]] = guesses[k].value;
  };
  apply();
  // Between measured cells first; then what is left, from those and from what they gave.
  for (const bool between : {true, false}) {
    parallelFor(open.size(), [&](size_t k) {
      if (brdf.values[open[k]].x >= 0) return;
      const Place place = placeOf(grid, open[k]);
      const Directions centre = centreOf(brdf, place);
      const bool grazing = centre.V.z < lastCosine || centre.L.z < lastCosine;
      const Guess made = guessAt(grid, brdf.values, place, grazing, hole[k] ? 1 << 20 : horizonReach);
      if (!between || made.how == Filled::between) guesses[k] = made;
    });
    apply();
  }
  size_t unreached = 0;
  for (size_t k = 0; k < open.size(); ++k) {
    if (!hole[k]) {
      ++guess.acrossHorizon;
      continue;
    }
    guess.cells.push_back(open[k]);
    if (mirrored[k])
      ++guess.reciprocal;
    else if (guesses[k].how == Filled::nothing)
      ++unreached;
    else
      ++(guesses[k].how == Filled::between ? guess.between : guess.continued);
  }
  if (!guess.cells.empty()) guess.energy = guessedEnergy(grid, brdf);
  return unreached;
}

MeasuredBrdf guessedPart(const MeasuredBrdf& brdf) {
  MeasuredBrdf part = brdf;
  for (glm::vec3& value : part.values)
    if (value.x >= 0) value = glm::vec3(0);
  for (const uint32_t i : brdf.guess.cells) part.values[i] = brdf.values[i];
  return part;
}

}  // namespace facet::optics
