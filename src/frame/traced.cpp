#include "frame/traced.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <tuple>

#include "scene/pick.hpp"

namespace facet::frame {

namespace {

using shading::Feature;

// Copies of a primitive's triangles in the world instead of a tree of its own that rays are taken to.
constexpr size_t mostCopied = size_t{1} << 16;

bool deforms(const Draw& draw) {
  return shading::usesFeature(draw.key, Feature::skin) || shading::usesFeature(draw.key, Feature::morphTargets);
}

glm::mat4 skinMatrix(const DrawList& list, const layout::Instance& instance, const scene::Primitive& p, size_t vertex) {
  glm::vec4 rows[3] = {};
  const auto count = static_cast<size_t>(p.influencesPerVertex);
  for (const scene::Influence& influence : std::span(p.influences).subspan(vertex * count, count))
    for (int row = 0; row < 3; ++row)
      rows[row] += influence.weight * list.joints[instance.deformation.x + influence.joint].rows[row];
  return glm::transpose(glm::mat4(rows[0], rows[1], rows[2], glm::vec4(0, 0, 0, 1)));
}

template <class T>
void addOffsets(std::vector<T>& values, const std::vector<T>& offsets, float weight) {
  for (size_t v = 0; v < offsets.size() && v < values.size(); ++v) values[v] += weight * offsets[v];
}

glm::vec3 unitOr(const glm::vec3& v) {
  const float largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? glm::normalize(v / largest) : glm::vec3(0);
}

}  // namespace

scene::Primitive placedShape(const DrawList& list, const Draw& draw, const layout::Instance& instance) {
  scene::Primitive out = *draw.primitive;
  // The bases that textures lie in, with what targets change of them.
  struct Basis {
    std::vector<glm::vec4>& tangents;
    std::vector<glm::vec3> scene::MorphTarget::*differences;
    std::vector<glm::vec3> sums = {};
  };
  std::array<Basis, 3> bases{{{out.tangents, &scene::MorphTarget::tangents},
                              {out.coatTangents, &scene::MorphTarget::coatTangents},
                              {out.grainTangents, &scene::MorphTarget::grainTangents}}};
  for (Basis& basis : bases)
    for (const glm::vec4& t : basis.tangents) basis.sums.emplace_back(t);
  for (uint32_t i = 0; i < instance.deformation.z; ++i) {
    const layout::MorphWeight& weight = list.morphWeights[instance.deformation.y + i];
    if (weight.target >= out.targets.size()) continue;
    const scene::MorphTarget& target = out.targets[weight.target];
    addOffsets(out.positions, target.positions, weight.weight);
    addOffsets(out.normals, target.normals, weight.weight);
    for (Basis& basis : bases) addOffsets(basis.sums, target.*basis.differences, weight.weight);
    for (size_t set = 0; set < out.texCoords.size(); ++set)
      addOffsets(out.texCoords[set], target.texCoords[set], weight.weight);
    addOffsets(out.colors, target.colors, weight.weight);
  }
  for (glm::vec4& color : out.colors) color = glm::clamp(color, 0.0f, 1.0f);
  const bool skinned = shading::usesFeature(draw.key, Feature::skin);
  glm::mat4 world = instance.worldFromLocal;
  glm::mat3 normals(glm::vec3(instance.normalFromLocal[0]), glm::vec3(instance.normalFromLocal[1]),
                    glm::vec3(instance.normalFromLocal[2]));
  for (size_t v = 0; v < out.positions.size(); ++v) {
    if (skinned) {
      world = skinMatrix(list, instance, out, v);
      normals = glm::mat3(scene::normalTransform(glm::dmat4(world)));
    }
    out.positions[v] = glm::vec3(world * glm::vec4(out.positions[v], 1));
    if (!out.normals.empty()) out.normals[v] = unitOr(normals * out.normals[v]);
    for (const Basis& basis : bases)
      if (!basis.tangents.empty())
        basis.tangents[v] = glm::vec4(unitOr(glm::mat3(world) * basis.sums[v]), basis.tangents[v].w);
  }
  out.targets.clear(), out.influences.clear();
  return out;
}

namespace {

void appendTriangles(std::vector<rays::Triangle>& triangles, const scene::Primitive& p, uint32_t primitive,
                     uint32_t instance, const glm::dmat4* world) {
  const auto corner = [&](uint32_t v) {
    const glm::vec3& position = p.positions[v];
    return world ? glm::vec3(*world * glm::dvec4(position, 1)) : position;
  };
  const size_t count = scene::triangleCount(p);
  for (size_t i = 0; i < count; ++i) {
    const std::array<uint32_t, 3> v = scene::triangleVertices(p, i);
    const glm::vec3 a = corner(v[0]);
    triangles.push_back({a, primitive, corner(v[1]) - a, static_cast<uint32_t>(i), corner(v[2]) - a, instance});
  }
}

// What drawing reads and shading does not.
shading::VariantKey pathKey(shading::VariantKey key) {
  for (const Feature feature : {Feature::skin, Feature::morphTargets, Feature::morphedNormals, Feature::morphedTangents,
                                Feature::morphedTexCoords, Feature::morphedColors, Feature::alphaMask,
                                Feature::alphaBlend, Feature::doubleSided})
    key.features &= ~shading::bitOf(feature);
  return key;
}

bool readsTextures(const Draw& draw, const DrawList& list) {
  const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
  return std::ranges::any_of(scene::textureSlots, [&](scene::TextureSlot slot) {
    return shading::samplesSlot({material, *draw.primitive, list.features}, slot);
  });
}

class Lister {
 public:
  explicit Lister(const DrawList& list) : list_(list) {
    out_.instances = list.instances;
    out_.lights = static_cast<int>(
        std::ranges::count_if(list.lights, [](const layout::LightUniforms& l) { return l.position.w < 2.5f; }));
    for (const float handedness : {1.0f, -1.0f}) {
      layout::Instance world{};
      world.worldFromLocal = glm::mat4(1);
      for (int column = 0; column < 3; ++column) world.normalFromLocal[column][column] = 1;
      world.normalFromLocal[0].w = handedness;
      out_.instances.push_back(world);
    }
    for (const std::vector<Draw>* draws : list.classes())
      for (const Draw& draw : *draws)
        if (!deforms(draw)) uses_[draw.primitive] += draw.instanceCount;
  }

  TracedList run() {
    for (const std::vector<Draw>* draws : list_.classes())
      for (const Draw& draw : *draws) add(draw);
    std::vector<rays::TracedMesh> meshes = {std::move(single_)};
    for (auto& [primitive, mesh] : shared_) meshes.push_back(std::move(mesh));
    shareGlow();
    out_.scene = rays::tracedScene(std::move(meshes));
    return std::move(out_);
  }

 private:
  void add(const Draw& draw) {
    const size_t triangles = scene::triangleCount(*draw.primitive);
    if (triangles == 0) {
      ++out_.thin;
      return;
    }
    out_.media |= shading::usesFeature(draw.key, Feature::volume);
    for (uint32_t i = draw.firstInstance; i < draw.firstInstance + draw.instanceCount; ++i) {
      const layout::Instance& instance = list_.instances[i];
      const size_t first = single_.triangles.size();
      if (deforms(draw)) {
        const auto world = static_cast<uint32_t>(list_.instances.size() + (draw.mirrored ? 1 : 0));
        const scene::Primitive& moved = out_.deformed.emplace_back(placedShape(list_, draw, instance));
        appendTriangles(single_.triangles, moved, partOf(draw, &moved) | flags(draw, true), world, nullptr);
        addGlow(draw, first);
        continue;
      }
      const uint32_t part = known(draw);
      const glm::dmat4 world(instance.worldFromLocal);
      if (uses_[draw.primitive] == 1 || uses_[draw.primitive] * triangles <= mostCopied ||
          glm::determinant(glm::dmat3(world)) == 0) {
        appendTriangles(single_.triangles, *draw.primitive, part | flags(draw, true), i, &world);
        addGlow(draw, first);
        continue;
      }
      rays::TracedMesh& mesh = shared_[draw.primitive];
      if (mesh.triangles.empty())
        appendTriangles(mesh.triangles, *draw.primitive, part | flags(draw, false), layout::rayOfPlacement, nullptr);
      mesh.places.push_back({world, i});
    }
  }

  // Triangles of the world as lights, from the one with that index on.
  void addGlow(const Draw& draw, size_t first) {
    const scene::Material& material = list_.materials[static_cast<size_t>(draw.material)];
    const glm::vec3 radiance = material.emissiveFactor * material.emissiveStrength;
    const double luminance = glm::dot(glm::dvec3(radiance), glm::dvec3(0.2126, 0.7152, 0.0722));
    if (!(luminance > 0) || material.emissive || material.clearcoatFactor > 0 ||
        material.alphaMode != scene::AlphaMode::opaque || !shading::usesFeature(draw.key, Feature::paths))
      return;
    for (size_t i = first; i < single_.triangles.size(); ++i) {
      rays::Triangle& t = single_.triangles[i];
      const double glow = luminance * glm::length(glm::cross(glm::dvec3(t.edge1), glm::dvec3(t.edge2))) / 2;
      if (!(glow > 0) || !std::isfinite(glow)) continue;
      t.primitive |= layout::rayGlowing;
      out_.glow += glow;
      out_.glowing.push_back({t.corner, 0, glm::vec4(t.edge1, 0), glm::vec4(t.edge2, 0), radiance, 0});
      glows_.push_back(glow);
    }
  }
  void shareGlow() {
    double sum = 0;
    for (size_t i = 0; i < glows_.size(); ++i) {
      sum += glows_[i];
      out_.glowing[i].share = static_cast<float>(glows_[i] / out_.glow);
      out_.glowing[i].shareUpTo = static_cast<float>(sum / out_.glow);
    }
  }

  // inWorld: its corners.
  uint32_t flags(const Draw& draw, bool inWorld) const {
    const bool opaque = list_.materials[static_cast<size_t>(draw.material)].alphaMode == scene::AlphaMode::opaque;
    return (opaque ? 0 : layout::rayHoled) | (draw.doubleSided ? 0 : layout::rayOneSided) |
           (draw.mirrored && inWorld ? layout::rayMirrored : 0);
  }

  // Of a rigid primitive, which stands once however often it is drawn.
  uint32_t known(const Draw& draw) {
    const auto found = parts_.find(draw.primitive);
    if (found != parts_.end()) return found->second;
    return parts_[draw.primitive] = partOf(draw, draw.primitive);
  }
  uint32_t partOf(const Draw& draw, const scene::Primitive* data) {
    out_.parts.push_back({data, draw.material, shadingOf(draw)});
    return static_cast<uint32_t>(out_.parts.size() - 1);
  }
  uint32_t shadingOf(const Draw& draw) {
    shading::VariantKey key = pathKey(draw.key);
    if (out_.lights == 0) key.features &= ~shading::bitOf(Feature::punctualLights);
    const int material = readsTextures(draw, list_) ? draw.material : -1;
    const auto [entry, fresh] = classes_.emplace(std::pair(key, material), out_.classes.size() + 1);
    if (fresh) out_.classes.push_back({key, material, draw.primitive});
    return static_cast<uint32_t>(entry->second);
  }

  const DrawList& list_;
  TracedList out_;
  rays::TracedMesh single_;
  std::vector<double> glows_;  // of out_.glowing
  std::map<const scene::Primitive*, rays::TracedMesh> shared_;
  std::map<const scene::Primitive*, size_t> uses_;
  std::map<const scene::Primitive*, uint32_t> parts_;
  std::map<std::pair<shading::VariantKey, int>, size_t> classes_;
};

}  // namespace

TracedList tracedList(const DrawList& list) { return Lister(list).run(); }

}  // namespace facet::frame
