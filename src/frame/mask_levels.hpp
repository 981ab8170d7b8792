#pragma once

// Smaller levels of textures that mask: filtered as alpha, a fence or hair dissolves with distance, or closes. In alpha
// they hold the share of their texels' area that passes the test at the finest level (after Castano 2010, "Computing
// Alpha Mipmaps", which scales alpha for that), which mask_samples.glsl covers as many samples by.

#include <vector>

#include "io/image.hpp"
#include "scene/model.hpp"

namespace facet::frame {

// Least alpha of the base colour's texel that passes, (0, 1]; 0: no level is other than alpha itself, since the
// material does not mask, everything or nothing passes, its sampler reads no levels, or an animation moves the
// threshold. material: index of `m` in the model's materials, or beyond.
float maskThreshold(const scene::Model& model, const scene::Material& m, int material);

// Shares of texels' areas, row by row.
struct MaskLevel {
  int width = 0, height = 0;
  std::vector<float> shares;
};
// Of level 1: where alpha between texels, linearly interpolated on a torus, is at least the threshold. channel: of the
// image.
MaskLevel firstMaskLevel(const io::Pixels& pixels, int channel, float threshold);
// Of the level after that one. Areas are kept: a texel of a level whose finer one has an odd size takes parts of
// texels.
MaskLevel nextMaskLevel(const MaskLevel& level);

}  // namespace facet::frame
