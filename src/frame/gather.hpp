#pragma once

// A picture of many draws, gathered a few at a time: what comes out does not depend on how the work was cut.

#include <vector>

#include "frame/frame.hpp"
#include "frame/paths.hpp"
#include "frame/visibility.hpp"
#include "gl/buffer.hpp"

namespace facet::frame {

// How far a picture has come. The camera, the list and the targets must stay while it lasts.
struct Gathering {
  VisibleDraws visible;
  gl::Buffer visibleBuffer;
  std::vector<glm::dvec2> offsets;  // of each draw within its pixel
  int done = 0;                     // draws that are in the targets completely
  int rows = 0;                     // of the next draw, from the bottom
  int before = 0;                   // draws that were done at the mark
  FrameStatistics statistics;       // of the first draw
  PathWork paths;                   // where the draws are samples of paths

  int draws() const { return static_cast<int>(offsets.size()); }
  bool complete() const { return done == draws(); }
};

// Where in its pixel each draw of so many is, from the middle [pixels].
std::vector<glm::dvec2> jitter(int count, int seed);

Gathering beginGathering(const FrameInput& in, const Targets& targets);

// Draws so many rows (a draw has targets.height) as there are left, at most. A scene with transmitting surfaces is only
// drawn whole, because what shines through may come from any row.
Result<void> gatherRows(const FrameInput& in, const Targets& targets, Gathering& gathering, int64_t rows,
                        shading::ProgramStore& programs);

// What is gathered so far times this is the mean of the draws that are done; exactly 1 at the end.
float meanScale(const Gathering& gathering);

// What has been gathered by now into the display picture of `shown`, which may be that of the same targets. At least
// one draw is done, none is under way.
Result<void> drawDisplay(const FrameInput& in, const Targets& targets, const Gathering& gathering, const Targets& shown,
                         shading::ProgramStore& programs);

struct PictureErrors {
  PartDifference parts;  // of the draws before the mark and those after it
  // Root mean square over all pixels and colour channels of what has been gathered less the display picture of `shown`,
  // in 1/255.
  double shown = 0;
};

// The errors, to be read when the GPU has come so far.
struct ErrorSums {
  gl::Buffer sums;
  size_t tiles = 0, values = 0;
  int before = 0, after = 0;  // draws
};

// After how many draws the error is estimated next: each time twice as many are done, the last time with all. A last
// part of few draws would say little: the last two estimates are put together then.
int nextEstimate(int done, int draws);

// Whether the parts of so many draws tell of the error of all: draws get evener the more there are, and what few of
// them differ by is too much.
bool isContrast(int done, int draws);

// Remembers the draws that are done as the first part.
void markBefore(const Targets& targets, Gathering& gathering);

// More draws are done than at the mark, and none is under way.
Result<ErrorSums> sumErrors(const FrameInput& in, const Targets& targets, const Gathering& gathering,
                            const Targets& shown, shading::ProgramStore& programs);
PictureErrors readErrors(const ErrorSums& sums);  // waits for the GPU

// What the draws before the mark and those after it differ by, onto targets.contrasts.
Result<void> addContrast(const Targets& targets, const Gathering& gathering, shading::ProgramStore& programs);

// Errors: a shader does not compile.
Result<void> prepareGatherPrograms(shading::ProgramStore& programs);

}  // namespace facet::frame
