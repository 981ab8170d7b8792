#pragma once

#include "frame/gpu_scene.hpp"

namespace facet::frame {

// Stores only the channels that the use reads, in the narrowest format that holds them: an occlusion map takes one byte
// a texel. 16-bit images keep their depth unless they go through the sRGB curve, which OpenGL offers for 8 bits only.
gl::Texture uploadTexture(const io::Pixels& pixels, const TextureUse& use, bool mips);

// The same in pieces: rows of about uploadPiece bytes of each level that the image has, others level by level.
// continueTexture makes one of them; true where it was the last one.
TextureUpload beginTexture(const io::Pixels& pixels, const TextureUse& use, bool mips);
bool continueTexture(TextureUpload& upload, const io::Pixels& pixels);

}  // namespace facet::frame
