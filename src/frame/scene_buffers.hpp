#pragma once

// Vertex data and materials of all of a draw list's primitives in four buffers, which shaders/scene_by_index.glsl
// reads: for shaders that find a surface by themselves. Nothing makes them but who asks for them.

#include <map>

#include "frame/draw_list.hpp"
#include "gl/buffer.hpp"

namespace facet::frame {

struct SceneBuffers {
  gl::Buffer primitives;                                // layout::ScenePrimitive
  gl::Buffer triangles;                                 // three vertices each, counted from the primitive's first
  gl::Buffer attributes;                                // floats, primitive by primitive, only those that it has
  gl::Buffer materials;                                 // layout::MaterialUniforms, by Draw::material
  std::map<const scene::Primitive*, uint32_t> indices;  // in `primitives`

  size_t bytes() const;
};

// Primitives with triangles; each once, however often it is drawn. Its material is that of its first draw.
SceneBuffers sceneBuffers(const DrawList& list);

// At the bindings of shaders/scene_by_index.h.
void bindSceneBuffers(const SceneBuffers& buffers);

}  // namespace facet::frame
