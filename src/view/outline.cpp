#include "view/outline.hpp"

#include <algorithm>
#include <cmath>

#include "frame/gather.hpp"
#include "view/inspector.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

// Pixels of the picture that the box can touch, widened by the line.
struct Rectangle {
  int x, y, width, height;
};
Rectangle rectangleOf(const scene::Bounds& box, const scene::View& view, int width, int height, int margin) {
  glm::dvec2 low(1), high(-1);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 p(corner & 1 ? box.max.x : box.min.x, corner & 2 ? box.max.y : box.min.y,
                       corner & 4 ? box.max.z : box.min.z);
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(p, 1);
    if (!(clip.w > view.zNear * 0.5)) return {0, 0, width, height};  // reaches behind the eye
    low = glm::min(low, glm::dvec2(clip) / clip.w), high = glm::max(high, glm::dvec2(clip) / clip.w);
  }
  const auto pixel = [](double clip, int size) {
    return static_cast<int>(std::clamp((clip * 0.5 + 0.5) * size, -1.0, size + 1.0));
  };
  const int x = std::max(0, pixel(low.x, width) - margin), y = std::max(0, pixel(low.y, height) - margin);
  return {x, y, std::clamp(pixel(high.x, width) + margin - x, 0, width),
          std::clamp(pixel(high.y, height) + margin - y, 0, height)};
}

void createLine(Outline& outline, int width, int height) {
  outline.mask = frame::createValueTargets(width, height, GL_RGBA8);
  outline.line = gl::Texture({.format = GL_RGBA8, .width = width, .height = height}, "outline");
  outline.lineTarget = gl::Framebuffer("outline");
  outline.lineTarget.attach(GL_COLOR_ATTACHMENT0, outline.line);
}

Result<void> drawMask(Viewport& viewport, const ViewerState& state, const scene::View& view,
                      const frame::DrawList& part) {
  frame::PictureSettings settings = state.settings;
  settings.quality.samples = 1;
  settings.frame.background = frame::Background::transparent;
  const frame::FrameInput in = frame::frameInput(viewport.shown, part, view, settings);
  if (Result<void> r = frame::preparePrograms(in, viewport.programs); !r) return r;
  frame::Gathering gathering = frame::beginGathering(in, viewport.outline.mask);
  return frame::gatherRows(in, viewport.outline.mask, gathering, settings.frame.height, viewport.programs);
}

Result<void> drawLine(Viewport& viewport, const Rectangle& where, float scale) {
  const Outline& outline = viewport.outline;
  const auto program = viewport.programs.render("passes/fullscreen.vert.glsl", "passes/outline.frag.glsl");
  if (!program) return tl::unexpected(program.error());
  const glm::vec4 clear(0);
  glClearNamedFramebufferfv(outline.lineTarget.id(), GL_COLOR, 0, &clear.x);
  glBindFramebuffer(GL_FRAMEBUFFER, outline.lineTarget.id());
  glBindVertexArray(outline.mask.noAttributes.id());
  glViewport(0, 0, outline.width, outline.height);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_CULL_FACE);
  glDisable(GL_BLEND);
  glEnable(GL_SCISSOR_TEST);
  glScissor(where.x, where.y, where.width, where.height);
  outline.mask.color.bind(layout::sourceUnit);
  (*program)->set(layout::outlineLineLocation, glm::vec4(1.0f, 0.66f, 0.20f, 2 * scale));
  glUseProgram((*program)->id());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_SCISSOR_TEST);
  return {};
}

}  // namespace

bool updateOutline(Viewport& viewport, ViewerState& state, float scale) {
  Outline& outline = viewport.outline;
  const bool wasShown = outline.shown;
  const int selected = state.selection.node;
  if (selected < 0 || !viewport.scene || viewport.shadersBroken) {
    outline = {};
    return wasShown;
  }
  const std::optional<scene::View> view = currentView(viewport, state);
  const int width = viewport.targets.width, height = viewport.targets.height;
  if (!view || width < 1 || width != state.settings.frame.width || height != state.settings.frame.height) return false;
  const bool same = outline.node == selected && outline.listNumber == viewport.listNumber && outline.width == width &&
                    outline.height == height && outline.clipFromWorld == view->clipFromWorld;
  if (same) return false;
  if (outline.width != width || outline.height != height) createLine(outline, width, height);
  outline.node = selected, outline.listNumber = viewport.listNumber;
  outline.width = width, outline.height = height, outline.clipFromWorld = view->clipFromWorld;
  outline.shown = false;
  const scene::Model& model = viewport.scene->loaded->model;
  const frame::DrawList part = frame::partOf(
      viewport.shown.list, [&](int node, const scene::Primitive&) { return isWithin(model, node, selected); },
      static_cast<int>(shading::Channel::alpha));
  if (part.opaque.empty() || !frame::isOnGpu(model, part, viewport.scene->gpu)) return wasShown;
  Result<void> drawn = drawMask(viewport, state, *view, part);
  const int margin = static_cast<int>(std::ceil(3 * scale));
  if (drawn) drawn = drawLine(viewport, rectangleOf(part.bounds, *view, width, height, margin), scale);
  if (!drawn) state.status = {describe(drawn.error()), true};
  outline.shown = static_cast<bool>(drawn);
  return true;
}

}  // namespace facet::view
