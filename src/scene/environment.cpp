#include "scene/environment.hpp"

#include <algorithm>
#include <atomic>
#include <cfloat>
#include <cmath>

#include "base/parallel.hpp"

namespace facet::scene {

namespace {

// NaN fails both comparisons.
bool valid(float x) { return x >= 0 && x <= FLT_MAX; }

bool isClean(const Environment& e) {
  constexpr size_t block = 1 << 16;  // texels
  const size_t count = e.radiance.size();
  std::atomic<bool> clean = true;
  parallelFor((count + block - 1) / block, [&](size_t b) {
    int bad = 0;  // no early exit: this loop runs as vectors
    for (size_t i = b * block; i < std::min(count, (b + 1) * block); ++i)
      for (int c = 0; c < 3; ++c) bad |= int(!valid(e.radiance[i][c]));
    if (bad) clean = false;
  });
  return clean;
}

}  // namespace

void mend(Environment& environment) {
  if (isClean(environment)) return;
  const std::vector<glm::vec3> given = environment.radiance;
  float largest = 0;
  for (const glm::vec3& texel : given)
    for (int c = 0; c < 3; ++c)
      if (valid(texel[c])) largest = std::max(largest, texel[c]);

  const auto hasNan = [](const glm::vec3& v) { return std::isnan(v.x) || std::isnan(v.y) || std::isnan(v.z); };
  const auto finite = [](const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); };
  const int w = environment.width, h = environment.height;
  // The mean of up to eight neighbours, around the seam but not over the poles.
  const auto fromNeighbours = [&](int x, int y) {
    glm::dvec3 sum(0);
    int count = 0;
    for (int ny = std::max(y - 1, 0); ny <= std::min(y + 1, h - 1); ++ny)
      for (int dx = -1; dx <= 1; ++dx) {
        const glm::vec3& neighbour = given[size_t(ny) * size_t(w) + size_t((x + dx + w) % w)];
        if (!finite(neighbour)) continue;
        sum += glm::max(glm::dvec3(neighbour), glm::dvec3(0));
        ++count;
      }
    return count > 0 ? glm::vec3(sum / double(count)) : glm::vec3(0);
  };
  for (size_t i = 0; i < given.size(); ++i) {
    glm::vec3& texel = environment.radiance[i];
    if (hasNan(texel)) {
      ++environment.nanTexels;
      texel = fromNeighbours(int(i % size_t(w)), int(i / size_t(w)));
      continue;
    }
    bool infinite = false, negative = false;
    for (int c = 0; c < 3; ++c) {
      if (std::isinf(texel[c]) && texel[c] > 0) texel[c] = largest, infinite = true;
      if (texel[c] < 0) texel[c] = 0, negative = true;
    }
    environment.infiniteTexels += infinite;
    environment.negativeTexels += negative;
  }
}

}  // namespace facet::scene
