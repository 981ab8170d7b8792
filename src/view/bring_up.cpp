#include "view/bring_up.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "base/log.hpp"
#include "gl/context.hpp"
#include "scene/animation.hpp"
#include "scene/edited.hpp"
#include "view/describe.hpp"
#include "view/playback.hpp"

namespace facet::view {

namespace {

SceneSlot* wantedScene(const Viewport& viewport) { return viewport.next ? viewport.next.get() : viewport.scene.get(); }

// Where the plan's things come from: what is there, else read beside the window.
frame::Supply supplyBeside(Viewport& viewport, Loader& loader) {
  frame::Supply supply;
  supply.environment = [&](const std::string& source) -> Result<frame::LoadedEnvironment*> {
    EnvironmentSlot* slot = findEnvironment(viewport.environments, source);
    if (!slot && !(loader.environment.running() && viewport.loadingEnvironment == source))
      startEnvironment(loader, viewport.loadingEnvironment = source);
    return slot;
  };
  supply.measured = [&](const frame::MeasuredSource& source) {
    return findOrRead(viewport.measured, shownMeasured(viewport.shown), source, loader);
  };
  supply.fitted = [&](const frame::MeasuredSource& source, optics::DiffuseModel diffuse) {
    return findOrFit(viewport.measured, source, diffuse, loader);
  };
  supply.images = [&](frame::LoadedScene& scene, const std::vector<bool>& missing) -> Result<bool> {
    // While an animation plays, images that it has brought to light are waited for, not asked for anew each frame.
    if (!decodes(loader, scene.loaded, missing)) startImages(loader, scene.loaded, missing);
    return false;
  };
  supply.tables = [&](frame::LoadedEnvironment& environment, const ibl::Needs& needs) {
    return provideTables(static_cast<EnvironmentSlot&>(environment), needs, viewport.programs,
                         viewport.environments.immediateMs);
  };
  return supply;
}

// Of one pose to the next of what is shown: same programs and tables, nothing to be told.
void move(Viewport& viewport, ViewerState& state, frame::Drawable next) {
  stopRefinement(viewport, state);
  forgetTrees(viewport.trees);
  if (next.screen && viewport.shown.screen) {  // its textures serve again
    *next.screen = std::move(*viewport.shown.screen);
    next.screen->shadows.drawn = false;
  }
  viewport.shown = std::move(next);
  ++viewport.listNumber;
  state.shown.bounds = viewport.shown.list.bounds;
}

// The view of a scene that was not shown before.
void aim(const Viewport& viewport, ViewerState& state) {
  const double aspect = framingAspect(state);
  frame::Viewpoint& viewpoint = state.settings.viewpoint;
  if (!viewpoint.camera.empty()) {
    state.camera.roll = 0;
    state.camera = state.startCamera = scene::frameBounds(state.shown.bounds, aspect, state.camera);
    return;
  }
  // The projection and what is up stay as they were chosen.
  if (state.camera.orthographic) viewpoint.projection = frame::Projection::orthographic;
  if (viewpoint.up == frame::Viewpoint().up) viewpoint.up = state.camera.up;
  const scene::Bounds framing = frame::framingBounds(state.settings.placement, viewport.scene->model(),
                                                     viewport.shown.inputs.list.scene, state.shown.bounds);
  state.camera = state.startCamera = frame::chooseOrbit(viewpoint, aspect, state.shown.model, framing);
  viewpoint = {};
}

void tellNewScene(ViewerState& state, bool again, const std::vector<std::string>& with) {
  for (Message& message : state.messages) message.past = true;
  std::string text = (again ? "reloaded: " : "model: ") + state.shown.model;
  for (const std::string& other : with) text += ", with " + other;
  say(state, text);
  const std::vector<std::string>& warnings = state.shown.warnings;
  for (const std::string& warning : warnings) log::warning(warning), note(state, warning, false);
  if (!warnings.empty())
    state.status.text =
        warnings.size() == 1 ? warnings.front() : std::to_string(warnings.size()) + " warnings: " + warnings.front();
}

void show(Viewport& viewport, ViewerState& state, frame::Drawable next) {
  stopRefinement(viewport, state);
  forgetTrees(viewport.trees);
  const bool newScene = viewport.next != nullptr, again = newScene && viewport.next->again;
  const bool complained = !viewport.scene && state.status.isError;  // of what was to be shown, too
  const Status told = state.status;
  EnvironmentSlot* const environment = static_cast<EnvironmentSlot*>(next.environment);
  const frame::ListInputs before = viewport.shown.inputs.list;
  const bool otherScene = (newScene && !again) || before.scene != next.inputs.list.scene;
  const bool otherEnvironment = viewport.environments.shown != environment;
  const bool sameSource = viewport.environments.shown && viewport.environments.shown->source == environment->source;
  viewport.plan = {.moving = true};
  viewport.shown = std::move(next);  // before the scene that the old list points into goes
  ++viewport.listNumber;
  if (newScene) viewport.scene = std::move(viewport.next), viewport.programs.keepLatest(shading::keptPrograms);
  viewport.sketch = newScene && !again;
  viewport.comparison.sums.clear();
  viewport.moving.pixelNs = -1;  // other programs, another scene
  showEnvironment(viewport.environments, environment);
  describeShown(viewport, state);
  offerEnvironment(state, environment->source);
  if (otherScene || newScene) state.selection = {}, state.inspection = {}, state.measuredFrom.reset();
  if (otherScene) aim(viewport, state);
  if (otherEnvironment) say(state, (sameSource ? "reloaded: " : "environment: ") + environment->source);
  const auto& measured = viewport.shown.inputs.list.measured;
  if (before.measured != measured) {
    const bool sameMeasured = before.measured && measured && before.measured->facts.source == measured->facts.source;
    say(state, !measured ? "the materials' own look"
                         : (sameMeasured ? "reloaded: " : "measured BRDF: ") + measured->facts.path);
  }
  if (!newScene) return;
  tellNewScene(state, again, viewport.scene->with);
  if (!again && state.preferences.playOnOpening && state.settings.placement.animation.empty()) togglePlaying(state);
  if (complained) state.status = told;
}

// What the file no longer has is chosen anew.
void keepWhatFits(frame::PictureSettings& settings, const scene::Model& model) {
  if (!frame::chooseScene(settings.placement, model)) settings.placement.scene = -1;
  if (!frame::chooseVariant(settings.look, model)) settings.look.variant.clear();
  if (!scene::chooseAnimations(model, settings.placement.animation)) settings.placement.animation.clear();
  frame::Arrangement& arrangement = settings.placement.arrangement;
  std::erase_if(arrangement.edits, [&](const scene::Edit& edit) { return !scene::resolveEdit(model, edit); });
  if (!frame::choosePose(settings.placement, model)) arrangement.only.clear();
}

void returnToShownBrdf(const Viewport& viewport, ViewerState& state) {
  const frame::MeasuredSource shown = shownMeasured(viewport.shown);
  state.settings.sources.brdf = shown.name;
  if (shown.name.empty()) return;
  state.settings.sources.brdfDir = shown.folder;
  state.settings.sources.utiaDecode = shown.decode;
}

void returnToShown(Viewport& viewport, ViewerState& state) {
  viewport.next.reset();
  frame::PictureSettings& settings = state.settings;
  if (viewport.environments.shown && !settings.sources.environment.empty())
    settings.sources.environment = viewport.environments.shown->source;
  if (!viewport.scene) return;
  // What is wanted of it now may be a debug view, which has none.
  const bool shaded = shading::showsLight(std::max(0, shading::channelIndex(settings.look.channel)));
  if (!settings.sources.brdf.empty() && shaded) returnToShownBrdf(viewport, state);
  const frame::ListInputs& shown = viewport.shown.inputs.list;
  settings.placement.scene = shown.scene;
  settings.placement.arrangement = shown.arrangement;
  settings.look.variant = shown.options.variant < 0 ? "" : std::to_string(shown.options.variant);
}

// Gives up what cannot be drawn and returns to what is shown.
void giveUp(Viewport& viewport, ViewerState& state, const Error& error) {
  complain(state, error);
  state.modelFailed = true;
  returnToShown(viewport, state);
}

// Whether the model has what the settings name of it.
Result<void> checkNames(const frame::PictureSettings& settings, const std::string& source, const scene::Model& model) {
  const Result<int> index = frame::chooseScene(settings.placement, model);
  if (!index) return tl::unexpected(index.error());
  if (const Result<scene::Pose> pose = frame::choosePose(settings.placement, model); !pose)
    return tl::unexpected(pose.error());
  if (const Result<int> variant = frame::chooseVariant(settings.look, model); !variant)
    return tl::unexpected(variant.error());
  if (settings.viewpoint.camera.empty()) return {};
  const frame::DrawList list = frame::buildDrawList(model, *index, frame::drawOptions(settings, false));
  if (Result<scene::View> view = frame::chooseView(settings.viewpoint, 1, source, model, list, list.bounds); !view)
    return tl::unexpected(view.error());
  return {};
}

// What means nothing in another model; of the view only what was not yet used.
void forgetNames(frame::PictureSettings& settings) {
  settings.viewpoint.camera.clear();
  settings.placement.scene = -1;
  settings.placement.animation.clear();
  settings.placement.arrangement = {};
  settings.look.variant.clear();
  settings.viewpoint.orbit.reset();
  settings.viewpoint.target.reset();
}

}  // namespace

void takeModel(Viewport& viewport, ViewerState& state, ModelLoaded loaded) {
  Result<void> usable;
  if (!loaded.model)
    usable = tl::unexpected(loaded.model.error());
  else if (loaded.opening == Opening::first)
    usable = checkNames(state.settings, loaded.source, (*loaded.model)->model);
  if (!usable) {
    state.modelFailed = true;
    state.settings.sources.with = viewport.scene ? viewport.scene->with : std::vector<std::string>();
    return complain(state, usable.error());
  }
  if (loaded.opening == Opening::again) keepWhatFits(state.settings, (*loaded.model)->model);
  if (loaded.opening == Opening::other) {
    if (const std::optional<scene::View> view = currentView(viewport, state)) freeCamera(state, *view);
    forgetNames(state.settings);
    state.playback.playing = false;
  }
  auto slot = std::make_unique<SceneSlot>();
  slot->source = loaded.source;
  slot->again = loaded.opening == Opening::again;
  slot->loaded = *loaded.model;
  slot->watch = std::move(loaded.watch);
  slot->with = std::move(loaded.with), slot->bump = std::move(loaded.bump);
  slot->notes = slot->loaded->notes;
  state.settings.placement.animation = animationOption(slot->loaded->model, state.settings.placement.animation);
  viewport.next = std::move(slot);
  viewport.plan = {.moving = true};
}

void takeEnvironment(Viewport& viewport, ViewerState& state, EnvironmentLoaded loaded) {
  if (!loaded.environment) {
    complain(state, loaded.environment.error());
    if (loaded.again) return;
    std::erase(state.environments, loaded.source);
    if (state.settings.sources.environment == loaded.source)
      state.settings.sources.environment =
          viewport.environments.shown ? viewport.environments.shown->source : std::string();
    return;
  }
  EnvironmentSlot* before = findEnvironment(viewport.environments, loaded.source);
  if (before && !loaded.again) return;
  if (before) before->stale = true;
  auto slot = std::make_unique<EnvironmentSlot>();
  slot->source = loaded.source;
  slot->environment = *loaded.environment;
  slot->prepared = std::move(loaded.prepared);
  frame::findSun(*slot);
  slot->cache = viewport.tableCache;
  slot->content = std::move(loaded.content);
  slot->notes = std::move(loaded.notes);
  viewport.environments.slots.push_back(std::move(slot));
}

void takeMeasured(Viewport& viewport, ViewerState& state, MeasuredLoaded loaded) {
  if (!loaded.read) {
    complain(state, loaded.read.error());
    viewport.measured.asked.reset();
    if (!loaded.again && frame::measuredSource(state.settings.sources) == loaded.source)
      returnToShownBrdf(viewport, state);
    return;
  }
  viewport.measured.files[loaded.read->facts.path] = std::move(loaded.watch);
  if (loaded.source == state.lobe.source) state.lobe.source = {};  // the file has changed
  frame::keepMeasured(viewport.measured.store, frame::uploadMeasured(std::move(*loaded.read)));
  viewport.plan.failed.reset();
}

void takeFit(Viewport& viewport, ViewerState& state, FitMade made) {
  if (!made.fit) return complain(state, made.fit.error());
  frame::keepFit(viewport.measured.store, frame::uploadFitted(std::move(*made.fit)));
  viewport.measured.fitAsked.reset();
}

void takeImages(Viewport& viewport, ViewerState& state, ImagesDecoded decoded) {
  SceneSlot* scene = wantedScene(viewport);
  if (!scene || decoded.model != scene->loaded) return;  // of a model that is no longer wanted
  if (!decoded.pixels) {
    viewport.plan.failed = viewport.plan.next.inputs;
    return giveUp(viewport, state, decoded.pixels.error());
  }
  keepImages(*scene, std::move(decoded));
}

void keepImages(frame::LoadedScene& scene, ImagesDecoded decoded) {
  scene.notes.insert(scene.notes.end(), decoded.notes.begin(), decoded.notes.end());
  scene.pixels.resize(decoded.pixels->size());
  for (size_t i = 0; i < decoded.pixels->size(); ++i)
    if ((*decoded.pixels)[i].width > 0) scene.pixels[i] = std::move((*decoded.pixels)[i]);
}

Result<bool> advanceSlice(Viewport& viewport, frame::Plan& plan, frame::LoadedScene& scene,
                          const frame::PictureSettings& wish, const frame::Drawable* shown,
                          const frame::Supply& supply) {
  const auto end = std::chrono::steady_clock::now() + viewport.slice;
  const frame::KeepGoing keepGoing = [&, first = true]() mutable {
    glFinish();  // else what was asked for is done in the window's time
    return std::exchange(first, false) || std::chrono::steady_clock::now() < end;
  };
  for (;;) {
    const Result<frame::Step> step = frame::advance(plan, scene, wish, shown, supply, viewport.programs, keepGoing);
    if (!step) return tl::unexpected(step.error());
    const bool worked = step->progress == frame::Progress::working || step->progress == frame::Progress::done;
    if (const Result<void> whole = worked ? gl::checkDriver("what is to be shown") : Result<void>(); !whole) {
      plan.failed = plan.next.inputs;
      return tl::unexpected(whole.error());
    }
    if (step->progress == frame::Progress::done) return true;
    if (step->progress != frame::Progress::working) return false;
    if (std::chrono::steady_clock::now() >= end) return viewport.comingUp = true, false;
  }
}

bool bringUp(Viewport& viewport, ViewerState& state, Loader& loader) {
  viewport.comingUp = false;
  SceneSlot* scene = wantedScene(viewport);
  if (!scene) return false;
  std::string& animation = state.settings.placement.animation;
  if (const auto known = scene::chooseAnimations(scene->model(), animation); !known)
    complain(state, known.error()), animation.clear();
  const frame::Drawable* shown = viewport.scene ? &viewport.shown : nullptr;
  const Result<bool> complete =
      advanceSlice(viewport, viewport.plan, *scene, state.settings, shown, supplyBeside(viewport, loader));
  if (!complete) return giveUp(viewport, state, complete.error()), false;
  if (!*complete) return false;
  frame::Drawable next = std::move(viewport.plan.next);
  viewport.plan.listed = false;
  const bool moved = shown && shown->scene == scene && frame::differInTimeOnly(next.inputs, shown->inputs);
  moved ? move(viewport, state, std::move(next)) : show(viewport, state, std::move(next));
  return true;
}

void cancelLoading(Viewport& viewport, ViewerState& state, Loader& loader) {
  loader.model.forget();
  loader.environment.forget();
  loader.measured.forget();
  loader.images.forget();
  viewport.loadingEnvironment.clear();
  viewport.measured.loading = {};
  viewport.measured.asked.reset();
  if (viewport.plan.listed) viewport.plan.failed = viewport.plan.next.inputs;
  returnToShown(viewport, state);
  say(state, "loading cancelled");
}

}  // namespace facet::view
