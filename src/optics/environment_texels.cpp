#include "optics/environment_texels.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/parallel.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

// Mean of the channels, in the grid of the environment, spread over the neighbours.
std::vector<float> spreadMeans(const Environment& e) {
  const auto width = static_cast<size_t>(e.width), height = static_cast<size_t>(e.height);
  std::vector<float> along(width * height), all(width * height);
  const auto mean = [&](size_t i) {
    const glm::vec3& c = e.radiance[i];
    return c.x / 3 + c.y / 3 + c.z / 3;
  };
  parallelFor(height, [&](size_t y) {
    for (size_t x = 0; x < width; ++x) {
      const size_t left = (x + width - 1) % width, right = (x + 1) % width;
      along[y * width + x] =
          0.25f * mean(y * width + left) + 0.5f * mean(y * width + x) + 0.25f * mean(y * width + right);
    }
  });
  parallelFor(height, [&](size_t y) {
    const size_t up = y > 0 ? y - 1 : 0, down = std::min(y + 1, height - 1);
    for (size_t x = 0; x < width; ++x)
      all[y * width + x] =
          0.25f * along[up * width + x] + 0.5f * along[y * width + x] + 0.25f * along[down * width + x];
  });
  return all;
}

// Light of each texel of the table: the means of the environment's texels that it overlaps, by area.
std::vector<double> texelLight(const Environment& e, const TexelTable& table) {
  const std::vector<float> means = spreadMeans(e);
  std::vector<double> light(static_cast<size_t>(table.width) * static_cast<size_t>(table.height));
  struct Overlap {
    int first, last;  // texels of the environment
  };
  const auto overlap = [](int i, int ours, int theirs) {
    const int first = static_cast<int>(static_cast<int64_t>(i) * theirs / ours);
    const int last = static_cast<int>((static_cast<int64_t>(i + 1) * theirs - 1) / ours);
    return Overlap{first, std::clamp(last, first, theirs - 1)};
  };
  parallelFor(static_cast<size_t>(table.height), [&](size_t y) {
    const Overlap rows = overlap(static_cast<int>(y), table.height, e.height);
    const double solidAngle = equirectTexelSolidAngle(static_cast<int>(y), table.width, table.height);
    for (int x = 0; x < table.width; ++x) {
      const Overlap columns = overlap(x, table.width, e.width);
      double sum = 0;
      for (int row = rows.first; row <= rows.last; ++row)
        for (int column = columns.first; column <= columns.last; ++column)
          sum += static_cast<double>(
              means[static_cast<size_t>(row) * static_cast<size_t>(e.width) + static_cast<size_t>(column)]);
      const int count = (rows.last - rows.first + 1) * (columns.last - columns.first + 1);
      light[y * static_cast<size_t>(table.width) + static_cast<size_t>(x)] = sum / count * solidAngle;
    }
  });
  return light;
}

// Karlik et al. 2019, "MIS Compensation": directions that are no brighter than the mean are left to the lobes.
void withoutMean(std::vector<double>& light, const TexelTable& table) {
  const double mean = std::accumulate(light.begin(), light.end(), 0.0) / (4 * pi);
  for (size_t i = 0; i < light.size(); ++i) {
    const int row = static_cast<int>(i / static_cast<size_t>(table.width));
    light[i] = std::max(light[i] - mean * equirectTexelSolidAngle(row, table.width, table.height), 0.0);
  }
}

bool takeSecond(double first, double second, double& u) {
  const double share = first + second > 0 ? first / (first + second) : 0.5;
  const bool taken = u >= share;
  u = taken ? (u - share) / (1 - share) : u / share;
  u = std::clamp(u, 0.0, 1 - 1e-16);
  return taken;
}

}  // namespace

glm::ivec2 TexelTable::elements(int level) const {
  return {std::max(width >> (level + 1), 1), std::max(height >> (level + 1), 1)};
}

TexelTable texelTable(const Environment& environment, int largest) {
  TexelTable table;
  table.width = 4;
  while (table.width < environment.width && table.width < largest) table.width *= 2;
  table.height = table.width / 2;
  std::vector<double> light = texelLight(environment, table);
  withoutMean(light, table);
  double sum = std::accumulate(light.begin(), light.end(), 0.0);
  if (!(sum > 0)) {
    for (size_t i = 0; i < light.size(); ++i)
      light[i] =
          equirectTexelSolidAngle(static_cast<int>(i / static_cast<size_t>(table.width)), table.width, table.height);
    sum = 4 * pi;
  }
  int width = table.width, height = table.height;
  while (true) {
    const int across = std::max(width / 2, 1), down = std::max(height / 2, 1);
    std::vector<glm::vec4> level(static_cast<size_t>(across) * static_cast<size_t>(down));
    std::vector<double> sums(level.size());
    const auto at = [&](int x, int y) {
      return x < width && y < height
                 ? light[static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x)]
                 : 0.0;
    };
    for (int y = 0; y < down; ++y)
      for (int x = 0; x < across; ++x) {
        const glm::dvec4 four(at(2 * x, 2 * y), at(2 * x + 1, 2 * y), at(2 * x, 2 * y + 1), at(2 * x + 1, 2 * y + 1));
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(across) + static_cast<size_t>(x);
        level[i] = glm::vec4(four / sum);
        sums[i] = four.x + four.y + four.z + four.w;
      }
    table.levels.push_back(std::move(level));
    light = std::move(sums);
    if (across == 1 && down == 1) return table;
    width = across, height = down;
  }
}

double texelDensity(const TexelTable& table, const glm::dvec3& direction) {
  const glm::dvec2 uv = equirectFromDirection(direction);
  const int x = std::clamp(static_cast<int>(uv.x * table.width), 0, table.width - 1);
  const int y = std::clamp(static_cast<int>((1 - uv.y) * table.height), 0, table.height - 1);
  const glm::ivec2 size = table.elements(0);
  const glm::vec4& shares =
      table.levels[0][static_cast<size_t>(y / 2) * static_cast<size_t>(size.x) + static_cast<size_t>(x / 2)];
  return static_cast<double>(shares[(x & 1) + 2 * (y & 1)]) / equirectTexelSolidAngle(y, table.width, table.height);
}

TexelSample sampleTexels(const TexelTable& table, glm::dvec2 u) {
  glm::ivec2 texel(0);
  double share = 0;
  for (int level = static_cast<int>(table.levels.size()) - 1; level >= 0; --level) {
    const glm::dvec4 shares(
        table.levels[static_cast<size_t>(level)][static_cast<size_t>(texel.y * table.elements(level).x + texel.x)]);
    const bool lower = takeSecond(shares.x + shares.y, shares.z + shares.w, u.y);
    const glm::dvec2 row = lower ? glm::dvec2(shares.z, shares.w) : glm::dvec2(shares);
    const bool right = takeSecond(row.x, row.y, u.x);
    share = right ? row.y : row.x;
    texel = 2 * texel + glm::ivec2(right, lower);
  }
  const double top = std::sin(pi * (0.5 - static_cast<double>(texel.y) / table.height));
  const double bottom = std::sin(pi * (0.5 - static_cast<double>(texel.y + 1) / table.height));
  const double y = glm::mix(top, bottom, u.y), across = std::sqrt(std::max(1 - y * y, 0.0));
  const double azimuth = 2 * pi * ((texel.x + u.x) / table.width - 0.5);
  return {{across * std::cos(azimuth), y, across * std::sin(azimuth)},
          share / equirectTexelSolidAngle(texel.y, table.width, table.height)};
}

}  // namespace facet::optics
