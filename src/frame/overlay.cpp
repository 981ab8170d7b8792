#include "frame/overlay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "frame/depth_pass.hpp"
#include "frame/scene_pass.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

// A line on a surface is not behind it: it may be so much farther, of its distance and of the scene's radius.
constexpr float behindShare = 1e-3f;

// Rays meet triangles of their own: what they draw has no vertices on the GPU.
DrawList rasterized(const DrawList& list) {
  DrawList drawn = list;
  shading::FrameFeatures features = list.features;
  features.paths = false;
  setFeatures(drawn, features);
  return drawn;
}

bool allThere(const DrawList& list, const GpuScene& gpu) {
  return std::ranges::all_of(list.opaque, [&](const Draw& draw) { return gpu.primitives.contains(draw.primitive); });
}

void setState(const OverlayTargets& targets, const FrameInput& in) {
  glBindFramebuffer(GL_FRAMEBUFFER, targets.lines.id());
  glBindVertexArray(targets.noAttributes.id());
  glViewport(0, -in.firstRow, in.settings.frame.width, in.settings.frame.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

OverlayTargets createOverlayTargets(int width, int height) {
  OverlayTargets targets;
  targets.width = width, targets.height = height;
  targets.color = gl::Texture({.format = GL_RGBA8, .width = width, .height = height}, "overlay");
  targets.depth = gl::Texture({.format = GL_DEPTH_COMPONENT32F, .width = width, .height = height}, "overlay's depth");
  targets.depth.parameter(GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  targets.depth.parameter(GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  targets.lines = gl::Framebuffer("overlay");
  targets.lines.attach(GL_COLOR_ATTACHMENT0, targets.color);
  targets.depths = gl::Framebuffer("overlay's depth");
  targets.depths.attach(GL_DEPTH_ATTACHMENT, targets.depth);
  return targets;
}

Result<OverlayLines> overlayLines(const Drawable& drawable, const PictureSettings& settings, int joint) {
  return overlayLines({drawable.scene->model(), drawable.list, drawable.inputs.list.scene, drawable.environment->sun,
                       settings.frame.environmentRotationDeg, aspectOf(settings.frame), joint},
                      settings.placement, settings.overlays);
}

Result<void> drawOverlay(FrameInput in, const Drawable& drawable, const OverlayLines& lines,
                         const OverlayTargets& targets, shading::ProgramStore& programs) {
  std::optional<DrawList> traced;
  if (drawable.list.features.paths) traced = rasterized(drawable.list);
  const DrawList& drawn = traced ? *traced : drawable.list;
  if (!allThere(drawn, drawable.scene->gpu)) uploadScene(drawable.scene->gpu, in.model, drawn);
  FrameInput seen{in.model, drawn, in.gpu, in.tables, in.view, in.settings};
  seen.firstRow = in.firstRow;
  FrameStatistics ignored;
  if (Result<void> r = drawDepth(seen, in.view, targets.depths, {in.settings.frame.width, in.settings.frame.height},
                                 DepthOf::frontSides, programs, ignored);
      !r)
    return r;
  const auto program = programs.render("passes/overlay.vert.glsl", "passes/overlay.frag.glsl");
  if (!program) return tl::unexpected(program.error());
  const glm::vec4 clear(0);
  glClearNamedFramebufferfv(targets.lines.id(), GL_COLOR, 0, &clear.x);
  if (lines.lines.empty()) return {};
  const gl::Buffer buffer = gl::Buffer::of(lines.lines, "overlay's lines");
  const gl::Buffer frame =
      gl::Buffer::of(std::vector<layout::FrameUniforms>{frameUniforms(seen, 0, 1, glm::dvec2(0))}, "frame of overlay");
  setState(targets, in);
  glBindBufferBase(GL_UNIFORM_BUFFER, layout::frameBinding, frame.id());
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, layout::computeInputBinding, buffer.id());
  targets.depth.bind(layout::sourceUnit);
  const float beyond = in.view.orthographic ? behindShare * static_cast<float>(in.list.bounds.radius()) : 0;
  (*program)->set(layout::overlayDepthLocation, glm::vec4(1 + behindShare, beyond, 0, 0));
  glUseProgram((*program)->id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(lines.lines.size()));
  glDisable(GL_BLEND);
  return {};
}

namespace {

// Of a picture of such samples, straight alpha, by lines of 8 bits times alpha.
template <class Sample>
void layOver(const uint8_t* over, Sample* pixel, size_t channels) {
  constexpr float full = std::numeric_limits<Sample>::max();
  const float a = static_cast<float>(over[3]) / 255, below = channels == 4 ? static_cast<float>(pixel[3]) / full : 1;
  const float covered = a + below * (1 - a);
  for (size_t c = 0; c < 3; ++c)
    pixel[c] = static_cast<Sample>(std::lround(std::min(
        full,
        (static_cast<float>(over[c]) * (full / 255) + static_cast<float>(pixel[c]) * below * (1 - a)) / covered)));
  if (channels == 4) pixel[3] = static_cast<Sample>(std::lround(full * covered));
}

}  // namespace

void layOver(const OverlayTargets& targets, int firstRow, io::Pixels& picture) {
  const auto width = static_cast<size_t>(targets.width), channels = static_cast<size_t>(picture.channels);
  std::vector<uint8_t> lines(width * static_cast<size_t>(targets.height) * 4);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(targets.color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(lines.size()), lines.data());
  const int rows = std::min(targets.height, picture.height - firstRow);
  for (int row = 0; row < rows; ++row)
    for (size_t x = 0; x < width; ++x) {
      const uint8_t* const over = &lines[(static_cast<size_t>(row) * width + x) * 4];
      if (over[3] == 0) continue;
      const size_t first = (static_cast<size_t>(picture.height - 1 - firstRow - row) * width + x) * channels;
      if (picture.bytesPerSample == 2)
        layOver(over, reinterpret_cast<uint16_t*>(picture.data.data()) + first, channels);
      else
        layOver(over, &picture.data[first], channels);
    }
}

}  // namespace facet::frame
