#pragma once

// What a frame costs and what it is off by, for each way of reading slanted textures. The topic "frame" of
// `facet report`.

#include "frame/picture.hpp"
#include "frame/settings.hpp"
#include "report/topics.hpp"

namespace facet::report {

Result<Report> frameReport(const ReportInput& input);

// ---- Its measurement ------------------------------------------------------------------------------------------------

struct FilterRow {
  frame::TextureFilter filter;
  // Against the converged picture: RMSE of the sRGB pictures in 1/255 and mean FLIP, of the base colour alone and of
  // the whole.
  double colorRms = 0, colorFlip = 0, rms = 0, flip = 0;
  double milliseconds = 0;  // of a frame: median of the repeated ones of all rounds
  double spread = 0;        // largest less least of them over it
};

// Draws the picture, then `repeat` further frames.
using DrawFrames = std::function<Result<frame::Picture>(const frame::PictureSettings& settings, int repeat)>;

// settings: sources, viewpoint, size. referenceSamples: a pixel of the converged pictures, > 4. The filters take turns
// for `rounds` rounds of `repeat` frames, > 0.
Result<std::vector<FilterRow>> measureFilters(const frame::PictureSettings& settings, int referenceSamples, int rounds,
                                              int repeat, const DrawFrames& draw);

}  // namespace facet::report
