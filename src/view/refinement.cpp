#include "view/refinement.hpp"

#include <algorithm>
#include <cmath>

#include "base/log.hpp"
#include "frame/blend_lists.hpp"
#include "view/viewport.hpp"

namespace facet::view {

namespace {

using Clock = std::chrono::steady_clock;

constexpr double stepMs = 25;       // GPU time of a step
constexpr int64_t fewestRows = 32;  // a draw's fixed costs count more in thinner bands

frame::FrameInput frameInput(const Viewport& viewport, const scene::View& view) {
  return frame::frameInput(viewport.shown, view, viewport.refinement.settings);
}

// As many samples as are gathered at first.
int firstAttempt(const frame::PictureSettings& settings) {
  return settings.quality.maxError ? frame::firstSamples(settings) : settings.quality.samples;
}

void giveUp(Refinement& refinement, ViewerState& state, const Error& error) {
  state.status = {describe(error), true};
  log::error(state.status.text);
  state.refinement = {};
  refinement.ended = true;
}

// What the sampled picture needs and the cheap one does not; a little each time. True where all is there.
Result<bool> prepare(Viewport& viewport, const ViewerState& state, const scene::View& view) {
  Refinement& r = viewport.refinement;
  if (!r.movingFeatures) {
    r.movingFeatures = viewport.shown.list.features;
    shading::FrameFeatures resting = viewport.shown.list.features;
    const frame::DrawOptions options =
        frame::drawOptions(frame::restingSettings(gatheredSettings(state)), resting.environment);
    resting.imageLightSamples = options.features.imageLightSamples;
    resting.shadedOnce = options.features.shadedOnce;
    resting.occlusion = options.features.occlusion;
    frame::setFeatures(viewport.shown.list, resting);
    frame::setTracing(viewport.shown.list, options);
  }
  EnvironmentSlot& environment = *viewport.environments.shown;
  const ibl::Needs needs = frame::tableNeeds(viewport.shown);
  if (Result<void> provided = provideTables(environment, needs, viewport.programs, viewport.environments.immediateMs);
      !provided)
    return tl::unexpected(provided.error());
  if (environment.preview) return false;
  // Trees that a floor has had made do, where surfaces are shaded as for them.
  const frame::PathScene* paths = viewport.shown.paths.get();
  const bool otherwise = paths && paths->drawn && paths->drawn->features != viewport.shown.list.features;
  if (viewport.shown.list.features.paths && (!paths || otherwise)) {
    Result<std::optional<frame::PathTrees>> trees =
        findOrMakeTrees(viewport.trees, viewport.shown.inputs.list, viewport.shown.list);
    if (!trees) return tl::unexpected(trees.error());
    if (!*trees) return false;
    Result<frame::PathScene> made = frame::pathScene(std::move(**trees), viewport.shown.list, viewport.scene->model(),
                                                     viewport.scene->gpu, viewport.programs);
    if (!made) return tl::unexpected(made.error());
    viewport.shown.paths = std::make_shared<const frame::PathScene>(std::move(*made));
  }
  const Result<bool> compiled = frame::prepareNextProgram(frameInput(viewport, view), viewport.programs);
  if (!compiled || !*compiled) return compiled;
  if (Result<void> gather = frame::prepareGatherPrograms(viewport.programs); !gather)
    return tl::unexpected(gather.error());
  return true;
}

Result<void> begin(Viewport& viewport, ViewerState& state, const scene::View& view) {
  Refinement& r = viewport.refinement;
  const frame::PictureSettings& s = r.settings;
  if (r.targets.width != s.frame.width || r.targets.height != s.frame.height) {
    r.targets = {};  // the old ones go first
    r.targets = frame::createGatherTargets(s.frame.width, s.frame.height);
  }
  frame::prepareBehind(r.targets, viewport.shown.list);
  frame::prepareComparison(r.targets, viewport.shown.list);
  frame::prepareBlendLists(r.targets, viewport.shown.list, s);
  if (Result<void> looked = lookAround(viewport, frameInput(viewport, view)); !looked) return looked;
  r.gathering = frame::beginGathering(frameInput(viewport, view), r.targets);
  r.estimateAt = 1;
  r.parts.clear();
  beginErrorView(viewport);
  keepFastPicture(viewport, state);
  state.refinement.wanted = s.quality.samples;
  state.refinement.softened = viewport.shown.list.features.paths && s.quality.caustics == frame::Caustics::soft;
  // A guess from the cheap frame: a sampled draw takes about as long per coverage sample. The steps adapt.
  const double guessMs = state.shown.statistics.gpuMs;
  r.rows = guessMs > 0 ? static_cast<int64_t>(s.frame.height * stepMs / (2 * guessMs)) : s.frame.height / 8;
  r.rows = std::max(r.rows, fewestRows);
  return {};
}

int64_t height(const Refinement& r) { return r.targets.height; }

// Rows of the next step: whole draws where one fits, up to the next estimate at most.
int64_t stepRows(const Refinement& r) {
  const frame::Gathering& g = *r.gathering;
  const int until = std::min(std::max(r.estimateAt, g.done + 1), g.draws());
  int64_t end = g.rows + r.rows;
  if (end > height(r)) end -= end % height(r);
  return std::min(end, (until - g.done) * height(r)) - g.rows;
}

// After a step: as many rows as fit into the time, as far as it is known.
void adapt(Refinement& r) {
  const double ms = std::max({r.timer.milliseconds(), r.issueMs, 0.01});
  const auto fitting = static_cast<int64_t>(static_cast<double>(r.issuedRows) * stepMs / ms);
  r.rows = std::clamp(fitting, fewestRows, std::max(fewestRows, 2 * std::max(r.rows, r.issuedRows)));
}

// The step has passed the GPU: its estimate decides which picture is shown. True where that is to change. What is shown
// of two that are compared is not the cheap picture: the gathered one takes its place at as many samples of the light.
bool takeErrors(Refinement& r, bool compared, ViewerState& state) {
  if (!r.errors) return false;
  const frame::PictureErrors errors = frame::readErrors(*r.errors);
  r.errors.reset();
  // Of the cheap picture and the gathered one, whose errors are independent.
  r.parts.push_back(errors.parts);
  const frame::ErrorEstimate gathered = frame::errorEstimate(r.parts);
  const double cheap = cheapError(errors.shown, gathered);
  const bool better = compared ? r.gathering->done >= frame::convergedAbove : gathered.most < cheap;
  const bool change = !r.shown && (better || r.gathering->complete());
  r.shown |= change;
  r.estimate = gathered;
  state.refinement.error = r.shown ? gathered.most : compared ? -1 : cheap;
  return change;
}

// The picture is complete: true where its error asks for more samples, which then are gathered anew.
bool again(Refinement& r, const ViewerState& state) {
  if (!state.settings.quality.maxError || r.estimate.most < 0) return false;
  r.attempts.push_back({r.samples, r.estimate});
  const int samples = frame::nextSamples(gatheredSettings(state), r.attempts);
  if (samples > 0) r.samples = r.settings.quality.samples = samples;
  return samples > 0;
}

// The first half of the draws against the second; twice as many the next time.
Result<void> estimate(Viewport& viewport, const frame::FrameInput& in) {
  Refinement& r = viewport.refinement;
  frame::Gathering& gathering = *r.gathering;
  if (gathering.before > 0) {
    Result<frame::ErrorSums> errors = frame::sumErrors(in, r.targets, gathering, viewport.targets, viewport.programs);
    if (!errors) return tl::unexpected(errors.error());
    r.errors = std::move(*errors);
    if (Result<void> added = addToErrorView(viewport, in); !added) return added;
  }
  if (!gathering.complete()) frame::markBefore(r.targets, gathering);
  r.estimateAt = frame::nextEstimate(gathering.done, gathering.draws());
  return {};
}

Result<void> step(Viewport& viewport, ViewerState& state, const frame::FrameInput& in, bool& drew) {
  Refinement& r = viewport.refinement;
  const auto start = Clock::now();
  if (!r.timer) r.timer = gl::Timer::create();
  r.issuedRows = stepRows(r);
  r.timer.begin();
  Result<void> done = frame::gatherRows(in, r.targets, *r.gathering, r.issuedRows, viewport.programs);
  const frame::Gathering& gathering = *r.gathering;
  const bool whole = gathering.rows == 0 && gathering.done > 0;
  if (done && whole && gathering.done == r.estimateAt) done = estimate(viewport, in);
  if (done && whole && r.shown) {
    done = showPicture(viewport, in, r.targets, frame::meanScale(gathering), gathering.complete());
    state.refinement.shown = gathering.done;
    drew = true;
  }
  r.timer.end();
  glFlush();
  r.pending = true;
  r.issueMs = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  state.refinement.gathered = gathering.done;
  return done;
}

}  // namespace

void stopRefinement(Viewport& viewport, ViewerState& state) {
  Refinement& r = viewport.refinement;
  r.gathering.reset();
  r.errors.reset();
  r.pending = r.ended = r.shown = viewport.errorView.shown = false;
  r.since = Clock::now();
  if (r.movingFeatures) frame::setFeatures(viewport.shown.list, *r.movingFeatures);
  r.movingFeatures.reset();
  leaveTruthView(viewport, state);
  const frame::PictureSettings settings = gatheredSettings(state);
  if (!frame::converges(settings)) r.targets = {};
  r.samples = firstAttempt(settings);
  r.attempts.clear();
  r.estimate = {};
  state.refinement = {};
  if (frame::converges(settings)) state.refinement.wanted = r.samples;
}

std::string samplesShown(const Viewport& viewport, const ViewerState& state) {
  const Refinement& r = viewport.refinement;
  const RefinementStatus& s = state.refinement;
  if (!frame::converges(gatheredSettings(state)) || (r.ended && r.shown)) return {};
  const int cheap = std::min(frame::convergedAbove, state.settings.quality.samples);
  return std::to_string(s.shown > 0 ? s.shown : cheap) + " of " + std::to_string(s.wanted) + " samples";
}

double cheapError(double shown, const frame::ErrorEstimate& gathered) {
  const double square = shown * shown - gathered.likely * gathered.likely;
  return gathered.likely >= 0 && square > 0.5 * shown * shown ? std::sqrt(square) : -1;
}

bool refining(const Viewport& viewport, const ViewerState& state) {
  const bool preview = viewport.environments.shown && viewport.environments.shown->preview;
  return viewport.drawn && !viewport.moving.underWay && !viewport.next && !preview && !viewport.refinement.ended &&
         frame::converges(gatheredSettings(state)) && !viewport.shadersBroken &&
         frame::groundComplete(viewport.shown.ground.get(), state.settings);
}

namespace {

void setTextureDetail(Viewport& viewport) {
  const bool traced = viewport.shown.list.features.paths;
  frame::setTextureDetail(viewport.scene->gpu, traced ? frame::tracedDraws : viewport.refinement.gathering->draws(),
                          viewport.refinement.settings.quality.textureFilter, viewport.context);
}

}  // namespace

bool refine(Viewport& viewport, ViewerState& state, const scene::View& view) {
  Refinement& r = viewport.refinement;
  if (!refining(viewport, state) || (r.pending && !r.timer.ready())) return false;
  // What only the display reads may have changed since the draws began.
  r.settings = frame::withSamples(gatheredSettings(state), r.samples);
  if (!r.gathering) {
    if (Clock::now() - r.since < r.restDelay) return false;
    const Result<bool> ready = prepare(viewport, state, view);
    if (!ready) return giveUp(r, state, ready.error()), true;
    if (!*ready) return false;
    if (Result<void> begun = begin(viewport, state, view); !begun) return giveUp(r, state, begun.error()), true;
  }
  bool drew = false;
  frame::FrameInput in = frameInput(viewport, view);
  // Of the last whole sample.
  const bool timed = state.passesTimed && !viewport.passesDone;
  if (timed && r.gathering->rows == 0) viewport.passClock.take();
  if (timed) in.clock = &viewport.passClock;
  const int done = r.gathering->done;
  setTextureDetail(viewport);
  if (r.pending) {
    r.pending = false;
    adapt(r);
    const bool last = r.gathering->complete();
    if (takeErrors(r, frame::comparing(in) || againstTruth(state), state) || (last && !r.shown)) {
      r.shown = drew = true;
      if (Result<void> shown = showPicture(viewport, in, r.targets, frame::meanScale(*r.gathering), last); !shown)
        return giveUp(r, state, shown.error()), true;
      state.refinement.shown = r.gathering->done;
    }
    if (last && again(r, state)) {
      const int64_t rows = r.rows;  // the steps know how long they take by now
      if (Result<void> begun = begin(viewport, state, view); !begun) return giveUp(r, state, begun.error()), true;
      r.rows = rows, r.shown = false;
      setTextureDetail(viewport);
    } else if (last) {
      r.ended = true;
      log::debug("picture converged: " + std::to_string(r.gathering->draws()) + " samples");
    }
  }
  if (!r.ended)
    if (Result<void> stepped = step(viewport, state, in, drew); !stepped)
      return giveUp(r, state, stepped.error()), true;
  if (timed && r.gathering->rows == 0 && r.gathering->done > done) viewport.passesDone = true;
  return drew || r.ended;
}

}  // namespace facet::view
