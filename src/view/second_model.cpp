#include "view/second_model.hpp"

#include <chrono>
#include <utility>

#include "base/log.hpp"
#include "compare/compare.hpp"
#include "frame/blend_lists.hpp"
#include "scene/animation.hpp"
#include "view/bring_up.hpp"
#include "view/viewport.hpp"

namespace facet::view {

bool besideSecond(const ViewerState& state) { return !state.secondModel.empty() && state.second.how != Beside::off; }

namespace {

// The first one's, without what means nothing in another model.
frame::PictureSettings secondSettings(const ViewerState& state, const scene::Model& model) {
  frame::PictureSettings settings = state.settings;
  settings.placement.scene = -1;
  settings.placement.arrangement.edits.clear();
  settings.placement.arrangement.only.clear();
  settings.viewpoint.camera.clear();
  settings.comparison = {};
  if (!scene::chooseAnimations(model, settings.placement.animation)) settings.placement.animation.clear();
  if (!frame::chooseVariant(settings.look, model)) settings.look.variant.clear();
  return settings;
}

frame::Supply supplyOf(Viewport& viewport) {
  frame::Supply supply;
  supply.environment = [&](const std::string&) -> Result<frame::LoadedEnvironment*> {
    return viewport.environments.shown;
  };
  supply.measured = [&](const frame::MeasuredSource&) -> Result<std::shared_ptr<const frame::MeasuredOnGpu>> {
    return viewport.shown.inputs.list.measured;
  };
  supply.images = [&](frame::LoadedScene& scene, const std::vector<bool>& missing) -> Result<bool> {
    if (!decodes(viewport.second.loader, scene.loaded, missing))
      startImages(viewport.second.loader, scene.loaded, missing);
    return false;
  };
  supply.tables = [&](frame::LoadedEnvironment& environment, const ibl::Needs& needs) {
    return provideTables(static_cast<EnvironmentSlot&>(environment), needs, viewport.programs,
                         viewport.environments.immediateMs);
  };
  return supply;
}

// Draws the first one anew, alone or not.
void forget(Viewport& viewport, ViewerState& state) {
  SecondModel& second = viewport.second;
  second.loader.model.forget();
  second.loader.images.forget();
  second.plan = {.moving = true};
  second.shown = {};  // before the scene that its list points into goes
  second.scene.reset();
  second.watch = {};
  second.targets = {};
  second.pair = {};
  state.shown.second.clear();
  second.judged = false;
  second.flip.forget();
  state.shown.comparison.reset(), state.shown.flip.reset();
  viewport.comparison.sums.clear();
  viewport.drawn.reset();
}

void giveUpSecond(Viewport& viewport, ViewerState& state, const Error& error) {
  complain(state, error);
  state.secondModel.clear();
  viewport.second.asked.clear();
  forget(viewport, state);
}

void takeSecond(SecondModel& second, ModelLoaded loaded) {
  second.plan = {.moving = true};
  second.shown = {};  // before the scene that its list points into goes
  second.watch = std::move(loaded.watch);
  second.scene = std::make_unique<SceneSlot>();
  second.scene->source = loaded.source;
  second.scene->loaded = *loaded.model;
  second.scene->notes = second.scene->loaded->notes;
}

void prepareSecondTargets(Viewport& viewport) {
  SecondModel& second = viewport.second;
  const frame::PictureSettings& s = viewport.moving.settings;
  if (second.targets.width != s.frame.width || second.targets.height != s.frame.height ||
      second.targets.samples != s.quality.samples) {
    second.targets = {};  // the old ones go first
    second.targets = frame::createTargets(s, viewport.context);
  }
  frame::prepareBehind(second.targets, second.shown.list);
  frame::prepareBlendLists(second.targets, second.shown.list, s);
}

}  // namespace

void followSecond(Viewport& viewport, ViewerState& state, const Loader& loader) {
  SecondModel& second = viewport.second;
  if (second.asked != state.secondModel) {
    forget(viewport, state);
    second.asked = state.secondModel;
    second.loader.allowOutside = loader.allowOutside;
    if (!second.asked.empty()) startModel(second.loader, second.asked);
  }
  if (second.asked.empty()) return;
  if (second.scene && !second.loader.model.running() && !second.loader.images.running() &&
      filesChanged(second.watch, std::chrono::steady_clock::now()))
    startModel(second.loader, second.asked, Opening::again);
  if (std::optional<ModelLoaded> loaded = second.loader.model.take()) {
    if (!loaded->model && second.scene) {  // what is shown stays until the file's next change
      complain(state, loaded->model.error());
      return;
    }
    if (!loaded->model) return giveUpSecond(viewport, state, loaded->model.error());
    if (second.scene)
      say(state, "reloaded: " + second.asked), state.shown.second.clear(), second.loader.images.forget();
    takeSecond(second, std::move(*loaded));
  }
  if (std::optional<ImagesDecoded> images = second.loader.images.take(); images && second.scene) {
    if (!images->pixels) return giveUpSecond(viewport, state, images->pixels.error());
    keepImages(*second.scene, std::move(*images));
  }
  if (!second.scene || !viewport.scene || viewport.next || !viewport.environments.shown) return;
  const Result<bool> advanced =
      advanceSlice(viewport, second.plan, *second.scene, secondSettings(state, second.scene->model()),
                   second.shown.scene ? &second.shown : nullptr, supplyOf(viewport));
  if (!advanced) return giveUpSecond(viewport, state, advanced.error());
  if (!*advanced) return;
  second.shown = std::move(second.plan.next);
  second.plan.listed = false;
  if (state.shown.second != second.asked)
    for (const Note& remark : second.scene->notes)
      if (remark.severity == Note::Severity::warning)
        note(state, second.asked + ": " + (remark.place.empty() ? "" : remark.place + ": ") + remark.text, false);
  state.shown.second = second.asked;
  viewport.drawn.reset();
}

Result<void> drawSecond(Viewport& viewport, ViewerState& state) {
  SecondModel& second = viewport.second;
  second.pair.shown = second.judged = false;
  second.flip.forget();
  state.shown.flip.reset();
  second.drawnAt = std::chrono::steady_clock::now();
  if (!besideSecond(state) || !second.shown.scene || second.shown.environment != viewport.shown.environment ||
      viewport.shown.list.compared)
    return {};
  const frame::PictureSettings& settings = viewport.moving.settings;
  const Result<scene::View> own = viewOf(state, second.scene->model(), second.shown.list);
  const std::optional<scene::View> first = currentView(viewport, state);
  // Its own near plane, but where the camera is one of the first one's file.
  const scene::View view = own && settings.viewpoint.camera.empty() ? *own : *first;
  prepareSecondTargets(viewport);
  frame::setTextureDetail(second.scene->gpu, 1, settings.quality.textureFilter, viewport.context);
  const frame::FrameInput input = frame::frameInput(second.shown, view, settings);
  if (second.shown.screen) {
    frame::FrameStatistics statistics;
    if (Result<void> looked = frame::prepareScreen(input, *second.shown.screen, viewport.programs, statistics); !looked)
      return looked;
  }
  if (Result<frame::FrameStatistics> drawn = frame::drawFrame(input, second.targets, viewport.programs); !drawn)
    return tl::unexpected(drawn.error());
  second.pair.wish = state.second;
  const frame::Targets& targets = viewport.targets;
  if (Result<void> both =
          drawPair(second.pair, {targets.display, second.targets.display}, targets.noAttributes, viewport.programs);
      !both)
    return both;
  return compare(viewport, input, targets, 1, true);
}

void followFlip(Viewport& viewport, ViewerState& state) {
  SecondModel& second = viewport.second;
  if (const std::optional<double> flip = second.flip.take()) {
    if (*flip >= 0) state.shown.flip = *flip;
    log::debug("beside " + state.shown.second + ": FLIP " + std::to_string(*flip));
  }
  constexpr std::chrono::milliseconds rest(300);
  if (!second.pair.shown || second.judged || viewport.moving.underWay ||
      std::chrono::steady_clock::now() - second.drawnAt < rest)
    return;
  second.judged = true;
  second.flip.start(
      [first = frame::readDisplay(viewport.targets, true), other = frame::readDisplay(second.targets, true)] {
        const Result<compare::Comparison> compared =
            compare::comparePictures(compare::linearPicture(first), compare::linearPicture(other));
        return compared ? compared->flipMean : -1;
      });
}

Result<bool> followSecondView(Viewport& viewport, ViewerState& state) {
  SecondModel& second = viewport.second;
  if (second.pair.wish == state.second) return false;
  const bool begins = (second.pair.wish.how == Beside::off) != (state.second.how == Beside::off);
  second.pair.wish = state.second;
  if (begins && second.shown.scene) {
    second.pair.shown = false;
    state.shown.comparison.reset();
    viewport.drawn.reset();
  }
  if (!second.pair.shown) return false;
  const frame::Targets& targets = viewport.targets;
  return drawPair(second.pair, {targets.display, second.targets.display}, targets.noAttributes, viewport.programs)
      .map([] { return true; });
}

}  // namespace facet::view
