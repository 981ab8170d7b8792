#pragma once

// From scene-linear pictures to what is shown, and what can be said of it there.

#include "frame/frame.hpp"
#include "gl/buffer.hpp"

namespace facet::frame {

// Radiance of a stored 1: a power of two, so that halves hold what the exposure shows. 1 for exposures of -4 to 8
// stops, and for channels, which are not exposed.
float radianceUnit(const Display& display, int channel);
// In such units; precise: as createTargets has it.
float largestStored(bool precise);

// What displayed() in shaders/display.glsl takes; scale: on what is read, whose unit is the radianceUnit.
struct DisplayParameters {
  glm::vec4 parameters, backdrop;
};
DisplayParameters displayParameters(const FrameInput& in, float scale);

// The channel is a quantity, which the targets hold times a factor, and transparent where nothing is drawn.
bool showsQuantity(const FrameInput& in);
float quantityFactor(const FrameInput& in);

struct FullscreenTarget {
  const gl::Framebuffer& framebuffer;
  const gl::VertexArray& noAttributes;
  int width, height;
};
// A triangle over the whole target.
void drawFullscreen(const FullscreenTarget& target, const gl::Texture& source, const gl::Program& program);

// The picture is of a measured BRDF and of the model fitted to it.
bool comparing(const FrameInput& in);
// Of that, or the only one.
Result<const gl::Program*> displayProgram(const FrameInput& in, shading::ProgramStore& programs);

// The sum of the targets, or their color, times the scale into the display picture of `shown`.
Result<void> showPicture(const FrameInput& in, const Targets& targets, float scale, const Targets& shown,
                         shading::ProgramStore& programs);

// Two pictures as they are shown (RGBA8, straight alpha, of one size).
struct ShownPair {
  const gl::Texture& first;
  const gl::Texture& second;
};
// The first to the left of split (share of the width), the second to its right; or the absolute difference of their
// values times the scale.
struct PairView {
  bool difference = false;
  float split = 0.5f, scale = 1;
};
Result<void> showPair(const ShownPair& pair, const PairView& how, const FullscreenTarget& target,
                      shading::ProgramStore& programs);

// Of one band, to be read when the GPU has come so far.
struct ComparisonSums {
  gl::Buffer sums;
  size_t tiles = 0;
  size_t pixels = 0;
};
// The targets' rows that belong to the picture; scale as showPicture has it. comparing(in).
Result<ComparisonSums> sumComparison(const FrameInput& in, const Targets& targets, float scale,
                                     shading::ProgramStore& programs);
Result<ComparisonSums> sumPair(const ShownPair& pair, shading::ProgramStore& programs);
// Of all bands; waits for the GPU.
ComparisonFigures readComparison(const std::vector<ComparisonSums>& bands);

}  // namespace facet::frame
