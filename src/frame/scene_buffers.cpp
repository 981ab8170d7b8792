#include "frame/scene_buffers.hpp"

#include <span>

#include "frame/gpu_scene.hpp"
#include "scene/pick.hpp"
#include "scene_by_index.h"

namespace facet::frame {

namespace {

template <class T>
uint32_t append(std::vector<float>& attributes, const std::vector<T>& values) {
  if (values.empty()) return layout::noAttribute;
  const auto first = static_cast<uint32_t>(attributes.size());
  for (const T& value : values)
    for (int i = 0; i < T::length(); ++i) attributes.push_back(value[i]);
  return first;
}

layout::ScenePrimitive appendPrimitive(const ScenePart& part, bool positions, std::vector<uint32_t>& triangles,
                                       std::vector<float>& attributes) {
  const scene::Primitive& p = *part.primitive;
  layout::ScenePrimitive out{};
  out.firstTriangle = static_cast<uint32_t>(triangles.size() / 3);
  out.triangles = static_cast<uint32_t>(scene::triangleCount(p));
  out.vertices = static_cast<uint32_t>(p.positions.size());
  for (size_t i = 0; i < out.triangles; ++i)
    for (const uint32_t vertex : scene::triangleVertices(p, i)) triangles.push_back(vertex);
  out.position = positions ? append(attributes, p.positions) : layout::noAttribute;
  out.normal = append(attributes, p.normals);
  out.tangent = append(attributes, p.tangents);
  out.coatTangent = append(attributes, p.coatTangents);
  out.grainTangent = append(attributes, p.grainTangents);
  out.color = append(attributes, p.colors);
  for (size_t set = 0; set < p.texCoords.size(); ++set) out.texCoord[set] = append(attributes, p.texCoords[set]);
  out.material = static_cast<uint32_t>(part.material);
  out.shading = part.shading;
  return out;
}

}  // namespace

size_t SceneBuffers::bytes() const {
  return primitives.bytes() + triangles.bytes() + attributes.bytes() + materials.bytes();
}

SceneBuffers sceneBuffers(std::span<const ScenePart> parts, const std::vector<scene::Material>& materials,
                          bool positions) {
  SceneBuffers buffers;
  std::vector<layout::ScenePrimitive> primitives;
  std::vector<uint32_t> triangles;
  std::vector<float> attributes;
  for (const ScenePart& part : parts) primitives.push_back(appendPrimitive(part, positions, triangles, attributes));
  std::vector<layout::MaterialUniforms> uniforms;
  for (const scene::Material& material : materials) uniforms.push_back(materialUniforms(material));
  buffers.primitives = gl::Buffer::of(primitives, "scene primitives");
  buffers.triangles = gl::Buffer::of(triangles, "scene triangles");
  buffers.attributes = gl::Buffer::of(attributes, "scene attributes");
  buffers.materials = gl::Buffer::of(uniforms, "scene materials");
  return buffers;
}

void bindSceneBuffers(const SceneBuffers& buffers) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::scenePrimitivesBinding, buffers.primitives.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::sceneTrianglesBinding, buffers.triangles.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::sceneAttributesBinding, buffers.attributes.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::sceneMaterialsBinding, buffers.materials.id());
}

}  // namespace facet::frame
