#pragma once

// Whether --max-error keeps what it says: what it states, what pictures are off by in truth, and with how few samples
// they would have done. The topic "estimate" of `facet report`.

#include <functional>
#include <optional>
#include <vector>

#include "frame/picture.hpp"
#include "frame/settings.hpp"
#include "report/topics.hpp"

namespace facet::report {

Result<Report> estimateReport(const ReportInput& input);

// ---- Its measurement ------------------------------------------------------------------------------------------------

// Errors: root mean square of the displayed colours before rounding to 8 bits, over the whole picture, of 1.
struct EstimateRow {
  double wanted = 0;
  int samples = 0;               // a pixel of the picture that --max-error comes to
  int drawn = 0;                 // of all attempts
  double stated = 0, truth = 0;  // ErrorEstimate::most; against the reference, whose own noise is taken out
  bool reached = false;          // it states that the error is kept to: else it has warned
  // The fewest samples whose true error is within, between powers of two as a power of their number; nothing: more than
  // were tried.
  std::optional<double> oracle = {};
};

// A picture of a given number of samples.
struct ConvergencePoint {
  int samples = 0;
  frame::ErrorEstimate stated;  // 1/255
  double truth = 0;
};

struct EstimateMeasure {
  std::vector<EstimateRow> rows;
  std::vector<ConvergencePoint> points;
  double floor = 0;  // noise of the reference
};

struct EstimateOptions {
  std::vector<double> errors = {0.05, 0.02, 0.01, 0.005, 0.002};  // to keep to
  int most = 512;                                                 // samples a pixel at most
  int reference = 512;  // samples a pixel of each of the reference's two halves, which have seeds of their own
};

// Draws the picture, with its radiance and the estimate of its noise.
using DrawEstimated = std::function<Result<frame::Picture>(const frame::PictureSettings& settings)>;

// settings: sources, viewpoint, size, light.
Result<EstimateMeasure> measureEstimate(const frame::PictureSettings& settings, const EstimateOptions& options,
                                        const DrawEstimated& draw);

}  // namespace facet::report
