#include "view/viewport.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <utility>

#include "base/log.hpp"
#include "frame/gather.hpp"

namespace facet::view {

namespace {

void say(ViewerState& state, const std::string& text) {
  state.status = {text, false};
  log::debug(text);
}

void complain(ViewerState& state, const Error& error) {
  state.status = {describe(error), true};
  log::error(state.status.text);
}

SceneSlot* wantedScene(const Viewport& viewport) { return viewport.next ? viewport.next.get() : viewport.scene.get(); }

void describeNotes(const Viewport& viewport, ShownScene& shown) {
  shown.warnings.clear();
  shown.infos.clear();
  const auto add = [&](const std::string& source, const Notes& notes) {
    for (const Note& note : notes) {
      const std::string text = describe({source, note.place, note.text, {}});
      (note.severity == Note::Severity::warning ? shown.warnings : shown.infos).push_back(text);
    }
  };
  add(viewport.scene->loaded->model.name, viewport.scene->notes);
  add(viewport.environments.shown->source, viewport.environments.shown->notes);
  if (!viewport.built.measured) return;
  add(viewport.built.measured->facts.path, viewport.built.measured->facts.notes);
  Notes drawn;
  frame::noteMeasured(viewport.list, drawn);
  add("", drawn);
}

void describeShown(const Viewport& viewport, ViewerState& state) {
  const scene::Model& model = viewport.scene->loaded->model;
  ShownScene& shown = state.shown;
  shown.content = {viewport.scene->loaded, &model};
  shown.model = viewport.scene->source;
  shown.environment = viewport.environments.shown->source;
  shown.scene = viewport.built.scene;
  shown.bounds = viewport.list.bounds;
  shown.cameras.clear();
  for (const frame::FileCamera& camera : viewport.list.cameras) {
    const std::string& node = model.nodes[static_cast<size_t>(camera.placed.node)].name;
    const std::string& name = camera.lens.name.empty() ? node : camera.lens.name;
    const std::string index = std::to_string(camera.placed.camera);
    shown.cameras.push_back({name.empty() ? index : name, name.empty() ? "camera " + index : name});
  }
  shown.animations = animationNames(model);
  shown.scenes.clear();
  for (size_t i = 0; i < model.scenes.size(); ++i)
    shown.scenes.push_back(model.scenes[i].name.empty() ? "scene " + std::to_string(i) : model.scenes[i].name);
  shown.variants.clear();
  for (size_t i = 0; i < model.variants.size(); ++i)
    shown.variants.push_back(model.variants[i].empty() ? "variant " + std::to_string(i) : model.variants[i]);
  shown.variant = viewport.built.variant;
  shown.sceneLights = static_cast<int>(scene::flatten(model, shown.scene).lights.size());
  shown.measured.reset();
  if (viewport.built.measured) shown.measured = viewport.built.measured->facts;
  shown.fit.reset();
  if (viewport.built.fitted) shown.fit = viewport.built.fitted->fitted;
  shown.compared = viewport.list.compared;
  shown.comparison.reset();
  shown.statistics.variants = variantCount(viewport.list);
  shown.statistics.images = static_cast<int>(model.images.size());
  describeNotes(viewport, shown);
}

// Of one pose to the next of what is shown: same programs and tables, nothing to be told.
void move(Viewport& viewport, ViewerState& state, frame::DrawList list, const ListRequest& request) {
  stopRefinement(viewport, state);
  viewport.list = std::move(list);
  viewport.built = request;
  viewport.asked.reset();
  ++viewport.listNumber;
  state.shown.bounds = viewport.list.bounds;
}

void measureMemory(const Viewport& viewport, ViewerStatistics& statistics) {
  const frame::GpuScene& gpu = viewport.scene->onGpu.gpu;
  statistics.imagesDecoded = gpu.imagesDecoded;
  statistics.textureBytes = gpu.textureBytes();
  statistics.geometryBytes = gpu.geometryBytes();
  statistics.tableBytes = viewport.environments.shown->onGpu.tables.bytes();
  statistics.targetBytes = frame::targetBytes(viewport.targets) + frame::targetBytes(viewport.refinement.targets);
  statistics.measuredBytes = 0;
  for (const auto& kept : viewport.measured.kept) statistics.measuredBytes += kept->buffer.bytes();
  statistics.programsCompiled = viewport.programs.statistics().compiled;
  statistics.programsFromDisk = viewport.programs.statistics().fromDisk;
}

// Everything on the GPU that the list reads, a slice of it a turn. True where all of it is there.
Result<bool> putOnGpu(Viewport& viewport, SceneSlot& scene, EnvironmentSlot& environment, const frame::DrawList& list,
                      const ListRequest& request, const ViewerState& state) {
  const scene::Model& model = scene.loaded->model;
  const auto end = std::chrono::steady_clock::now() + viewport.slice;
  const frame::KeepGoing keepGoing = [&, first = true]() mutable {
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
  viewport.scene->onGpu.gpu.measured = request.measured;
  viewport.scene->onGpu.gpu.fitted = request.fitted;
  viewport.comparison.clear();
  showEnvironment(viewport.environments, environment);
  describeShown(viewport, state);
  offerEnvironment(state, environment->source);
  if (otherScene || newScene) state.selection = {}, state.inspection = {};
  if (otherScene && state.settings.camera.empty()) {
    const scene::Bounds framing =
        frame::framingBounds(state.settings, viewport.scene->loaded->model, request.scene, state.shown.bounds);
    state.camera = state.startCamera = frame::chooseOrbit(state.settings, state.shown.model, framing);
    state.settings.orbit.reset();
    state.settings.target.reset();
    state.settings.fovYDeg.reset();
  } else if (otherScene) {
    state.startCamera = scene::frameBounds(state.shown.bounds, state.camera.fovY,
                                           static_cast<double>(state.settings.width) / state.settings.height);
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
}

// What the file no longer has is chosen anew.
void keepWhatFits(frame::PictureSettings& settings, const scene::Model& model) {
  if (!frame::chooseScene(settings, model)) settings.scene = -1;
  if (!frame::chooseVariant(settings, model)) settings.variant.clear();
  if (!frame::choosePose(settings, model)) settings.animation.clear();
}

void returnToShownBrdf(const Viewport& viewport, ViewerState& state) {
  state.settings.brdf = viewport.built.brdf.name;
  if (state.settings.brdf.empty()) return;
  state.settings.brdfDir = viewport.built.brdf.folder;
  state.settings.utiaDecode = viewport.built.brdf.decode;
}

void returnToShown(Viewport& viewport, ViewerState& state, const std::optional<ListRequest>& request) {
  viewport.failed = request;
  viewport.next.reset();
  if (viewport.environments.shown && !state.settings.environment.empty())
    state.settings.environment = viewport.environments.shown->source;
  if (!viewport.scene) return;
  // What is wanted of it now may be a debug view, which has none.
  if (!state.settings.brdf.empty() && state.settings.channel.empty()) returnToShownBrdf(viewport, state);
  state.settings.scene = viewport.built.scene;
  state.settings.variant = viewport.built.variant < 0 ? "" : std::to_string(viewport.built.variant);
}

// Gives up what cannot be drawn and returns to what is shown.
void giveUp(Viewport& viewport, ViewerState& state, const std::optional<ListRequest>& request, const Error& error) {
  complain(state, error);
  returnToShown(viewport, state, request);
}

}  // namespace

FrameClock::Slot* FrameClock::begin() {
  for (Slot& slot : slots) {
    if (slot.pending) continue;
    if (!slot.timer) slot.timer = gl::Timer::create();
    slot.timer.begin();
    slot.pending = true;
    return &slot;
  }
  return nullptr;
}

void FrameClock::end(Slot* slot) const {
  if (slot) slot->timer.end();
}

bool FrameClock::waiting() const {
  return std::ranges::any_of(slots, [](const Slot& slot) { return slot.pending; });
}

std::optional<double> FrameClock::poll() {
  for (Slot& slot : slots) {
    if (!slot.pending || !slot.timer.ready()) continue;
    slot.pending = false;
    return slot.timer.milliseconds();
  }
  return std::nullopt;
}

void takeModel(Viewport& viewport, ViewerState& state, ModelLoaded loaded) {
  if (!loaded.model) {
    complain(state, loaded.model.error());
    return;
  }
  const bool first = !viewport.scene && !viewport.next;
  if (loaded.again) {
    keepWhatFits(state.settings, (*loaded.model)->model);
  } else if (!first) {  // the old model's cameras, scenes and variants mean nothing in the new one
    if (const std::optional<scene::View> view = currentView(viewport, state)) freeCamera(state, *view);
    state.settings.camera.clear();
    state.settings.scene = -1;
    state.settings.animation.clear();
    state.playback.playing = false;
    state.settings.variant.clear();
  }
  auto slot = std::make_unique<SceneSlot>();
  slot->source = loaded.source;
  slot->again = loaded.again;
  slot->loaded = *loaded.model;
  slot->watch = std::move(loaded.watch);
  slot->onGpu.source = loaded.source;
  slot->onGpu.model = &slot->loaded->model;
  slot->notes = slot->loaded->notes;
  state.settings.animation = animationOption(slot->loaded->model, state.settings.animation);
  viewport.next = std::move(slot);
  viewport.failed.reset();
  viewport.asked.reset();
}

void takeEnvironment(Viewport& viewport, ViewerState& state, EnvironmentLoaded loaded) {
  if (!loaded.environment) {
    complain(state, loaded.environment.error());
    if (loaded.again) return;
    std::erase(state.environments, loaded.source);
    if (state.settings.environment == loaded.source)
      state.settings.environment = viewport.environments.shown ? viewport.environments.shown->source : "none";
    return;
  }
  EnvironmentSlot* before = findEnvironment(viewport.environments, loaded.source);
  if (before && !loaded.again) return;
  if (before) before->stale = true;
  auto slot = std::make_unique<EnvironmentSlot>();
  slot->source = loaded.source;
  slot->environment = *loaded.environment;
  slot->onGpu.environment = slot->environment.get();
  frame::findSun(slot->onGpu);
  slot->onGpu.cache = viewport.tableCache;
  slot->onGpu.content = std::move(loaded.content);
  slot->notes = std::move(loaded.notes);
  viewport.environments.slots.push_back(std::move(slot));
}

void takeMeasured(Viewport& viewport, ViewerState& state, MeasuredLoaded loaded) {
  if (!loaded.read) {
    complain(state, loaded.read.error());
    viewport.measuredAsked.reset();
    if (!loaded.again && frame::measuredSource(state.settings) == loaded.source) returnToShownBrdf(viewport, state);
    return;
  }
  viewport.measuredFiles[loaded.read->facts.path] = std::move(loaded.watch);
  frame::keepMeasured(viewport.measured, frame::uploadMeasured(std::move(*loaded.read)));
  viewport.failed.reset();
}

void takeFit(Viewport& viewport, ViewerState& state, FitMade made) {
  if (!made.fit) return complain(state, made.fit.error());
  frame::keepFit(viewport.measured, frame::uploadFitted(std::move(*made.fit)));
  viewport.fitAsked.reset();
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

namespace {

// Asks for the measured BRDF of the request where it is not there. True where it is.
bool provideMeasured(Viewport& viewport, Loader& loader, ListRequest& request) {
  const bool asked = viewport.measuredAsked && viewport.measuredAsked->source == request.brdf;
  if (viewport.built.brdf != request.brdf && !asked)
    viewport.measuredAsked = MeasuredAsked{request.brdf, std::chrono::steady_clock::now()};
  request.measured = frame::keptMeasured(viewport.measured, request.brdf);
  if (request.measured) return true;
  if (!loader.measured.running() || viewport.loadingMeasured != request.brdf) startMeasured(loader, request.brdf);
  viewport.loadingMeasured = request.brdf;
  return false;
}

// Asks for the model that is fitted to it, where that is wanted and not there; until then the measured BRDF is shown.
void provideFit(Viewport& viewport, const frame::PictureSettings& settings, Loader& loader, ListRequest& request) {
  if (settings.brdfCompare == frame::BrdfCompare::none) return;
  request.fitted = frame::keptFit(viewport.measured, request.brdf, settings.diffuse);
  request.compared = request.fitted && settings.brdfCompare != frame::BrdfCompare::fit;
  const FitAsked wanted{request.brdf, settings.diffuse};
  if (request.fitted || viewport.fitAsked == wanted) return;
  startFit(loader, wanted.source, wanted.diffuse);
  viewport.fitAsked = wanted;
}

}  // namespace

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
    if (!provideMeasured(viewport, loader, request)) return false;
    provideFit(viewport, state.settings, loader, request);
  }
  const bool isShown = scene == viewport.scene.get() && environment == viewport.environments.shown;
  if ((isShown && request == viewport.built) || request == viewport.failed) return false;
  // While an animation plays, images that it has brought to light are waited for, not asked for anew each frame.
  const bool asked = viewport.asked && differsInTimeOnly(request, *viewport.asked);
  if (asked && (!environment || loader.images.running())) return false;

  const Result<scene::Pose> pose = frame::choosePose(state.settings, model);
  if (!pose) {
    complain(state, pose.error());
    state.settings.animation.clear();
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
  viewport.loadingMeasured = {};
  viewport.measuredAsked.reset();
  returnToShown(viewport, state, viewport.asked);
  viewport.asked.reset();
  say(state, "loading cancelled");
}

std::optional<scene::View> currentView(const Viewport& viewport, ViewerState& state) {
  if (!viewport.scene) return std::nullopt;
  const Result<scene::View> view = viewOf(state, viewport.scene->loaded->model, viewport.list);
  if (view) return *view;
  complain(state, view.error());
  state.settings.camera.clear();
  return viewOf(state, viewport.scene->loaded->model, viewport.list).value();
}

void reloadShaders(Viewport& viewport, ViewerState& state) {
  stopRefinement(viewport, state);
  glUseProgram(0);  // else the one in use lives on as a name that can no longer be used
  viewport.programs.reload();
  viewport.failed.reset();
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view) return;
  const Result<void> compiled =
      frame::preparePrograms({viewport.scene->loaded->model, viewport.list, viewport.scene->onGpu.gpu,
                              viewport.environments.shown->onGpu.tables, *view, state.settings},
                             viewport.programs);
  viewport.shadersBroken = !compiled;
  if (!compiled) return complain(state, compiled.error());
  viewport.drawn.reset();
  say(state, "shaders reloaded");
}

namespace {

// True where the shown tables are new.
bool sharpenShown(Viewport& viewport, ViewerState& state) {
  EnvironmentSlot* slot = viewport.environments.shown;
  if (!slot) return false;
  const Result<bool> sharper = sharpen(*slot);
  if (!sharper) {
    complain(state, sharper.error());
    slot->sharpening.reset();
    slot->toStore.clear();
    return false;
  }
  if (!slot->sharpening && !slot->preview) storeTables(viewport.environments);
  return *sharper;
}

}  // namespace

bool atWork(const Viewport& viewport, const ViewerState& state) {
  const EnvironmentSlot* slot = viewport.environments.shown;
  const bool tables = slot && (slot->sharpening || !slot->toStore.empty() || !slot->packed.empty());
  return tables || refining(viewport, state) || !viewport.comparison.empty();
}

namespace {

ComparisonShown comparisonOf(const frame::PictureSettings& settings) {
  return {settings.brdfCompare, settings.brdfSplit, settings.brdfDifferenceScale};
}

// Starts to find out how the pictures differ that are compared.
Result<void> compare(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                     bool last) {
  const auto now = std::chrono::steady_clock::now();
  if (!frame::comparing(in) || (!last && now - viewport.compared < std::chrono::milliseconds(500))) return {};
  viewport.compared = now;
  viewport.comparison.clear();
  Result<frame::ComparisonSums> sums = frame::sumComparison(in, targets, scale, viewport.programs);
  if (!sums) return tl::unexpected(sums.error());
  viewport.comparison.push_back(std::move(*sums));
  return {};
}

// Only how the two pictures are shown has changed.
bool showAnew(Viewport& viewport, ViewerState& state, const scene::View& view) {
  const Refinement& r = viewport.refinement;
  const bool gathered = r.shown && r.gathering;
  if (gathered && r.gathering->rows != 0) return false;  // in the middle of a draw: at its end
  const frame::FrameInput in{viewport.scene->loaded->model,
                             viewport.list,
                             viewport.scene->onGpu.gpu,
                             viewport.environments.shown->onGpu.tables,
                             view,
                             state.settings};
  viewport.comparisonShown = comparisonOf(state.settings);
  const Result<void> shown =
      frame::showPicture(in, gathered ? r.targets : viewport.targets, gathered ? frame::meanScale(*r.gathering) : 1,
                         viewport.targets, viewport.programs);
  if (!shown) complain(state, shown.error());
  return true;
}

}  // namespace

Result<void> showPicture(Viewport& viewport, const frame::FrameInput& in, const frame::Targets& targets, float scale,
                         bool last) {
  viewport.comparisonShown = comparisonOf(in.settings);
  if (Result<void> shown = frame::showPicture(in, targets, scale, viewport.targets, viewport.programs); !shown)
    return shown;
  return compare(viewport, in, targets, scale, last);
}

bool drawViewport(Viewport& viewport, ViewerState& state) {
  if (!viewport.comparison.empty()) {
    state.shown.comparison = frame::readComparison(viewport.comparison);
    viewport.comparison.clear();
  }
  if (sharpenShown(viewport, state)) ++viewport.listNumber;
  if (const std::optional<double> gpuMs = viewport.clock.poll()) state.shown.statistics.gpuMs = *gpuMs;
  const std::optional<scene::View> view = currentView(viewport, state);
  if (!view || viewport.shadersBroken) return false;
  DrawnFrame wanted{state.settings, state.camera, viewport.listNumber};
  wanted.settings.environment.clear();  // the list's number stands for what is loaded
  wanted.settings.scene = -1;
  wanted.settings.variant.clear();
  const ComparisonShown comparison = comparisonOf(state.settings);
  wanted.settings.material = {};
  wanted.settings.brdf.clear(), wanted.settings.brdfDir.clear();
  wanted.settings.utiaDecode = {}, wanted.settings.brdfLookUp = {}, wanted.settings.brdfCompare = {};
  wanted.settings.brdfSplit = wanted.settings.brdfDifferenceScale = 0;
  if (viewport.drawn == wanted) {
    const bool refined = refine(viewport, state, *view);
    if (refined || !viewport.list.compared || viewport.comparisonShown == comparison) return refined;
    return showAnew(viewport, state, *view);
  }
  stopRefinement(viewport, state);
  state.refinement.lightPreview = viewport.environments.shown->preview;
  const frame::PictureSettings s = movingSettings(state.settings);
  frame::Targets& targets = viewport.targets;
  if (targets.width != s.width || targets.height != s.height || targets.samples != s.samples) {
    targets = {};  // the old ones go first
    targets = frame::createTargets(s, viewport.context);
  }
  frame::prepareBehind(targets, viewport.list);
  frame::prepareComparison(targets, viewport.list);
  frame::setTextureDetail(viewport.scene->onGpu.gpu, 1, viewport.context);
  const scene::Model& model = viewport.scene->loaded->model;
  const frame::FrameInput input{
      model, viewport.list, viewport.scene->onGpu.gpu, viewport.environments.shown->onGpu.tables, *view, s};
  const auto start = std::chrono::steady_clock::now();
  FrameClock::Slot* slot = viewport.clock.begin();
  Result<frame::FrameStatistics> drawn = frame::drawFrame(input, targets, viewport.programs);
  viewport.clock.end(slot);
  const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
  viewport.drawn = wanted;
  viewport.comparisonShown = comparison;
  if (drawn)
    if (Result<void> compared = compare(viewport, input, targets, 1, true); !compared)
      complain(state, compared.error());
  if (!drawn) return complain(state, drawn.error()), true;
  state.shown.statistics.frame = std::move(*drawn);
  state.shown.statistics.cpuMs = spent.count();
  measureMemory(viewport, state.shown.statistics);
  log::debug("frame drawn: " + state.shown.model + ", " + state.shown.environment +
             (state.refinement.lightPreview ? " (preview)" : ""));
  return true;
}

}  // namespace facet::view
