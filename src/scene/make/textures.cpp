#include "scene/make/textures.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "base/hash.hpp"
#include "base/parallel.hpp"

namespace facet::scene {

namespace {

// Of a corner of the torus' cells.
uint32_t bitsAt(int x, int y, int period, uint32_t seed) {
  const auto wrapped = [period](int i) { return static_cast<uint32_t>((i % period + period) % period); };
  return mixedBits(wrapped(x) + mixedBits(wrapped(y) + mixedBits(seed)));
}
double shareOf(uint32_t bits) { return bits / 4294967296.0; }

double fade(double t) { return t * t * t * (t * (6 * t - 15) + 10); }  // Perlin 2002

struct Cell {
  int x, y;
  double s, t;  // within
};
Cell cellOf(const glm::dvec2& u) {
  const double x = std::floor(u.x), y = std::floor(u.y);
  return {static_cast<int>(x), static_cast<int>(y), u.x - x, u.y - y};
}

template <class Corner>
double between(const Cell& c, const Corner& corner) {
  const double s = fade(c.s), t = fade(c.t);
  return glm::mix(glm::mix(corner(0, 0), corner(1, 0), s), glm::mix(corner(0, 1), corner(1, 1), s), t);
}

template <class Height>
HeightMap heights(int size, const Height& height) {
  HeightMap map{size, size, std::vector<float>(static_cast<size_t>(size) * static_cast<size_t>(size))};
  parallelFor(static_cast<size_t>(size), [&](size_t y) {
    for (int x = 0; x < size; ++x)
      map.heights[y * static_cast<size_t>(size) + static_cast<size_t>(x)] =
          static_cast<float>(height(glm::dvec2(x + 0.5, static_cast<double>(y) + 0.5) / static_cast<double>(size)));
  });
  return map;
}

template <class Color>
RgbTexels colors(int size, const Color& color) {
  RgbTexels texels{size, size, std::vector<uint8_t>(static_cast<size_t>(size) * static_cast<size_t>(size) * 3)};
  parallelFor(static_cast<size_t>(size), [&](size_t y) {
    for (int x = 0; x < size; ++x) {
      const glm::dvec3 c = color(glm::dvec2(x + 0.5, static_cast<double>(y) + 0.5) / static_cast<double>(size));
      for (int k = 0; k < 3; ++k)
        texels.rgb[(y * static_cast<size_t>(size) + static_cast<size_t>(x)) * 3 + static_cast<size_t>(k)] =
            static_cast<uint8_t>(std::lround(255 * std::clamp(c[k], 0.0, 1.0)));
    }
  });
  return texels;
}

double smoothStep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

constexpr int bricksAlong = 4, courses = 8;
constexpr double mortar = 0.006, bevel = 0.008;  // of the map's width

struct BrickPlace {
  int brick, course;
  double edge;  // distance to the brick's border, in widths of the map; below 0: mortar
};
BrickPlace brickAt(const glm::dvec2& u) {
  const double row = u.y * courses;
  const int course = static_cast<int>(row);
  const double along = u.x * bricksAlong + (course % 2) * 0.5, x = along - std::floor(along), y = row - course;
  const double edge = std::min(std::min(x, 1 - x) / bricksAlong, std::min(y, 1 - y) / courses) - mortar;
  return {static_cast<int>(std::floor(along)) % bricksAlong, course, edge};
}

}  // namespace

double valueNoise(const glm::dvec2& u, int period, uint32_t seed) {
  const Cell c = cellOf(u);
  return between(c, [&](int i, int j) { return shareOf(bitsAt(c.x + i, c.y + j, period, seed)); });
}

double gradientNoise(const glm::dvec2& u, int period, uint32_t seed) {
  const Cell c = cellOf(u);
  const double value = between(c, [&](int i, int j) {
    const double angle = 2 * pi * shareOf(bitsAt(c.x + i, c.y + j, period, seed));
    return std::cos(angle) * (c.s - i) + std::sin(angle) * (c.t - j);
  });
  return value * std::sqrt(2.0);  // unit gradients reach 1 / sqrt(2) in a cell's middle
}

double cellularNoise(const glm::dvec2& u, int period, uint32_t seed) {
  const Cell c = cellOf(u);
  double nearest = 8;
  for (int j = -1; j <= 1; ++j)
    for (int i = -1; i <= 1; ++i) {
      const uint32_t bits = bitsAt(c.x + i, c.y + j, period, seed);
      const glm::dvec2 point(i + shareOf(bits), j + shareOf(mixedBits(bits + 1)));
      nearest = std::min(nearest, glm::distance(point, glm::dvec2(c.s, c.t)));
    }
  return nearest;
}

double fractalNoise(const glm::dvec2& u, int period, int octaves, uint32_t seed) {
  double sum = 0, weight = 1, frequency = 1;
  for (int i = 0; i < octaves; ++i, weight /= 2, frequency *= 2)
    sum += weight * gradientNoise(u * frequency, static_cast<int>(period * frequency), seed + static_cast<uint32_t>(i));
  return sum;
}

RgbTexels normalTexels(const HeightMap& map) {
  RgbTexels texels{map.width, map.height, {}};
  for (const glm::vec3& n : normalsOf(map, true))
    for (int c = 0; c < 3; ++c) texels.rgb.push_back(static_cast<uint8_t>(std::lround(127.5f * (n[c] + 1))));
  return texels;
}

HeightMap treadPlateHeights(int size) {
  return heights(size, [](const glm::dvec2& u) {
    constexpr int cells = 8;
    const glm::dvec2 place = u * static_cast<double>(cells);
    const glm::dvec2 cell = glm::floor(place), at = place - cell - 0.5;
    // Lozenges lean to the right and to the left in turn.
    const double lean = (static_cast<int>(cell.x) + static_cast<int>(cell.y)) % 2 == 0 ? 1 : -1;
    const glm::dvec2 along((at.x + lean * at.y) / std::sqrt(2.0), (at.y - lean * at.x) / std::sqrt(2.0));
    const double inside = 1 - std::hypot(along.x / 0.46, along.y / 0.13);
    return 0.006 * smoothStep(0, 0.5, inside);
  });
}

HeightMap brickHeights(int size, uint32_t seed) {
  return heights(size, [seed](const glm::dvec2& u) {
    const BrickPlace place = brickAt(u);
    const double pits =
        smoothStep(0.25, 0, cellularNoise(u * 32.0, 32, seed)) * (valueNoise(u * 8.0, 8, seed + 9) > 0.55 ? 1 : 0.2);
    const double grain = fractalNoise(u * 16.0, 16, 3, seed + 5);
    const double brick = 0.008 * smoothStep(-bevel / 4, bevel, place.edge);
    return brick + (place.edge > 0 ? 0.0008 * grain - 0.002 * pits : 0.0006 * grain);
  });
}

RgbTexels brickColors(int size, uint32_t seed) {
  return colors(size, [seed](const glm::dvec2& u) {
    const BrickPlace place = brickAt(u);
    const uint32_t own = bitsAt(place.brick, place.course, 64, seed);
    const double shade = 0.8 + 0.35 * shareOf(own), grain = 1 + 0.12 * fractalNoise(u * 16.0, 16, 3, seed + 5);
    const glm::dvec3 clay =
        glm::mix(glm::dvec3(0.60, 0.30, 0.22), glm::dvec3(0.48, 0.22, 0.18), shareOf(mixedBits(own)));
    const double stone = smoothStep(-0.002, 0.002, place.edge);
    return glm::mix(glm::dvec3(0.62, 0.60, 0.57) * grain, clay * shade * grain, stone);
  });
}

RgbTexels concreteColors(int size, uint32_t seed) {
  return colors(size, [seed](const glm::dvec2& u) {
    const double stain = fractalNoise(u * 4.0, 4, 4, seed), grain = fractalNoise(u * 32.0, 32, 2, seed + 7);
    return glm::dvec3(0.58, 0.57, 0.55) * (1 + 0.14 * stain + 0.05 * grain);
  });
}

HeightMap concreteHeights(int size, uint32_t seed) {
  return heights(size, [seed](const glm::dvec2& u) {
    const double hole = smoothStep(0.16, 0.05, cellularNoise(u * 12.0, 12, seed));
    return 0.0008 * fractalNoise(u * 16.0, 16, 3, seed + 3) - 0.0025 * hole;
  });
}

}  // namespace facet::scene
