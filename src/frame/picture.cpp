#include "frame/picture.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <set>
#include <thread>

#include "base/whole_number.hpp"
#include "frame/fitted_gpu.hpp"
#include "frame/material_choice.hpp"
#include "ibl/choice.hpp"
#include "scene/animation.hpp"
#include "scene/builtin_scenes.hpp"

namespace facet::frame {

namespace {

// The file's camera by name, else by index.
Result<FileCamera> findCamera(const std::string& wanted, const scene::Model& model, const DrawList& list) {
  std::string known;
  for (const FileCamera& camera : list.cameras) {
    const std::string& name = camera.lens.name;
    if (name == wanted || model.nodes[static_cast<size_t>(camera.placed.node)].name == wanted) return camera;
    known +=
        (known.empty() ? "" : ", ") + std::to_string(camera.placed.camera) + (name.empty() ? "" : " (" + name + ")");
  }
  if (const std::optional<int> index = wholeNumber(wanted))
    for (const FileCamera& camera : list.cameras)
      if (camera.placed.camera == *index) return camera;
  return fail(model.name, "", "the scene has no camera '" + wanted + "'",
              known.empty() ? "it has none at all: leave out --camera" : "it has " + known);
}

const scene::BuiltinScene* builtinOf(const std::string& source) {
  return source.starts_with("builtin:") ? scene::findBuiltinScene(source) : nullptr;
}

void noteUnlit(const PictureSettings& settings, const DrawList& list, const ibl::Needs& needs, Notes& notes) {
  if (std::ranges::all_of(list.classes(), [](const auto* draws) { return draws->empty(); })) {
    notes.push_back({Note::Severity::warning, "", "the scene draws nothing"});
    return;
  }
  const auto lit = [](const Draw& draw) { return !shading::usesFeature(draw.key, "UNLIT"); };
  const bool anyLit =
      std::ranges::any_of(list.classes(), [&](const auto* draws) { return std::ranges::any_of(*draws, lit); });
  if (anyLit && !needs.irradiance && !needs.cube && list.lights.empty() && settings.look.channel.empty())
    notes.push_back({Note::Severity::warning, "",
                     "nothing lights the scene: it has no lights and --env is none; give --env or --lights demo"});
}

// What the chosen models do not reach.
void noteModels(const DrawList& list, Notes& notes) {
  const auto any = [&](auto test) {
    return std::ranges::any_of(list.classes(), [&](const auto* draws) { return std::ranges::any_of(*draws, test); });
  };
  const auto warn = [&](const char* text) { notes.push_back({Note::Severity::warning, "", text}); };
  const optics::Models& models = list.features.models;
  if (models.distribution != optics::NormalDistribution::ggx || models.masking != optics::Masking::smith) {
    if (!any([](const Draw& d) { return d.key.distribution != 0 || d.key.masking != 0; }))
      warn("--ndf and --masking change nothing: they are for point, spot and directional lights, and none shines");
    else if (list.features.environment)
      warn("--ndf and --masking are for point, spot and directional lights: GGX reflects the environment");
  }
  if (models.fresnel == optics::FresnelModel::schlick) return;
  const bool sampled = list.features.imageLightSamples != 0;
  if (!any([](const Draw& d) { return d.key.fresnel != 0; }))
    warn(
        "--fresnel changes nothing: exact is for dielectrics and for metals whose index is known, f82 for the latter, "
        "under point, spot and directional lights, or with more than 4 samples");
  else if (list.features.environment && !sampled)
    warn(
        "--fresnel is for point, spot and directional lights: the environment's tables are Schlick's; more than 4 "
        "samples do without them");
}

// The measured BRDF onto the GPU and into the options, or out of both.
Result<void> chooseMeasured(const PictureSettings& settings, SceneOnGpu& scene, DrawOptions& options, Notes& notes) {
  scene.gpu.measured.reset(), scene.gpu.fitted.reset();
  if (settings.sources.brdf.empty() || options.features.channel != 0) return {};
  if (!scene.measured) scene.measured = std::make_shared<MeasuredStore>();
  auto found = findMeasured(*scene.measured, measuredSource(settings), notes);
  if (!found) return tl::unexpected(found.error());
  scene.gpu.measured = *found;
  setMeasured(options.features, settings, (*found)->facts.kind, (*found)->facts.proxy);
  if (settings.display.brdfCompare == BrdfCompare::none) return {};
  auto fitted = findFit(*scene.measured, measuredSource(settings), settings.look.models.diffuse);
  if (!fitted) return tl::unexpected(fitted.error());
  scene.gpu.fitted = *fitted;
  setFitted(options, settings);
  return {};
}

}  // namespace

void noteMeasured(const DrawList& list, Notes& notes) {
  size_t unlit = 0, levelled = 0;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) {
      if (!shading::isMeasured(draw.key)) ++unlit;
      if (shading::usesFeature(draw.key, "UTIA_BRDF") && draw.primitive->tangents.empty()) ++levelled;
    }
  const auto warn = [&](const std::string& text) { notes.push_back({Note::Severity::warning, "", text}); };
  if (list.features.channel == 0 && unlit > 0)
    warn("--brdf: " + std::to_string(unlit) + " draws keep their own look, because they are unlit or have no normals");
  if (levelled > 0)
    warn("--brdf: " + std::to_string(levelled) +
         " draws have no tangents: the BRDF's azimuths begin at their level direction");
}

DrawOptions drawOptions(const PictureSettings& settings, bool hasEnvironment) {
  DrawOptions options;
  options.features.environment = hasEnvironment && settings.frame.environmentStrength > 0;
  options.features.occlusion = settings.frame.occlusion > 0;
  options.features.channel = std::max(0, shading::channelIndex(settings.look.channel));
  const bool converging = converges(settings);
  options.features.shadedOnce = !converging;
  if (settings.look.models.imageLight == optics::ImageLight::sampled)
    options.features.imageLightSamples = converging ? convergedLightSamples : onceLightSamples;
  else if (settings.look.models.imageLight == optics::ImageLight::automatic && converging)
    options.features.imageLightSamples = convergedLightSamples;
  options.features.models = settings.look.models;
  options.sceneLights = settings.look.lights != Lights::none;
  options.demoLights = settings.look.lights == Lights::demo;
  options.moving = !settings.placement.animation.empty();
  if (settings.look.material.on) options.material = overridingMaterial(settings.look.material);
  return options;
}

Result<int> chooseScene(const PictureSettings& settings, const scene::Model& model) {
  const int scene = settings.placement.scene < 0 ? model.defaultScene : settings.placement.scene;
  if (scene >= static_cast<int>(model.scenes.size()) && settings.placement.scene >= 0)
    return fail(model.name, "", "there is no scene " + std::to_string(scene),
                "the file has " + std::to_string(model.scenes.size()));
  return scene;
}

Result<int> chooseVariant(const PictureSettings& settings, const scene::Model& model) {
  if (settings.look.variant.empty()) return -1;
  const int count = static_cast<int>(model.variants.size());
  std::string known;
  for (int i = 0; i < count; ++i) {
    const std::string& name = model.variants[static_cast<size_t>(i)];
    if (name == settings.look.variant) return i;
    known += (i == 0 ? "" : ", ") + std::to_string(i) + (name.empty() ? "" : " (" + name + ")");
  }
  if (const std::optional<int> index = wholeNumber(settings.look.variant); index && *index >= 0 && *index < count)
    return *index;
  return fail(model.name, "", "the file has no material variant '" + settings.look.variant + "'",
              known.empty() ? "it has none at all: leave out --variant" : "it has " + known);
}

Result<scene::Pose> choosePose(const PictureSettings& settings, const scene::Model& model) {
  const Result<std::vector<int>> animations = scene::chooseAnimations(model, settings.placement.animation);
  if (!animations) return tl::unexpected(animations.error());
  return scene::poseAt(model, *animations, settings.placement.timeSeconds);
}

namespace {

// Evenly spread over the course, and as many of the keys: what moves far for a moment has one there.
std::vector<double> framedMoments(const scene::Model& model, const std::vector<int>& animations, size_t count) {
  std::set<double> keys;
  for (const int animation : animations)
    for (const scene::AnimationSampler& sampler : model.animations[static_cast<size_t>(animation)].samplers)
      keys.insert(sampler.times.begin(), sampler.times.end());
  if (keys.empty()) return {0};
  std::vector<double> moments;
  for (size_t i = 0; i < count; ++i)
    moments.push_back(*keys.rbegin() * static_cast<double>(i) / static_cast<double>(count - 1));
  const size_t step = (keys.size() + count - 1) / count;
  size_t index = 0;
  for (const double key : keys)
    if (index++ % step == 0) moments.push_back(key);
  return moments;
}

}  // namespace

scene::Bounds framingBounds(const PictureSettings& settings, const scene::Model& model, int scene,
                            const scene::Bounds& poseBounds) {
  const Result<std::vector<int>> animations = scene::chooseAnimations(model, settings.placement.animation);
  if (!animations || animations->empty()) return poseBounds;
  // Large scenes take few moments, because each is a walk through all that they draw.
  size_t work = 1 + model.nodes.size();
  for (const scene::Node& node : model.nodes) work += node.instances.size();
  scene::Bounds all;
  for (const double time : framedMoments(model, *animations, std::clamp<size_t>(1'000'000 / work, 4, 48))) {
    const scene::Bounds bounds = scene::sceneBounds(model, scene, scene::poseAt(model, *animations, time));
    if (!bounds.empty()) all.add(bounds.min), all.add(bounds.max);
  }
  return all;
}

scene::OrbitCamera chooseOrbit(const frame::PictureSettings& settings, const std::string& source,
                               const scene::Bounds& bounds) {
  const double aspect = static_cast<double>(settings.frame.width) / settings.frame.height;
  const scene::BuiltinScene* builtin = builtinOf(source);
  scene::OrbitCamera camera = scene::frameBounds(bounds, settings.viewpoint.fovYDeg.value_or(45.0), aspect);
  if (builtin && !settings.viewpoint.fovYDeg) {
    camera = builtin->camera;
    camera.radius /= std::min(aspect, 1.0);  // it is made for square and wider pictures
  }
  if (settings.viewpoint.target) camera.target = *settings.viewpoint.target;
  if (settings.viewpoint.orbit) {
    camera.theta = settings.viewpoint.orbit->thetaDeg;
    camera.phi = settings.viewpoint.orbit->phiDeg;
    if (settings.viewpoint.orbit->radius) camera.radius = *settings.viewpoint.orbit->radius;
  }
  return camera;
}

Result<scene::View> chooseView(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                               const DrawList& list, const scene::Bounds& framing) {
  const double aspect = static_cast<double>(settings.frame.width) / settings.frame.height;
  if (settings.viewpoint.camera.empty())
    return scene::orbitView(chooseOrbit(settings, source, framing), aspect, list.bounds);
  Result<FileCamera> camera = findCamera(settings.viewpoint.camera, model, list);
  if (!camera) return tl::unexpected(camera.error());
  if (settings.viewpoint.fovYDeg)
    camera->lens.fovY = glm::radians(*settings.viewpoint.fovYDeg), camera->lens.aspectRatio = 0;
  return scene::cameraView(camera->lens, camera->placed.worldFromNode, aspect, list.bounds);
}

std::string chooseEnvironment(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                              int scene) {
  if (!settings.sources.environment.empty()) return settings.sources.environment;
  if (const scene::BuiltinScene* builtin = builtinOf(source)) return std::string(builtin->environment);
  const bool shaded = drawOptions(settings, true).features.channel == 0 && settings.frame.environmentStrength > 0;
  return shaded && scene::anythingLit(model, scene) ? "builtin:studio" : "none";
}

void findSun(EnvironmentOnGpu& environment) {
  environment.sun.reset();
  if (environment.prepared)
    environment.sun = environment.prepared->sun;
  else if (environment.environment)
    if (auto found = scene::findSun(*environment.environment)) environment.sun = found->sun;
  environment.method.takeSunOut = environment.sun.has_value();
}

bool chooseMethod(EnvironmentOnGpu& environment, const PictureSettings& settings) {
  ibl::Method method = settings.quality.maxError ? ibl::methodFor(*settings.quality.maxError) : ibl::Method();
  method.takeSunOut = environment.method.takeSunOut;
  if (method == environment.method) return false;
  environment.method = method;
  environment.tables = {};
  return true;
}

Result<void> prepareTables(EnvironmentOnGpu& environment, const ibl::Needs& needs, shading::ProgramStore& programs) {
  return ibl::prepareTables(environment.tables, environment.environment, environment.content, needs, programs,
                            environment.cache, environment.method, environment.prepared.get());
}

namespace {

// A few images at a time, so that never more of them than the machine decodes at once are in memory twice.
void decodeAndUpload(GpuScene& gpu, const scene::Model& model, const DrawList& list, Notes& notes, Stages& stages) {
  const size_t atOnce = std::max(2u, std::thread::hardware_concurrency());
  uploadScene(gpu, model, list);
  const std::vector<TextureUse> uses = textureUses(model, list);
  const std::vector<bool> missing = missingImages(model, list, gpu);
  stages.mark("upload");
  size_t image = 0;
  while (image < missing.size()) {
    std::vector<bool> some(missing.size(), false);
    for (size_t count = 0; image < missing.size() && count < atOnce; ++image)
      if (missing[image]) some[image] = true, ++count;
    std::vector<io::Pixels> pixels = io::decodeImages(model, some, notes);
    stages.mark("decode");
    uploadImages(gpu, model, uses, pixels);
    stages.mark("upload");
  }
}

// Once for all frames of an animation.
scene::Bounds framingOf(SceneOnGpu& scene, const PictureSettings& settings, int index,
                        const scene::Bounds& poseBounds) {
  const bool viewGiven = !settings.viewpoint.camera.empty() ||
                         (settings.viewpoint.target && settings.viewpoint.orbit && settings.viewpoint.orbit->radius);
  if (settings.placement.animation.empty() || viewGiven) return poseBounds;
  std::optional<Framing>& known = scene.framing;
  if (!known || known->scene != index || known->animation != settings.placement.animation)
    known = Framing{index, settings.placement.animation, framingBounds(settings, *scene.model, index, poseBounds)};
  return known->bounds;
}

}  // namespace

Result<PreparedPicture> preparePicture(const PictureSettings& settings, SceneOnGpu& scene,
                                       EnvironmentOnGpu& environment, shading::ProgramStore& programs, Notes& notes,
                                       Stages& stages) {
  const scene::Model& model = *scene.model;
  const Result<int> sceneIndex = chooseScene(settings, model);
  if (!sceneIndex) return tl::unexpected(sceneIndex.error());
  const Result<int> variant = chooseVariant(settings, model);
  if (!variant) return tl::unexpected(variant.error());
  PreparedPicture prepared;
  const bool lit = environment.environment != nullptr;
  const Result<scene::Pose> pose = choosePose(settings, model);
  if (!pose) return tl::unexpected(pose.error());
  DrawOptions options = drawOptions(settings, lit);
  options.variant = *variant;
  options.sun = environment.sun;
  if (Result<void> r = chooseMeasured(settings, scene, options, notes); !r) return tl::unexpected(r.error());
  stages.mark("read BRDF");
  prepared.list = buildDrawList(model, *sceneIndex, options, *pose);
  const DrawList& list = prepared.list;
  const Result<scene::View> view =
      chooseView(settings, scene.source, model, list, framingOf(scene, settings, *sceneIndex, list.bounds));
  if (!view) return tl::unexpected(view.error());
  prepared.view = *view;
  const bool skyVisible = settings.frame.background == Background::environment && lit && list.features.channel == 0;
  const ibl::Needs needs = list.needs(skyVisible);
  noteUnlit(settings, list, needs, notes);
  if (!settings.sources.brdf.empty())
    noteMeasured(list, notes);
  else
    noteModels(list, notes);
  stages.mark("prepare");

  const shading::ProgramStatistics before = programs.statistics();
  PictureStatistics& statistics = prepared.statistics;
  chooseMethod(environment, settings);
  if (Result<void> r = prepareTables(environment, needs, programs); !r) return tl::unexpected(r.error());
  statistics.tables = environment.tables.statistics;
  stages.mark("precompute");

  const int decodedBefore = scene.gpu.imagesDecoded;
  decodeAndUpload(scene.gpu, model, list, notes, stages);
  statistics.imagesDecoded = scene.gpu.imagesDecoded - decodedBefore;

  const FrameInput input{model, list, scene.gpu, environment.tables, prepared.view, settings};
  if (Result<void> r = preparePrograms(input, programs); !r) return tl::unexpected(r.error());
  statistics.programsCompiled = programs.statistics().compiled - before.compiled;
  statistics.programsFromDisk = programs.statistics().fromDisk - before.fromDisk;
  stages.mark("compile");
  return prepared;
}

}  // namespace facet::frame
