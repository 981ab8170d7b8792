#include "scene/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "base/parallel.hpp"
#include "scene/tangents.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

size_t cornerCount(const Primitive& p) { return p.indices.empty() ? p.positions.size() : p.indices.size(); }

namespace {

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
  empty.variantMaterials = p.variantMaterials;
  return empty;
}

// `per` values for each vertex.
template <class T>
void gather(std::vector<T>& values, const std::vector<uint32_t>& source, size_t per = 1) {
  if (values.empty()) return;
  std::vector<T> gathered;
  gathered.reserve(source.size() * per);
  for (const uint32_t v : source)
    for (size_t i = 0; i < per; ++i) gathered.push_back(values[v * per + i]);
  values = std::move(gathered);
}

// In double precision: single loses triangles below 1e-19 m to underflow.
glm::vec3 faceNormal(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  const glm::dvec3 n = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
  const double length = glm::length(n);
  return length > 0 && std::isfinite(length) ? glm::vec3(n / length) : glm::vec3(0, 0, 1);
}

using Warnings = std::vector<std::string>;

// Where the textures whose directions lie in tangent space have their coordinates from.
struct TangentSpace {
  int set = 0;
  TextureTransform transform = {};
};

// A positive scale and an offset leave the direction of u where it is.
bool sameDirections(const TextureTransform& a, const TextureTransform& b) {
  const glm::dmat3x2 m = uvFromTexCoord(a), n = uvFromTexCoord(b);
  const auto along = [](const glm::dmat3x2& matrix) {  // of growing u, up to a factor: the inverse's first column
    const double determinant = matrix[0].x * matrix[1].y - matrix[1].x * matrix[0].y;
    return glm::dvec3(glm::dvec2(matrix[1].y, -matrix[0].y) * (determinant < 0 ? -1.0 : 1.0), determinant < 0 ? -1 : 1);
  };
  const glm::dvec3 u = along(m), v = along(n);
  const double lengths = glm::length(glm::dvec2(u)) * glm::length(glm::dvec2(v));
  return u.z == v.z && glm::dot(glm::dvec2(u), glm::dvec2(v)) >= (1 - 1e-9) * lengths;
}

bool same(const TangentSpace& a, const TangentSpace& b) {
  return a.set == b.set && sameDirections(a.transform, b.transform);
}

// Of the normal texture, the coat's and the anisotropy's; none where no material has it or its coordinates are missing.
using TangentSpaces = std::array<std::optional<TangentSpace>, 3>;
static_assert(static_cast<int>(TangentsOf::grain) == 2);

TangentSpaces tangentSpaces(const Primitive& p, const std::vector<const Material*>& materials, Warnings& warnings) {
  TangentSpaces spaces;
  bool missing = false;
  const auto add = [&](TangentsOf which, const TextureRef& ref, bool uses) {
    if (!uses) return true;
    const bool present =
        ref.texCoord >= 0 && ref.texCoord < maxTexCoordSets && !p.texCoords[size_t(ref.texCoord)].empty();
    std::optional<TangentSpace>& space = spaces[size_t(which)];
    if (present && space && !same(*space, {ref.texCoord, ref.transform})) {
      const std::string told =
          "the variants' materials have such a texture in different coordinates: the tangents of all are those of "
          "TEXCOORD_" +
          std::to_string(space->set);
      if (std::ranges::find(warnings, told) == warnings.end()) warnings.push_back(told);
    }
    if (present && !space) space = TangentSpace{ref.texCoord, ref.transform};
    return present;
  };
  for (const Material* m : materials) {
    add(TangentsOf::surface, m->normal, usesTexture(*m, TextureSlot::normal));
    add(TangentsOf::coat, m->clearcoatNormal, usesTexture(*m, TextureSlot::clearcoatNormal));
    const bool anisotropic = !m->unlit && !m->specularGlossiness && has(*m, Effect::anisotropy);
    if (!add(TangentsOf::grain, m->anisotropy ? m->anisotropy : TextureRef(), anisotropic)) missing = true;
  }
  const bool none = std::ranges::none_of(spaces, [](const auto& space) { return space.has_value(); });
  if (missing && none)
    warnings.emplace_back("an anisotropic material needs tangents or texture coordinates; it is shown isotropic");
  return spaces;
}

// The first of the textures gets Primitive::tangents, and with it those whose directions are the same.
void addTangents(Primitive& p, const std::vector<const Material*>& materials, Warnings& warnings) {
  const TangentSpaces spaces = tangentSpaces(p, materials, warnings);
  const TangentSpace* first = nullptr;
  for (const TangentsOf which : {TangentsOf::surface, TangentsOf::coat, TangentsOf::grain}) {
    const std::optional<TangentSpace>& space = spaces[size_t(which)];
    if (!space || (first && same(*first, *space))) continue;
    p = withTangents(std::move(p), space->set, space->transform, first ? which : TangentsOf::surface);
    if (!first) first = &*space;
  }
}

// What lines and points are not lit with for want of normals or tangents can't be missed (glTF 2.0, 3.7.2.1).
bool canRead(const Primitive& p, TextureSlot slot) {
  if (hasTriangles(p.topology)) return true;
  const bool directions = slot == TextureSlot::normal || slot == TextureSlot::clearcoatNormal;
  return slot == TextureSlot::baseColor || (!p.normals.empty() && (!directions || !p.tangents.empty()));
}

// Once for each slot, whichever material it is.
void noteMissingCoordinates(const Primitive& p, const std::vector<const Material*>& materials, Warnings& warnings) {
  for (const TextureSlot slot : textureSlots)
    for (const Material* m : materials) {
      if (!canRead(p, slot) || !usesTexture(*m, slot) || usesTexture(*m, p, slot)) continue;
      warnings.push_back(std::string("the ") + name(slot) + " needs TEXCOORD_" +
                         std::to_string(textureRef(*m, slot).texCoord) + ", which is missing; the texture is not used");
      break;
    }
}

template <class Use>
void forEachDrawn(const Primitive& p, const Use& use) {
  for (size_t i = 0; i < cornerCount(p); ++i) use(size_t(corner(p, i)));
}

// Calls use(vertex, joint) for each share of what is drawn.
template <class Use>
void forEachShare(const Primitive& p, const Use& use) {
  const auto per = size_t(p.influencesPerVertex);
  forEachDrawn(p, [&](size_t v) {
    for (size_t i = v * per; i < (v + 1) * per; ++i)
      if (p.influences[i].weight > 0) use(v, size_t(p.influences[i].joint));
  });
}

// Counted before they are made: growing would take room for up to twice as many.
void addJointBounds(Primitive& p) {
  p.jointBounds = {};
  if (p.influences.empty()) return;
  size_t count = 0;
  forEachShare(p, [&](size_t, size_t joint) { count = std::max(count, joint + 1); });
  p.jointBounds.resize(count);
  forEachShare(p, [&](size_t v, size_t joint) { p.jointBounds[joint].add(p.positions[v]); });
}

void addBounds(Primitive& p) {
  p.bounds = bounds(p);
  for (MorphTarget& target : p.targets) {
    target.bounds = {};
    if (!target.positions.empty()) forEachDrawn(p, [&](size_t v) { target.bounds.add(target.positions[v]); });
  }
  addJointBounds(p);
}

void completePrimitive(Primitive& p, const std::vector<const Material*>& materials, Warnings& warnings) {
  noteMissingCoordinates(p, materials, warnings);
  const bool lit = std::ranges::any_of(materials, [](const Material* m) { return !m->unlit; });
  if (hasTriangles(p.topology) && lit && !p.positions.empty()) {
    if (p.normals.empty()) p = withFlatNormals(std::move(p));
    if (p.tangents.empty()) addTangents(p, materials, warnings);
  }
  addBounds(p);
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

Primitive asList(Primitive p) {
  const bool strips = hasTriangles(p.topology) ? p.topology != Topology::triangles : p.topology > Topology::lines;
  if (strips) {
    p.indices = listIndices(p);
    p.topology = hasTriangles(p.topology) ? Topology::triangles : Topology::lines;
    return p.indices.empty() ? nothing(p) : p;
  }
  const size_t per = p.topology == Topology::triangles ? 3 : p.topology == Topology::lines ? 2 : 1;
  const size_t whole = cornerCount(p) / per * per;
  if (whole == cornerCount(p)) return p;
  if (whole == 0) return nothing(p);
  const size_t given = p.indices.size();
  p.indices.resize(whole);
  for (size_t i = given; i < whole; ++i) p.indices[i] = uint32_t(i);
  return p;
}

void gatherVertices(Primitive& p, const std::vector<uint32_t>& source) {
  gather(p.positions, source);
  gather(p.normals, source);
  for (auto* tangents : {&p.tangents, &p.coatTangents, &p.grainTangents}) gather(*tangents, source);
  for (std::vector<glm::vec2>& set : p.texCoords) gather(set, source);
  gather(p.colors, source);
  gather(p.influences, source, size_t(p.influencesPerVertex));
  for (MorphTarget& target : p.targets) {
    gather(target.positions, source);
    gather(target.normals, source);
    for (auto* tangents : {&target.tangents, &target.coatTangents, &target.grainTangents}) gather(*tangents, source);
    for (std::vector<glm::vec2>& set : target.texCoords) gather(set, source);
    gather(target.colors, source);
  }
}

Primitive unwelded(Primitive primitive) {
  Primitive p = asList(std::move(primitive));
  if (p.indices.empty()) return p;
  gatherVertices(p, std::exchange(p.indices, {}));
  return p;
}

Primitive withFlatNormals(Primitive primitive) {
  if (!hasTriangles(primitive.topology)) return primitive;
  for (MorphTarget& target : primitive.targets) target.normals = target.tangents = {};
  primitive.normals = {};
  primitive.tangents = {};
  Primitive p = unwelded(std::move(primitive));
  p.flatNormals = true;
  p.normals.resize(p.positions.size());
  for (size_t i = 0; i + 2 < p.positions.size(); i += 3)
    p.normals[i] = p.normals[i + 1] = p.normals[i + 2] =
        faceNormal(p.positions[i], p.positions[i + 1], p.positions[i + 2]);
  return p;
}

void completeGeometry(Model& model, Notes& notes, int scene, bool editable) {
  struct Job {
    size_t mesh, primitive;
    Warnings warnings;
  };
  const std::vector<bool> drawn = scene < 0 ? std::vector<bool>(model.meshes.size(), true) : drawnMeshes(model, scene);
  const std::vector<Material> materials = materialsOverTime(model);
  std::vector<Material> edited;
  if (editable)
    for (const Material& material : materials) edited.push_back(ofAnyValue(material));
  std::vector<Job> jobs;
  for (size_t m = 0; m < model.meshes.size(); ++m)
    for (size_t i = 0; drawn[m] && i < model.meshes[m].primitives.size(); ++i) jobs.push_back({m, i, {}});

  parallelFor(jobs.size(), [&](size_t j) {
    Primitive& p = model.meshes[jobs[j].mesh].primitives[jobs[j].primitive];
    completePrimitive(p, materialsOf(materials, p), jobs[j].warnings);
    Warnings unseen;  // of what no material shows yet
    if (editable && p.tangents.empty()) completePrimitive(p, materialsOf(edited, p), unseen);
  });
  for (Job& job : jobs)
    for (std::string& warning : job.warnings)
      notes.push_back({Note::Severity::warning,
                       "/meshes/" + std::to_string(job.mesh) + "/primitives/" + std::to_string(job.primitive),
                       std::move(warning)});
}

}  // namespace facet::scene
