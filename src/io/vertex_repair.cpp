#include "io/vertex_repair.hpp"

#include <cmath>

namespace facet::io {

namespace {

// Quantised unit vectors stay within this; 8-bit ones are off by 0.7 % at most.
constexpr float lengthTolerance = 0.01f;

// In double, so that components near the ends of single precision neither vanish nor overflow when squared.
double length(const glm::vec3& v) { return glm::length(glm::dvec3(v)); }

// Normalises and counts; false if there is no direction.
bool makeUnit(glm::vec3& v, Repairs& repairs) {
  // Nearly every vector: unit already, to single precision.
  const float squared = glm::dot(v, v);
  if (std::abs(squared - 1.0f) < 1e-6f) return true;
  const double size = length(v);
  if (!(size > 0) || !std::isfinite(size)) return false;
  if (std::abs(size - 1) > static_cast<double>(lengthTolerance)) ++repairs.normalised;
  v = glm::vec3(glm::dvec3(v) / size);
  return true;
}

template <class Visit>
void forEachTriangle(const scene::Primitive& p, const Visit& visit) {
  const size_t count = p.indices.empty() ? p.positions.size() : p.indices.size();
  const auto at = [&](size_t i) { return p.indices.empty() ? i : p.indices[i]; };
  if (p.topology == scene::Topology::triangles) {
    for (size_t i = 0; i + 2 < count; i += 3) visit(at(i), at(i + 1), at(i + 2));
  } else if (p.topology == scene::Topology::triangleStrip) {
    for (size_t i = 0; i + 2 < count; ++i) visit(at(i), at(i + 1 + i % 2), at(i + 2 - i % 2));
  } else if (p.topology == scene::Topology::triangleFan) {
    for (size_t i = 1; i + 1 < count; ++i) visit(at(0), at(i), at(i + 1));
  }
}

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited", eq. 4 (first vector); valid for every unit n.
glm::vec3 perpendicular(const glm::vec3& n) {
  const float sign = std::copysign(1.0f, n.z);
  const float a = -1.0f / (sign + n.z);
  return {1.0f + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

}  // namespace

Repairs repairNormals(scene::Primitive& primitive) {
  Repairs repairs;
  std::vector<char> bad;
  for (size_t i = 0; i < primitive.normals.size(); ++i) {
    if (makeUnit(primitive.normals[i], repairs)) continue;
    if (bad.empty()) bad.resize(primitive.normals.size());
    bad[i] = 1;
    ++repairs.replaced;
  }
  if (bad.empty()) return repairs;
  std::vector<glm::dvec3> sums(primitive.normals.size(), glm::dvec3(0));
  forEachTriangle(primitive, [&](size_t a, size_t b, size_t c) {
    if (!bad[a] && !bad[b] && !bad[c]) return;
    const glm::dvec3 p(primitive.positions[a]), q(primitive.positions[b]), r(primitive.positions[c]);
    const glm::dvec3 normal = glm::cross(q - p, r - p);
    sums[a] += normal, sums[b] += normal, sums[c] += normal;
  });
  for (size_t i = 0; i < bad.size(); ++i) {
    if (!bad[i]) continue;
    const double size = glm::length(sums[i]);
    primitive.normals[i] = size > 0 && std::isfinite(size) ? glm::vec3(sums[i] / size) : glm::vec3(0, 0, 1);
  }
  return repairs;
}

Repairs repairTangents(scene::Primitive& primitive) {
  Repairs repairs;
  for (size_t i = 0; i < primitive.tangents.size(); ++i) {
    glm::vec4& tangent = primitive.tangents[i];
    glm::vec3 direction(tangent);
    if (!makeUnit(direction, repairs)) {
      ++repairs.replaced;
      direction = perpendicular(primitive.normals[i]);
    }
    tangent = glm::vec4(direction, tangent.w < 0 ? -1.0f : 1.0f);
  }
  return repairs;
}

}  // namespace facet::io
