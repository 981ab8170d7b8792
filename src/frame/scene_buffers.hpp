#pragma once

// Vertex data and materials of primitives in four buffers, which shaders/scene_by_index.glsl reads: for shaders that
// find a surface by themselves. Nothing makes them but who asks for them.

#include <span>

#include "frame/scene_part.hpp"
#include "gl/buffer.hpp"

namespace facet::frame {

struct SceneBuffers {
  gl::Buffer primitives;  // layout::ScenePrimitive
  gl::Buffer triangles;   // three vertices each, counted from the primitive's first
  gl::Buffer attributes;  // floats, primitive by primitive, only those that it has
  gl::Buffer materials;   // layout::MaterialUniforms, by ScenePart::material

  size_t bytes() const;
};

// In the order of the parts. positions: false leaves them out, where they are known otherwise.
SceneBuffers sceneBuffers(std::span<const ScenePart> parts, const std::vector<scene::Material>& materials,
                          bool positions = true);

// At the bindings of shaders/scene_by_index.h.
void bindSceneBuffers(const SceneBuffers& buffers);

}  // namespace facet::frame
