#pragma once

// Many pictures against references: models x environments x sizes x methods x samples, as `facet sweep` draws them.
// What is measured is kept in a folder, so that a run that was ended goes on where it was, and a later one with more
// samples in the reference adds to it.

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "frame/picture.hpp"
#include "frame/settings.hpp"
#include "report/topics.hpp"

namespace facet::report {

struct SweepMethod {
  std::string name;
  frame::PictureSettings settings;  // whatever is not below
};

struct SweepPlan {
  std::vector<std::string> models, environments;  // files, or "builtin:NAME"
  std::vector<glm::ivec2> sizes;                  // [px]
  std::vector<int> samples;                       // a pixel
  std::vector<SweepMethod> methods;
  frame::PictureSettings reference;
  int referenceSamples = 1024;  // a pixel; whole multiples of referenceBlock, 2 at least
  int seeds = 2;                // pictures of each method, each with other random numbers; 1 at least
  int repeat = 3;               // further frames of the first of them, for timing
};
inline constexpr int referenceBlock = 128;  // samples of one picture of the reference, each of a seed of its own

struct SweepRow {
  std::string model, environment, method;
  int width = 0, height = 0, samples = 0;
  // Means over the seeds, over what the reference covers. error: root mean square of the sRGB pictures in 1/255, the
  // reference's own noise taken out of its square; its deviation is that of the mean (0: one seed says nothing of it).
  double error = 0, deviation = 0, relativeRmse = 0, flip = 0, bias = 0;
  double floor = 0;                     // the reference's own error, estimated from its parts; 1/255
  double milliseconds = 0, spread = 0;  // of a frame: median, largest less least over it
  double raysPerPixel = 0;
};

struct SweepTools {
  std::function<Result<frame::Picture>(const std::string& model, const frame::PictureSettings& settings, int repeat)>
      draw;
  // Tells whatever changes a picture's figures apart, and is the same from run to run.
  std::function<std::string(const std::string& model, const frame::PictureSettings& settings)> key;
  Origin origin = {};            // of references; without a date
  std::filesystem::path folder;  // exists; "references" and "rows" in it are made
  std::function<void(const std::string&)> progress = [](const std::string&) {};
  std::function<void(size_t rows, size_t all)> measured = [](size_t, size_t) {};  // so many of them are kept
};

// In the plan's order. errors: of each place (a model under an environment in a size) that could not be measured whole,
// the first one.
struct SweepMeasure {
  std::vector<SweepRow> rows;
  std::vector<Error> errors;
};
// Errors: the folder cannot be written.
Result<SweepMeasure> measureSweep(const SweepPlan& plan, const SweepTools& tools);

// One tidy table; for each model, environment and size error against samples and against time, with slopes, the Pareto
// front ringed.
Report sweepReport(const SweepPlan& plan, const std::vector<SweepRow>& rows);

}  // namespace facet::report
