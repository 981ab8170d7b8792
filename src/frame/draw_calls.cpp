#include "frame/draw_calls.hpp"

#include <algorithm>

#include "frame/scene_pass.hpp"

namespace facet::frame {

namespace {

using scene::TextureSlot;

uint64_t triangleCount(const GpuPrimitive& primitive) {
  switch (primitive.mode) {
    case GL_TRIANGLES:
      return static_cast<uint64_t>(primitive.count) / 3;
    case GL_TRIANGLE_STRIP:
    case GL_TRIANGLE_FAN:
      return static_cast<uint64_t>(std::max(0, primitive.count - 2));
    default:
      return 0;
  }
}

}  // namespace

void bindMaterial(const FrameInput& in, const Draw& draw) {
  const auto index = static_cast<size_t>(draw.material);
  glBindBufferRange(GL_UNIFORM_BUFFER, layout::materialBinding, in.gpu.materials.id(),
                    static_cast<GLintptr>(index * in.gpu.materialStride), sizeof(layout::MaterialUniforms));
  bindTextures(in, draw.material, *draw.primitive);
}

void bindTextures(const FrameInput& in, int index, const scene::Primitive& primitive) {
  const scene::Material& material = in.list.materials[static_cast<size_t>(index)];
  const float mask = in.list.maskThresholds[static_cast<size_t>(index)];
  for (const TextureSlot slot : scene::textureSlots) {
    if (!shading::samplesSlot({material, primitive, in.list.features}, slot)) continue;
    const BoundTexture bound = boundTexture(in.gpu, in.model, material, slot, mask);
    glBindTextureUnit(static_cast<GLuint>(slot), bound.texture);
    glBindSampler(static_cast<GLuint>(slot), bound.sampler);
  }
}

void issue(const FrameInput& in, const Draw& draw, FrameStatistics& statistics) {
  const GpuPrimitive& primitive = in.gpu.primitives.at(draw.primitive);
  glBindVertexArray(primitive.vertexArray.id());
  glFrontFace(draw.mirrored ? GL_CW : GL_CCW);
  if (primitive.influences)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::influenceBinding, primitive.influences.id());
  if (primitive.morphTargets)
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::morphTargetBinding, primitive.morphTargets.id());
  const auto instances = static_cast<GLsizei>(draw.instanceCount);
  if (primitive.indexType == GL_NONE)
    glDrawArraysInstancedBaseInstance(primitive.mode, 0, primitive.count, instances, draw.firstInstance);
  else
    glDrawElementsInstancedBaseInstance(primitive.mode, primitive.count, primitive.indexType, nullptr, instances,
                                        draw.firstInstance);
  ++statistics.draws;
  statistics.instances += draw.instanceCount;
  statistics.triangles += triangleCount(primitive) * draw.instanceCount;
}

void setCulling(bool doubleSided) {
  if (doubleSided)
    glDisable(GL_CULL_FACE);
  else
    glEnable(GL_CULL_FACE);
}

}  // namespace facet::frame
