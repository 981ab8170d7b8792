#pragma once

// A resting picture converges: what settings.quality.samples asks for beyond a few samples is gathered in small steps,
// while the window goes on answering. Any change starts with the cheap picture anew.

#include <chrono>
#include <optional>
#include <string>

#include "frame/gather.hpp"
#include "frame/picture.hpp"
#include "gl/timer.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct Viewport;

struct Refinement {
  std::chrono::milliseconds restDelay{150};  // so long nothing has changed before it begins
  int samples = 0;                           // of the gathered picture
  frame::PictureSettings settings;           // the state's, with that many
  frame::Targets targets;
  std::optional<frame::Gathering> gathering;  // nothing: not begun
  // The list's own features, while it has those of the converged picture.
  std::optional<shading::FrameFeatures> movingFeatures;
  bool ended = false;  // complete, or given up
  bool shown = false;  // in place of the cheap picture
  gl::Timer timer;
  bool pending = false;                         // a step is on its way through the GPU
  int64_t rows = 0, issuedRows = 0;             // of the next step, of the last one
  double issueMs = 0;                           // CPU time of the last step
  int estimateAt = 1;                           // draws at which the error is estimated next
  std::optional<frame::ErrorSums> errors;       // on their way
  std::vector<frame::PartDifference> parts;     // of what has been gathered
  frame::ErrorEstimate estimate;                // of what had been when it was made
  std::vector<frame::Attempt> attempts;         // of an error to keep to, that are complete
  std::chrono::steady_clock::time_point since;  // when the picture changed last
};

// Back to the cheap picture, which the caller draws.
void stopRefinement(Viewport& viewport, ViewerState& state);

// The next step, where there is one and the last one is through. True where the display picture is new.
bool refine(Viewport& viewport, ViewerState& state, const scene::View& view);

// "12 of 256 samples": what is on the screen of what is asked for; empty: all of it.
std::string samplesShown(const Viewport& viewport, const ViewerState& state);

// What the cheap picture is off by, which differs from the gathered one by `shown`, root mean square: below 0, not
// known, where what the gathered one is off by itself makes up the greater part of that.
double cheapError(double shown, const frame::ErrorEstimate& gathered);

// There is more to come: refine() is to be called again soon.
bool refining(const Viewport& viewport, const ViewerState& state);

}  // namespace facet::view
