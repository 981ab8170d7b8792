#pragma once

// Lines over a picture: into a texture of their own, which is laid over what is shown. Nothing is compiled, uploaded or
// drawn where there are none.

#include "frame/overlay_lines.hpp"
#include "frame/plan.hpp"

namespace facet::frame {

// As many rows of the picture as it is high.
struct OverlayTargets {
  int width = 0, height = 0;
  gl::Texture color;  // RGBA8, display values times alpha
  gl::Texture depth;  // of what hides lines
  gl::Framebuffer lines, depths;
  gl::VertexArray noAttributes;
};
OverlayTargets createOverlayTargets(int width, int height);

// What the settings want of what is drawn. joint: node, of a skeleton's, whose influence is shown with it; -1: none.
Result<OverlayLines> overlayLines(const Drawable& drawable, const PictureSettings& settings, int joint = -1);

// The rows from in.firstRow on. in: of the drawable. Surfaces that one sees through hide nothing. What hides lines goes
// on the GPU where the picture itself is traced.
Result<void> drawOverlay(FrameInput in, const Drawable& drawable, const OverlayLines& lines,
                         const OverlayTargets& targets, shading::ProgramStore& programs);

// Over the picture's rows from there on, counted from the bottom.
void layOver(const OverlayTargets& targets, int firstRow, io::Pixels& picture);

}  // namespace facet::frame
