#pragma once

// What a drawn picture is wrong by, because nothing in it stands in the light's way: found by a few paths a pixel,
// which bring only what differs from light that nothing blocks, and smoothed over what is alike. Where nothing is in
// the way there is no noise, since nothing is added (a control variate).

#include "frame/paths.hpp"

namespace facet::frame {

// Paths of a pixel: one for each sample, in pictures of more pixels one for each of the first draws only (a helmet of 4
// samples at 1024 x 1024: dRMSE 12.0 with two paths for 10.7 with four, 17.1 without any; 3.7 for 4.8 times the time
// that it takes without. Drawing it at once instead of sample by sample would save a tenth of that, and be off
// by 14.1).
int pathsOfPixel(int samples, int64_t pixels);

struct Difference {
  gl::Texture radiance;  // RGBA16F, RGBA32F where precise; of the whole picture
  uint64_t rays = 0;
};
// Samples as the settings say.
Result<Difference> traceDifference(const FrameInput& in, shading::ProgramStore& programs);

// Onto the targets' sum.
Result<void> addDifference(const FrameInput& in, const Targets& targets, const Difference& difference,
                           shading::ProgramStore& programs);

// All that both use.
std::vector<ProgramGetter> neededDifferencePrograms(const FrameInput& in, shading::ProgramStore& programs);

}  // namespace facet::frame
