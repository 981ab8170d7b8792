#include "scene/height_map.hpp"

#include <algorithm>
#include <cassert>

#include "base/parallel.hpp"

namespace facet::scene {

namespace {

// The two texels whose difference is the slope at i, and how many texels lie between them.
struct Span {
  int before, after;
  float texels;
};

Span spanAt(int i, int count, bool wrap) {
  if (wrap) return {(i + count - 1) % count, (i + 1) % count, 2};
  const int before = std::max(i - 1, 0), after = std::min(i + 1, count - 1);
  return {before, after, static_cast<float>(std::max(after - before, 1))};
}

}  // namespace

std::vector<glm::vec3> normalsOf(const HeightMap& map, bool wrap) {
  const auto width = static_cast<size_t>(map.width), rows = static_cast<size_t>(map.height);
  assert(map.heights.size() == width * rows);
  std::vector<glm::vec3> normals(width * rows);
  const auto at = [&](int x, int y) { return map.heights[static_cast<size_t>(y) * width + static_cast<size_t>(x)]; };
  const auto texelsPerWidth = static_cast<float>(map.width);
  parallelFor(rows, [&](size_t row) {
    const int y = static_cast<int>(row);
    const Span down = spanAt(y, map.height, wrap);
    for (int x = 0; x < map.width; ++x) {
      const Span right = spanAt(x, map.width, wrap);
      const float slopeX = (at(right.after, y) - at(right.before, y)) / right.texels * texelsPerWidth;
      const float slopeDown = (at(x, down.after) - at(x, down.before)) / down.texels * texelsPerWidth;
      normals[row * width + static_cast<size_t>(x)] = glm::normalize(glm::vec3(-slopeX, slopeDown, 1));
    }
  });
  return normals;
}

}  // namespace facet::scene
