#include "scene/geometry.hpp"

#include <cmath>
#include <string>

#include "base/parallel.hpp"
#include "scene/tangents.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

namespace {

size_t cornerCount(const Primitive& p) { return p.indices.empty() ? p.positions.size() : p.indices.size(); }

uint32_t corner(const Primitive& p, size_t i) { return p.indices.empty() ? uint32_t(i) : p.indices[i]; }

std::vector<uint32_t> listIndices(const Primitive& p) {
  const size_t n = cornerCount(p);
  std::vector<uint32_t> list;
  const auto add = [&](auto... corners) { (list.push_back(corner(p, corners)), ...); };
  switch (p.topology) {
    case Topology::triangleStrip:
      // The spec's order (i, i + (1 + i % 2), i + (2 - i % 2)) keeps the first corner, the winding alternates.
      for (size_t i = 0; i + 2 < n; ++i) add(i, i + 1 + i % 2, i + 2 - i % 2);
      break;
    case Topology::triangleFan:
      for (size_t i = 1; i + 1 < n; ++i) add(i, i + 1, size_t{0});
      break;
    case Topology::lineStrip:
    case Topology::lineLoop:
      for (size_t i = 0; i + 1 < n; ++i) add(i, i + 1);
      if (p.topology == Topology::lineLoop && n > 2) add(n - 1, size_t{0});
      break;
    default:
      break;
  }
  return list;
}

// What is left of a primitive with too few corners.
Primitive nothing(const Primitive& p) {
  Primitive empty;
  empty.topology = p.topology;
  empty.material = p.material;
  return empty;
}

template <class T>
void gather(std::vector<T>& values, const std::vector<uint32_t>& indices) {
  if (values.empty()) return;
  std::vector<T> gathered;
  gathered.reserve(indices.size());
  for (const uint32_t i : indices) gathered.push_back(values[i]);
  values = std::move(gathered);
}

// In double precision: single loses triangles below 1e-19 m to underflow.
glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const double length = glm::length(n);
  return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0, 0, 1);
}

// Warning or empty.
std::string completePrimitive(Primitive& p, const Material& material) {
  std::string warning;
  if (hasTriangles(p.topology) && !material.unlit && !p.positions.empty()) {
    if (p.normals.empty()) p = withFlatNormals(p);
    if (p.tangents.empty() && usesTexture(material, TextureSlot::normal)) {
      if (usesTexture(material, p, TextureSlot::normal))
        p = withTangents(p, material.normal.texCoord);
      else
        warning = "the normal texture needs TEXCOORD_" + std::to_string(material.normal.texCoord) +
                  ", which is missing; the texture is not used";
    }
  }
  p.bounds = bounds(p);
  return warning;
}

}  // namespace

bool hasTriangles(Topology topology) { return topology >= Topology::triangles; }

Bounds bounds(const Primitive& primitive) {
  Bounds box;
  if (primitive.indices.empty())
    for (const glm::vec3& p : primitive.positions) box.add(p);
  else
    for (const uint32_t i : primitive.indices) box.add(primitive.positions[i]);
  return box;
}

Primitive asList(const Primitive& primitive) {
  Primitive list = primitive;
  const bool strips = hasTriangles(primitive.topology) ? primitive.topology != Topology::triangles
                                                       : primitive.topology > Topology::lines;
  if (strips) {
    list.indices = listIndices(primitive);
    list.topology = hasTriangles(primitive.topology) ? Topology::triangles : Topology::lines;
    return list.indices.empty() ? nothing(list) : list;
  }
  const size_t per = primitive.topology == Topology::triangles ? 3 : primitive.topology == Topology::lines ? 2 : 1;
  const size_t whole = cornerCount(primitive) / per * per;
  if (whole == cornerCount(primitive)) return list;
  list.indices.resize(whole);
  for (size_t i = 0; i < whole; ++i) list.indices[i] = corner(primitive, i);
  return whole == 0 ? nothing(list) : list;
}

Primitive unwelded(const Primitive& primitive) {
  Primitive p = asList(primitive);
  if (p.indices.empty()) return p;
  const std::vector<uint32_t> indices = std::move(p.indices);
  p.indices.clear();
  gather(p.positions, indices);
  gather(p.normals, indices);
  gather(p.tangents, indices);
  for (std::vector<glm::vec2>& set : p.texCoords) gather(set, indices);
  gather(p.colors, indices);
  return p;
}

Primitive withFlatNormals(const Primitive& primitive) {
  if (!hasTriangles(primitive.topology)) return primitive;
  Primitive p = unwelded(primitive);
  p.tangents.clear();
  p.normals.resize(p.positions.size());
  for (size_t i = 0; i + 2 < p.positions.size(); i += 3)
    p.normals[i] = p.normals[i + 1] = p.normals[i + 2] =
        faceNormal(p.positions[i], p.positions[i + 1], p.positions[i + 2]);
  return p;
}

void completeGeometry(Model& model, Notes& notes, int scene) {
  struct Job {
    size_t mesh, primitive;
    std::string warning;
  };
  const std::vector<bool> drawn = scene < 0 ? std::vector<bool>(model.meshes.size(), true) : drawnMeshes(model, scene);
  std::vector<Job> jobs;
  for (size_t m = 0; m < model.meshes.size(); ++m)
    for (size_t i = 0; drawn[m] && i < model.meshes[m].primitives.size(); ++i) jobs.push_back({m, i, {}});

  parallelFor(jobs.size(), [&](size_t j) {
    Primitive& p = model.meshes[jobs[j].mesh].primitives[jobs[j].primitive];
    jobs[j].warning = completePrimitive(p, materialOf(model, p));
  });
  for (Job& job : jobs)
    if (!job.warning.empty())
      notes.push_back({Note::Severity::warning,
                       "/meshes/" + std::to_string(job.mesh) + "/primitives/" + std::to_string(job.primitive),
                       std::move(job.warning)});
}

}  // namespace facet::scene
