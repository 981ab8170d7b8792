#pragma once

// What closed surfaces of triangles enclose, and whether they are closed.

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "scene/shapes.hpp"

namespace facet::test {

template <class Add>
void eachTriangle(const scene::Shape& shape, const Add& add) {
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    const auto at = [&](size_t k) { return glm::dvec3(shape.positions.at(shape.indices[i + k])); };
    add(at(0), at(1), at(2));
  }
}

// By the divergence theorem; positive where triangles are counter-clockwise from outside.
inline double volumeOf(const scene::Shape& shape) {
  double volume = 0;
  eachTriangle(shape, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    volume += glm::dot(a, glm::cross(b, c)) / 6;
  });
  return volume;
}

inline double areaOf(const scene::Shape& shape) {
  double area = 0;
  eachTriangle(shape, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    area += glm::length(glm::cross(b - a, c - a)) / 2;
  });
  return area;
}

// Each edge is there as often in one direction as in the other, vertices at one place being one: 0 where all are.
inline size_t openEdges(const scene::Shape& shape) {
  using Place = std::array<long, 3>;
  const auto place = [](const glm::dvec3& p) {
    return Place{std::lround(p.x * 1e5), std::lround(p.y * 1e5), std::lround(p.z * 1e5)};
  };
  std::map<std::pair<Place, Place>, int> edges;
  eachTriangle(shape, [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const Place corners[] = {place(a), place(b), place(c)};
    for (size_t k = 0; k < 3; ++k) {
      const Place &from = corners[k], &to = corners[(k + 1) % 3];
      if (from < to) ++edges[{from, to}];
      if (to < from) --edges[{to, from}];
    }
  });
  return static_cast<size_t>(std::ranges::count_if(edges, [](const auto& edge) { return edge.second != 0; }));
}

}  // namespace facet::test
