#pragma once

// Two pictures of the window's size as one: beside each other, or their difference. Laid over the picture; screenshots
// and what is rendered never have it.

#include "frame/display_pass.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct PairPicture {
  BesideWish wish;      // that it is drawn with
  gl::Texture picture;  // RGBA8
  gl::Framebuffer target;
  bool shown = false;
};

Result<void> drawPair(PairPicture& picture, const frame::ShownPair& pair, const gl::VertexArray& noAttributes,
                      shading::ProgramStore& programs);

}  // namespace facet::view
