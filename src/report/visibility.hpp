#pragma once

// What it costs not to look who is in the light's way: pictures by each way of letting geometry block and return light,
// against the converged path-traced one. The topic "visibility" of `facet report`.

#include "frame/picture.hpp"
#include "frame/settings.hpp"
#include "report/topics.hpp"

namespace facet::report {

Result<Report> visibilityReport(const ReportInput& input);

// ---- Its measurement ------------------------------------------------------------------------------------------------

struct VisibilityError {
  double rms = 0;   // of the sRGB pictures over what the reference covers, 1/255 (compare::Comparison::displayRmse)
  double flip = 0;  // mean of FLIP
  double bias = 0;  // of mean radiance, relative; of the channel where it is largest
};

struct VisibilityRow {
  std::string name = {};
  int samples = 0;  // a pixel
  VisibilityError error = {};
  double raysPerPixel = 0;            // of all samples, the camera's among them
  double milliseconds = 0;            // of a frame: the median where it was repeated
  std::optional<double> spread = {};  // largest less least time over the median, where it was repeated
};

struct VisibilityMeasure {
  // The last one is the reference itself, with its own noise for an error.
  std::vector<VisibilityRow> rows;
  // How far two references of different samples would be apart, from the halves of one: of an error that is not above
  // it, no more is known than that. FLIP grows more slowly than noise; its floor is the halves' own, which is too much.
  VisibilityError floor;
  frame::TracedStatistics traced;
  bool withinFloor(const VisibilityRow& row) const { return row.error.rms <= floor.rms; }
};

struct VisibilityOptions {
  int samples = 256;  // a pixel of the reference and of what is converged, > 1
  std::vector<int> bounces = {1, 2, 3, 4, 8};
  std::vector<int> raySamples = {4, 16};      // of drawn pictures that rays correct; none: nor one of screen space
  std::vector<int> fewSamples = {4, 16, 64};  // of paths with all bounces; each at most half of `samples`
  int repeat = 3;                             // further frames of the quick ones, for timing
  bool occlusionTextures = false;             // the model has some
};

// Draws the picture, then `repeat` further frames.
using DrawPicture = std::function<Result<frame::Picture>(const frame::PictureSettings& settings, int repeat)>;

// settings: sources, viewpoint and size; what lies behind the model is made transparent.
// Pictures of few samples are compared with the samples of the reference that they have not, pictures of fewer bounces
// with those that are the same: their noise is not counted as an error.
Result<VisibilityMeasure> measureVisibility(const frame::PictureSettings& settings, const VisibilityOptions& options,
                                            const DrawPicture& draw);

}  // namespace facet::report
