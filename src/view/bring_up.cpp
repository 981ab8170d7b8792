#include "view/bring_up.hpp"

#include <algorithm>
#include <chrono>
#include <functional>
#include <utility>

#include "base/log.hpp"
#include "view/describe.hpp"

namespace facet::view {

namespace {

SceneSlot* wantedScene(const Viewport& viewport) { return viewport.next ? viewport.next.get() : viewport.scene.get(); }

// Of one pose to the next of what is shown: same programs and tables, nothing to be told.
void move(Viewport& viewport, ViewerState& state, frame::DrawList list, const ListRequest& request) {
  stopRefinement(viewport, state);
  viewport.list = std::move(list);
  viewport.built = request;
  viewport.asked.reset();
  ++viewport.listNumber;
  state.shown.bounds = viewport.list.bounds;
}

// Everything on the GPU that the list reads, a slice of it a turn. True where all of it is there.
Result<bool> putOnGpu(Viewport& viewport, SceneSlot& scene, EnvironmentSlot& environment, const frame::DrawList& list,
                      const ListRequest& request, const ViewerState& state) {
  const scene::Model& model = scene.loaded->model;
  const auto end = std::chrono::steady_clock::now() + viewport.slice;
  const frame::KeepGoing keepGoing = [&, first = true]() mutable {
    glFinish();  // else what was asked for is done in the window's time
    return std::exchange(first, false) || std::chrono::steady_clock::now() < end;
  };
  if (!frame::uploadScene(scene.onGpu.gpu, model, list, keepGoing)) return false;
  if (!frame::uploadImages(scene.onGpu.gpu, model, frame::textureUses(model, list), scene.pixels, keepGoing))
    return false;
  scene.pixels.clear();
  ibl::Needs needs = list.needs(request.skyVisible);
  // Made on the way to the others; at rest it is sampled.
  needs.cube |= needs.irradiance && frame::converges(state.settings);
  if (frame::chooseMethod(environment.onGpu, state.settings)) cancelSharpening(environment);
  if (Result<void> r = provideTables(environment, needs, viewport.programs, viewport.environments.immediateMs); !r)
    return tl::unexpected(r.error());
  const ibl::Tables& tables = environment.onGpu.tables;
  const scene::View view = scene::orbitView(state.camera, 1, list.bounds);
  return frame::prepareNextProgram({model, list, scene.onGpu.gpu, tables, view, state.settings}, viewport.programs);
}

void show(Viewport& viewport, ViewerState& state, EnvironmentSlot* environment, frame::DrawList list,
          const ListRequest& request) {
  stopRefinement(viewport, state);
  const bool newScene = viewport.next != nullptr, again = newScene && viewport.next->again;
  const bool complained = !viewport.scene && state.status.isError;  // of what was to be shown, too
  const Status told = state.status;
  const bool otherScene = (newScene && !again) || viewport.built.scene != request.scene;
  const bool otherEnvironment = viewport.environments.shown != environment;
  const bool otherMeasured = viewport.built.measured != request.measured;
  const bool sameMeasured = viewport.built.measured && viewport.built.brdf == request.brdf;
  const bool sameSource = viewport.environments.shown && viewport.environments.shown->source == environment->source;
  viewport.asked.reset();
  viewport.failed.reset();
  viewport.list = std::move(list);  // before the scene that the old list points into goes
  viewport.built = request;
  ++viewport.listNumber;
  if (newScene) viewport.scene = std::move(viewport.next);
  viewport.sketch = newScene && !again;
  viewport.scene->onGpu.gpu.measured = request.measured;
  viewport.scene->onGpu.gpu.fitted = request.fitted;
  viewport.comparison.sums.clear();
  showEnvironment(viewport.environments, environment);
  describeShown(viewport, state);
  offerEnvironment(state, environment->source);
  if (otherScene || newScene) state.selection = {}, state.inspection = {};
  if (otherScene && state.settings.viewpoint.camera.empty()) {
    const scene::Bounds framing =
        frame::framingBounds(state.settings, viewport.scene->loaded->model, request.scene, state.shown.bounds);
    state.camera = state.startCamera = frame::chooseOrbit(state.settings, state.shown.model, framing);
    state.settings.viewpoint.orbit.reset();
    state.settings.viewpoint.target.reset();
    state.settings.viewpoint.fovYDeg.reset();
  } else if (otherScene) {
    state.startCamera =
        scene::frameBounds(state.shown.bounds, state.camera.fovY,
                           static_cast<double>(state.settings.frame.width) / state.settings.frame.height);
    state.camera = state.startCamera;
  }
  if (otherEnvironment) say(state, (sameSource ? "reloaded: " : "environment: ") + environment->source);
  if (otherMeasured)
    say(state, !request.measured ? "the materials' own look"
                                 : (sameMeasured ? "reloaded: " : "measured BRDF: ") + request.measured->facts.path);
  if (!newScene) return;
  const size_t warnings = state.shown.warnings.size();
  say(state, (again ? "reloaded: " : "model: ") + state.shown.model);
  for (const std::string& warning : state.shown.warnings) log::warning(warning);
  if (warnings > 0)
    state.status = {state.shown.model + ": " + std::to_string(warnings) + (warnings > 1 ? " warnings" : " warning"),
                    true};
  if (complained) state.status = told;
}

// What the file no longer has is chosen anew.
void keepWhatFits(frame::PictureSettings& settings, const scene::Model& model) {
  if (!frame::chooseScene(settings, model)) settings.placement.scene = -1;
  if (!frame::chooseVariant(settings, model)) settings.look.variant.clear();
  if (!frame::choosePose(settings, model)) settings.placement.animation.clear();
}

void returnToShownBrdf(const Viewport& viewport, ViewerState& state) {
  state.settings.sources.brdf = viewport.built.brdf.name;
  if (state.settings.sources.brdf.empty()) return;
  state.settings.sources.brdfDir = viewport.built.brdf.folder;
  state.settings.sources.utiaDecode = viewport.built.brdf.decode;
}

void returnToShown(Viewport& viewport, ViewerState& state, const std::optional<ListRequest>& request) {
  viewport.failed = request;
  viewport.next.reset();
  if (viewport.environments.shown && !state.settings.sources.environment.empty())
    state.settings.sources.environment = viewport.environments.shown->source;
  if (!viewport.scene) return;
  // What is wanted of it now may be a debug view, which has none.
  if (!state.settings.sources.brdf.empty() && state.settings.look.channel.empty()) returnToShownBrdf(viewport, state);
  state.settings.placement.scene = viewport.built.scene;
  state.settings.look.variant = viewport.built.variant < 0 ? "" : std::to_string(viewport.built.variant);
}

// Gives up what cannot be drawn and returns to what is shown.
void giveUp(Viewport& viewport, ViewerState& state, const std::optional<ListRequest>& request, const Error& error) {
  complain(state, error);
  state.modelFailed = true;
  returnToShown(viewport, state, request);
}

// Whether the model has what the settings name of it.
Result<void> checkNames(const frame::PictureSettings& settings, const std::string& source, const scene::Model& model) {
  const Result<int> index = frame::chooseScene(settings, model);
  if (!index) return tl::unexpected(index.error());
  if (const Result<scene::Pose> pose = frame::choosePose(settings, model); !pose) return tl::unexpected(pose.error());
  if (const Result<int> variant = frame::chooseVariant(settings, model); !variant)
    return tl::unexpected(variant.error());
  if (settings.viewpoint.camera.empty()) return {};
  const frame::DrawList list = frame::buildDrawList(model, *index, frame::drawOptions(settings, false));
  if (Result<scene::View> view = frame::chooseView(settings, source, model, list, list.bounds); !view)
    return tl::unexpected(view.error());
  return {};
}

// What means nothing in another model; of the view only what was not yet used.
void forgetNames(frame::PictureSettings& settings) {
  settings.viewpoint.camera.clear();
  settings.placement.scene = -1;
  settings.placement.animation.clear();
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
  slot->onGpu.source = loaded.source;
  slot->onGpu.model = &slot->loaded->model;
  slot->notes = slot->loaded->notes;
  state.settings.placement.animation = animationOption(slot->loaded->model, state.settings.placement.animation);
  viewport.next = std::move(slot);
  viewport.failed.reset();
  viewport.asked.reset();
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
  slot->onGpu.environment = slot->environment.get();
  slot->onGpu.prepared = std::move(loaded.prepared);
  frame::findSun(slot->onGpu);
  slot->onGpu.cache = viewport.tableCache;
  slot->onGpu.content = std::move(loaded.content);
  slot->notes = std::move(loaded.notes);
  viewport.environments.slots.push_back(std::move(slot));
}

void takeMeasured(Viewport& viewport, ViewerState& state, MeasuredLoaded loaded) {
  if (!loaded.read) {
    complain(state, loaded.read.error());
    viewport.measured.asked.reset();
    if (!loaded.again && frame::measuredSource(state.settings) == loaded.source) returnToShownBrdf(viewport, state);
    return;
  }
  viewport.measured.files[loaded.read->facts.path] = std::move(loaded.watch);
  frame::keepMeasured(viewport.measured.store, frame::uploadMeasured(std::move(*loaded.read)));
  viewport.failed.reset();
}

void takeFit(Viewport& viewport, ViewerState& state, FitMade made) {
  if (!made.fit) return complain(state, made.fit.error());
  frame::keepFit(viewport.measured.store, frame::uploadFitted(std::move(*made.fit)));
  viewport.measured.fitAsked.reset();
}

void takeImages(Viewport& viewport, ViewerState& state, ImagesDecoded decoded) {
  SceneSlot* scene = wantedScene(viewport);
  if (!scene || decoded.model != scene->loaded) return;  // of a model that is no longer wanted
  if (!decoded.pixels) return giveUp(viewport, state, viewport.asked, decoded.pixels.error());
  scene->notes.insert(scene->notes.end(), decoded.notes.begin(), decoded.notes.end());
  scene->pixels.resize(decoded.pixels->size());
  for (size_t i = 0; i < decoded.pixels->size(); ++i)
    if ((*decoded.pixels)[i].width > 0) scene->pixels[i] = std::move((*decoded.pixels)[i]);
}

bool bringUp(Viewport& viewport, ViewerState& state, Loader& loader) {
  viewport.comingUp = false;
  SceneSlot* scene = wantedScene(viewport);
  if (!scene) return false;
  const scene::Model& model = scene->loaded->model;
  const Result<int> index = frame::chooseScene(state.settings, model);
  if (!index) return giveUp(viewport, state, std::nullopt, index.error()), false;
  const Result<int> variant = frame::chooseVariant(state.settings, model);
  if (!variant) return giveUp(viewport, state, std::nullopt, variant.error()), false;
  const std::string source = frame::chooseEnvironment(state.settings, scene->source, model, *index);
  EnvironmentSlot* environment = findEnvironment(viewport.environments, source);
  if (!environment && !(loader.environment.running() && viewport.loadingEnvironment == source)) {
    startEnvironment(loader, source);
    viewport.loadingEnvironment = source;
  }
  ListRequest request = listRequest(state, *index, *variant, source != "none");
  if (environment) request.sun = environment->onGpu.sun;
  if (!request.brdf.name.empty()) {
    if (!provideMeasured(viewport.measured, viewport.built, loader, request)) return false;
    provideFit(viewport.measured, state.settings, loader, request);
  }
  const bool isShown = scene == viewport.scene.get() && environment == viewport.environments.shown;
  if ((isShown && request == viewport.built) || request == viewport.failed) return false;
  // While an animation plays, images that it has brought to light are waited for, not asked for anew each frame.
  const bool asked = viewport.asked && differsInTimeOnly(request, *viewport.asked);
  if (asked && (!environment || loader.images.running())) return false;

  const Result<scene::Pose> pose = frame::choosePose(state.settings, model);
  if (!pose) {
    complain(state, pose.error());
    state.settings.placement.animation.clear();
    return false;
  }
  frame::DrawOptions options = drawOptions(state, *variant, source != "none");
  options.sun = request.sun;
  options.features.imageLightSamples = request.imageLightSamples;
  if (request.measured)
    frame::setMeasured(options.features, state.settings, request.measured->facts.kind, request.measured->facts.proxy);
  if (request.fitted) frame::setFitted(options, state.settings);
  frame::DrawList list = frame::buildDrawList(model, *index, options, *pose);
  std::vector<bool> missing = frame::missingImages(model, list, scene->onGpu.gpu);
  for (size_t i = 0; i < scene->pixels.size(); ++i) missing[i] = missing[i] && scene->pixels[i].width == 0;
  const bool complete = std::ranges::none_of(missing, std::identity());
  viewport.asked = request;
  if (!complete) startImages(loader, scene->loaded, std::move(missing));
  if (!complete || !environment) return false;

  const Result<bool> ready = putOnGpu(viewport, *scene, *environment, list, request, state);
  if (!ready) return giveUp(viewport, state, request, ready.error()), false;
  viewport.comingUp = !*ready;
  if (!*ready) return false;
  if (isShown && differsInTimeOnly(request, viewport.built))
    move(viewport, state, std::move(list), request);
  else
    show(viewport, state, environment, std::move(list), request);
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
  returnToShown(viewport, state, viewport.asked);
  viewport.asked.reset();
  say(state, "loading cancelled");
}

}  // namespace facet::view
