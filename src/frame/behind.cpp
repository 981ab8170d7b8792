#include "frame/behind.hpp"

#include <algorithm>

namespace facet::frame {

namespace {

Result<const gl::Program*> baseProgram(shading::ProgramStore& programs, int samples) {
  std::vector<shading::Define> defines;
  if (samples > 1) defines.push_back({"SAMPLES", std::to_string(samples)});
  return programs.compute("passes/behind.comp.glsl", defines);
}
Result<const gl::Program*> levelProgram(shading::ProgramStore& programs) {
  return programs.compute("passes/behind_level.comp.glsl");
}

void writeLevel(const Behind& behind, int level, const gl::Program& program) {
  glBindImageTexture(0, behind.color.id(), level, GL_FALSE, 0, GL_WRITE_ONLY, behind.color.description().format);
  glBindImageTexture(1, behind.depth.id(), level, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  const auto groups = [&](int size) { return static_cast<GLuint>(layout::groupsFor(std::max(1, size >> level))); };
  glUseProgram(program.id());
  glDispatchCompute(groups(behind.color.description().width), groups(behind.color.description().height), 1);
  glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

}  // namespace

void prepareBehind(Targets& targets, const DrawList& list) {
  if (list.transmitting.empty()) {
    targets.behind = {};
    return;
  }
  if (targets.behind.color) return;
  gl::TextureDescription description{
      .format = targets.color.description().format, .width = targets.width, .height = targets.height};
  description.levels = gl::mipLevels(targets.width, targets.height);
  targets.behind.color = gl::Texture(description, "behind");
  description.format = GL_R32F;
  targets.behind.depth = gl::Texture(description, "depth behind");
  targets.behind.color.filterLinear();
  targets.behind.depth.filterLinear();
}

Result<const gl::Program*> behindProgram(shading::ProgramStore& programs) { return levelProgram(programs); }

Result<void> copyBehind(const Targets& targets, shading::ProgramStore& programs) {
  const auto base = baseProgram(programs, targets.samples);
  if (!base) return tl::unexpected(base.error());
  const auto next = levelProgram(programs);
  if (!next) return tl::unexpected(next.error());
  const Behind& behind = targets.behind;
  (targets.samples > 1 ? targets.multisample : targets.color).bind(layout::sourceUnit);
  targets.depth.bind(layout::opaqueDepthUnit);
  writeLevel(behind, 0, **base);
  behind.color.bind(layout::opaqueFrameUnit);
  behind.depth.bind(layout::opaqueDepthUnit);
  for (int level = 1; level < behind.color.description().levels; ++level) {
    (*next)->set(layout::behindFineLevelLocation, level - 1);
    writeLevel(behind, level, **next);
  }
  return {};
}

}  // namespace facet::frame
