#include "view/pair_picture.hpp"

namespace facet::view {

Result<void> drawPair(PairPicture& picture, const frame::ShownPair& pair, const gl::VertexArray& noAttributes,
                      shading::ProgramStore& programs) {
  const gl::TextureDescription& size = pair.first.description();
  if (!picture.picture || picture.picture.description().width != size.width ||
      picture.picture.description().height != size.height) {
    picture.picture = gl::Texture({.format = GL_RGBA8, .width = size.width, .height = size.height}, "two pictures");
    picture.target = gl::Framebuffer("two pictures");
    picture.target.attach(GL_COLOR_ATTACHMENT0, picture.picture);
  }
  picture.shown = true;
  return frame::showPair(pair, {picture.wish.how == Beside::difference, picture.wish.split, picture.wish.scale},
                         {picture.target, noAttributes, size.width, size.height}, programs);
}

}  // namespace facet::view
