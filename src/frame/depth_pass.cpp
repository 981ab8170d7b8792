#include "frame/depth_pass.hpp"

#include <set>

#include "frame/draw_calls.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"
#include "frame/visibility.hpp"

namespace facet::frame {

namespace {

using shading::ProgramStore;

Result<const gl::Program*> depthProgram(const shading::VariantKey& key, ProgramStore& programs) {
  return programs.render("passes/mesh.vert.glsl", "passes/depth.frag.glsl", shading::variantDefines(key));
}

}  // namespace

Result<void> drawDepth(const FrameInput& in, const scene::View& view, const gl::Framebuffer& framebuffer,
                       const glm::ivec2& size, DepthOf sides, ProgramStore& programs, FrameStatistics& statistics) {
  const FrameInput seen{in.model, in.list, in.gpu, in.tables, view, in.settings};
  const VisibleDraws visible = visibleDraws(in.list, view, {}, 4.0 / std::min(size.x, size.y));
  const gl::Buffer instances = gl::Buffer::of(visible.instances, "visible instances");
  const gl::Buffer frame =
      gl::Buffer::of(std::vector<layout::FrameUniforms>{frameUniforms(seen, 0, 1, glm::dvec2(0))}, "frame of depths");
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
  glViewport(0, -in.firstRow, size.x, size.y);
  glDepthMask(GL_TRUE);
  const float far = 0;
  glClearNamedFramebufferfv(framebuffer.id(), GL_DEPTH, 0, &far);
  bindScene(in);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frame.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::visibleBinding, instances.id());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glCullFace(GL_BACK);
  for (const Draw& draw : visible.opaque) {
    const shading::VariantKey key = shading::depthKey(draw.key);
    const auto program = depthProgram(key, programs);
    if (!program) return tl::unexpected(program.error());
    glUseProgram((*program)->id());
    if (shading::usesFeature(key, shading::Feature::alphaMask)) bindMaterial(in, draw);
    setCulling(draw.doubleSided || sides == DepthOf::bothSides);
    issue(in, draw, statistics);
  }
  return {};
}

std::vector<ProgramGetter> neededDepthPrograms(const FrameInput& in, ProgramStore& programs) {
  std::set<shading::VariantKey> keys;
  for (const Draw& draw : in.list.opaque) keys.insert(shading::depthKey(draw.key));
  std::vector<ProgramGetter> needed;
  for (const shading::VariantKey& key : keys)
    needed.emplace_back([&programs, key] { return depthProgram(key, programs); });
  return needed;
}

}  // namespace facet::frame
