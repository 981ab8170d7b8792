#include "scene/sun.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "base/log.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"

namespace facet::scene {

namespace {

constexpr double largestSolidAngle = 1e-3;
constexpr double leastOverMean = 100;
constexpr double leastShare = 0.01;

// What counts as bright: the brightest channel, so that a coloured lamp is found as well.
double brightness(const glm::vec3& c) { return std::max({c.x, c.y, c.z}); }

struct Map {
  const Environment& environment;
  int width = environment.width, height = environment.height;

  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
  }
  const glm::vec3& at(int x, int y) const { return environment.radiance[index(x, y)]; }
  double solidAngle(int y) const { return optics::equirectTexelSolidAngle(y, width, height); }

  // Up to eight neighbours. Beyond a pole a texel's neighbours are those of the opposite meridian.
  template <class Visit>
  void neighbours(int x, int y, const Visit& visit) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if (dx == 0 && dy == 0) continue;
        int nx = x + dx, ny = y + dy;
        if (ny < 0 || ny >= height) ny = y, nx += width / 2;
        visit(((nx % width) + width) % width, ny);
      }
  }
};

struct Brightest {
  int x = 0, y = 0;
  double value = 0, mean = 0;
};

Brightest findBrightest(const Map& map) {
  Brightest found;
  for (int y = 0; y < map.height; ++y) {
    double sum = 0;
    for (int x = 0; x < map.width; ++x) {
      const double value = brightness(map.at(x, y));
      sum += value;
      if (value > found.value) found.x = x, found.y = y, found.value = value;
    }
    found.mean += sum * map.solidAngle(y) / (4 * optics::pi);
  }
  return found;
}

struct Texel {
  int x, y;
};

// Those connected with the brightest that are above the threshold, and those around them; nothing where they cover too
// much.
struct Region {
  std::vector<Texel> inside, around;
};
std::optional<Region> grow(const Map& map, const Brightest& brightest, double threshold) {
  Region region{{{brightest.x, brightest.y}}, {}};
  std::vector<bool> seen(map.environment.radiance.size());
  seen[map.index(brightest.x, brightest.y)] = true;
  double solidAngle = 0;
  for (size_t next = 0; next < region.inside.size(); ++next) {
    const Texel texel = region.inside[next];
    solidAngle += map.solidAngle(texel.y);
    if (solidAngle > largestSolidAngle) return std::nullopt;
    map.neighbours(texel.x, texel.y, [&](int x, int y) {
      if (seen[map.index(x, y)]) return;
      seen[map.index(x, y)] = true;
      (brightness(map.at(x, y)) > threshold ? region.inside : region.around).push_back({x, y});
    });
  }
  return region;
}

// A lamp with a wide glow is cut off closer to its peak.
std::optional<Region> growCompact(const Map& map, const Brightest& brightest) {
  for (const double part : {0.01, 0.02, 0.05, 0.1}) {
    const double threshold = std::max(part * brightest.value, leastOverMean * brightest.mean);
    if (std::optional<Region> region = grow(map, brightest, threshold)) return region;
  }
  return std::nullopt;
}

glm::vec3 meanOf(const Map& map, const std::vector<Texel>& texels) {
  glm::dvec3 sum(0);
  double weights = 0;
  for (const Texel& texel : texels) {
    sum += map.solidAngle(texel.y) * glm::dvec3(map.at(texel.x, texel.y));
    weights += map.solidAngle(texel.y);
  }
  return weights > 0 ? glm::vec3(sum / weights) : glm::vec3(0);
}

// Mean direction over the texel's bilinear tent, a vector shorter than 1 by half its variance.
glm::dvec3 tentMean(const Map& map, const Texel& texel) {
  constexpr int steps = 8;
  glm::dvec3 sum(0);
  double weights = 0;
  for (int j = 0; j < 2 * steps; ++j) {
    const double v = (j + 0.5) / steps - 1, row = texel.y + 0.5 + v;
    if (row < 0 || row > map.height) continue;
    const bool constant = (texel.y == 0 && v < 0) || (texel.y == map.height - 1 && v > 0);
    const double tent = (constant ? 1 : 1 - std::abs(v)) * std::sin(optics::pi * row / map.height);
    for (int i = 0; i < 2 * steps; ++i) {
      const double u = (i + 0.5) / steps - 1, weight = tent * (1 - std::abs(u));
      sum += weight * optics::directionFromEquirect({(texel.x + 0.5 + u) / map.width, 1 - row / map.height});
      weights += weight;
    }
  }
  return sum / weights;
}

}  // namespace

double Sun::solidAngle() const {
  const double half = std::sin(angularRadius / 2);
  return 4 * optics::pi * half * half;
}

std::optional<FoundSun> findSun(const Environment& environment) {
  if (environment.radiance.empty()) return std::nullopt;
  log::debug("looking for a sun in " + std::to_string(environment.width) + " x " + std::to_string(environment.height) +
             " texels");
  const Map map{environment};
  const Brightest brightest = findBrightest(map);
  if (!(brightest.value > leastOverMean * brightest.mean)) return std::nullopt;
  const std::optional<Region> region = growCompact(map, brightest);
  if (!region) return std::nullopt;
  const glm::vec3 fill = meanOf(map, region->around);
  glm::dvec3 taken(0), directions(0);
  double weights = 0;
  for (const Texel& texel : region->inside) {
    const glm::vec3& value = map.at(texel.x, texel.y);
    const glm::dvec3 irradiance =
        glm::dvec3(value - glm::min(value, fill)) * optics::equirectTentSolidAngle(texel.y, map.width, map.height);
    const double weight = irradiance.x + irradiance.y + irradiance.z;
    taken += irradiance;
    directions += weight * tentMean(map, texel);
    weights += weight;
  }
  if (std::max({taken.x, taken.y, taken.z}) < leastShare * brightest.mean * 4 * optics::pi) return std::nullopt;
  directions /= weights;
  const double length = glm::length(directions);
  FoundSun found;
  found.sun.direction = directions / length;
  // Of an even disc of radius a the mean direction is cos^2(a / 2) long.
  found.sun.angularRadius = 2 * std::acos(std::sqrt(std::clamp(length, 0.0, 1.0)));
  found.sun.irradiance = taken;
  found.rest = environment;
  for (const Texel& texel : region->inside) {
    glm::vec3& value = found.rest.radiance[map.index(texel.x, texel.y)];
    value = glm::min(value, fill);
  }
  return found;
}

}  // namespace facet::scene
