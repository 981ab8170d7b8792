#include "frame/picture.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>

#include "scene/builtin_scenes.hpp"

namespace facet::frame {

namespace {

std::optional<int> parseIndex(const std::string& text) {
  int value = 0;
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// The file's camera by name, else by index.
Result<scene::PlacedCamera> findCamera(const std::string& wanted, const scene::Model& model, const DrawList& list) {
  std::string known;
  for (const scene::PlacedCamera& placed : list.cameras) {
    const scene::Camera& camera = model.cameras[static_cast<size_t>(placed.camera)];
    if (camera.name == wanted || model.nodes[static_cast<size_t>(placed.node)].name == wanted) return placed;
    known += (known.empty() ? "" : ", ") + std::to_string(placed.camera) +
             (camera.name.empty() ? "" : " (" + camera.name + ")");
  }
  if (const std::optional<int> index = parseIndex(wanted))
    for (const scene::PlacedCamera& placed : list.cameras)
      if (placed.camera == *index) return placed;
  return fail(model.name, "", "the scene has no camera '" + wanted + "'",
              known.empty() ? "it has none at all: leave out --camera" : "it has " + known);
}

const scene::BuiltinScene* builtinOf(const std::string& source) {
  return source.starts_with("builtin:") ? scene::findBuiltinScene(source) : nullptr;
}

void countExtremes(const io::RadianceImage& image, PictureStatistics& statistics) {
  for (const glm::vec4& p : image.pixels) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z) || !std::isfinite(p.w))
      ++statistics.nonFinitePixels;
    else if (std::max({p.x, p.y, p.z}) >= 65504.0f)
      ++statistics.clampedPixels;
  }
}

void noteUnlit(const PictureSettings& settings, const DrawList& list, const ibl::Needs& needs, Notes& notes) {
  if (list.opaque.empty() && list.blended.empty()) {
    notes.push_back({Note::Severity::warning, "", "the scene draws nothing"});
    return;
  }
  const auto lit = [](const Draw& draw) { return !shading::usesFeature(draw.key, "UNLIT"); };
  const bool anyLit = std::ranges::any_of(list.opaque, lit) || std::ranges::any_of(list.blended, lit);
  if (anyLit && !needs.dfg && settings.channel.empty())
    notes.push_back({Note::Severity::warning, "",
                     "nothing lights the scene: it has no lights and --env is none; give --env or --lights demo"});
}

}  // namespace

DrawOptions drawOptions(const PictureSettings& settings, bool hasEnvironment) {
  DrawOptions options;
  options.features.environment = hasEnvironment && settings.environmentStrength > 0;
  options.features.occlusion = settings.occlusion > 0;
  options.features.channel = std::max(0, shading::channelIndex(settings.channel));
  if (settings.samples > convergedAbove) options.features.imageLightSamples = convergedLightSamples;
  options.sceneLights = settings.lights != Lights::none;
  options.demoLights = settings.lights == Lights::demo;
  return options;
}

Result<int> chooseScene(const PictureSettings& settings, const scene::Model& model) {
  const int scene = settings.scene < 0 ? model.defaultScene : settings.scene;
  if (scene >= static_cast<int>(model.scenes.size()) && settings.scene >= 0)
    return fail(model.name, "", "there is no scene " + std::to_string(scene),
                "the file has " + std::to_string(model.scenes.size()));
  return scene;
}

scene::OrbitCamera chooseOrbit(const frame::PictureSettings& settings, const std::string& source,
                               const scene::Bounds& bounds) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  const scene::BuiltinScene* builtin = builtinOf(source);
  scene::OrbitCamera camera = scene::frameBounds(bounds, settings.fovYDeg.value_or(45.0), aspect);
  if (builtin && !settings.fovYDeg) {
    camera = builtin->camera;
    camera.radius /= std::min(aspect, 1.0);  // it is made for square and wider pictures
  }
  if (settings.target) camera.target = *settings.target;
  if (settings.orbit) {
    camera.theta = settings.orbit->thetaDeg;
    camera.phi = settings.orbit->phiDeg;
    if (settings.orbit->radius) camera.radius = *settings.orbit->radius;
  }
  return camera;
}

Result<scene::View> chooseView(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                               const DrawList& list) {
  const double aspect = static_cast<double>(settings.width) / settings.height;
  if (settings.camera.empty()) return scene::orbitView(chooseOrbit(settings, source, list.bounds), aspect, list.bounds);
  const Result<scene::PlacedCamera> placed = findCamera(settings.camera, model, list);
  if (!placed) return tl::unexpected(placed.error());
  scene::Camera camera = model.cameras[static_cast<size_t>(placed->camera)];
  if (settings.fovYDeg) camera.fovY = glm::radians(*settings.fovYDeg), camera.aspectRatio = 0;
  return scene::cameraView(camera, placed->worldFromNode, aspect, list.bounds);
}

std::string chooseEnvironment(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                              int scene) {
  if (!settings.environment.empty()) return settings.environment;
  if (const scene::BuiltinScene* builtin = builtinOf(source)) return std::string(builtin->environment);
  // Lit at all? Asked of the draw list, which knows.
  const DrawList list = buildDrawList(model, scene, drawOptions(settings, true));
  return list.needs(false).irradiance ? "builtin:studio" : "none";
}

Targets createTargets(const PictureSettings& settings, const gl::ContextInfo& context) {
  const bool gather = settings.samples > convergedAbove;
  return createTargets(settings.width, settings.height, gather ? 1 : std::min(settings.samples, context.maxSamples),
                       gather);
}

Result<Picture> renderPicture(const PictureSettings& settings, const PictureRequest& request, SceneOnGpu& scene,
                              EnvironmentOnGpu& environment, shading::ProgramStore& programs,
                              const gl::ContextInfo& context, Notes& notes, Stages& stages) {
  const scene::Model& model = *scene.model;
  Picture picture;
  PictureStatistics& statistics = picture.statistics;
  const Result<int> sceneIndex = chooseScene(settings, model);
  if (!sceneIndex) return tl::unexpected(sceneIndex.error());
  const DrawList list = buildDrawList(model, *sceneIndex, drawOptions(settings, environment.environment != nullptr));
  const Result<scene::View> view = chooseView(settings, scene.source, model, list);
  if (!view) return tl::unexpected(view.error());
  const bool skyVisible = settings.background == Background::environment && environment.environment != nullptr &&
                          list.features.channel == 0;
  const ibl::Needs needs = list.needs(skyVisible);
  noteUnlit(settings, list, needs, notes);
  stages.mark("prepare");

  const int decodedBefore = scene.gpu.imagesDecoded;
  std::vector<io::Pixels> pixels = io::decodeImages(model, missingImages(model, list, scene.gpu), notes);
  stages.mark("decode");
  upload(scene.gpu, model, list, std::move(pixels));
  statistics.imagesDecoded = scene.gpu.imagesDecoded - decodedBefore;
  stages.mark("upload");

  const shading::ProgramStatistics before = programs.statistics();
  if (Result<void> r = ibl::computeTables(environment.tables, environment.environment, needs, programs); !r)
    return tl::unexpected(r.error());
  statistics.tables = environment.tables.statistics;
  stages.mark("precompute");

  const FrameInput input{model, list, scene.gpu, environment.tables, *view, settings};
  if (Result<void> r = preparePrograms(input, programs); !r) return tl::unexpected(r.error());
  statistics.programsCompiled = programs.statistics().compiled - before.compiled;
  statistics.programsFromDisk = programs.statistics().fromDisk - before.fromDisk;
  stages.mark("compile");

  const Targets targets = createTargets(settings, context);
  setTextureDetail(scene.gpu, gatheredDraws(settings, targets), context);
  for (int i = 0; i <= request.repeat; ++i) {
    const auto start = std::chrono::steady_clock::now();
    Result<FrameStatistics> drawn = drawFrame(input, targets, programs);
    if (!drawn) return tl::unexpected(drawn.error());
    glFinish();
    statistics.frameMs.push_back(
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    statistics.frame = std::move(*drawn);
    stages.mark(i == 0 ? "first frame" : "repeated frames");
  }
  statistics.textureBytes = scene.gpu.textureBytes();
  statistics.geometryBytes = scene.gpu.geometryBytes();
  for (const gl::Texture* t :
       {&environment.tables.dfg, &environment.tables.irradiance, &environment.tables.mirrorLayers,
        &environment.tables.roughLayers, &environment.tables.background, &environment.tables.cube})
    if (*t) statistics.tableBytes += t->bytes();

  if (request.radiance) {
    picture.radiance = readRadiance(targets);
    countExtremes(picture.radiance, statistics);
  }
  if (request.display) picture.display = readDisplay(targets, settings.background == Background::transparent);
  stages.mark("read back");
  return picture;
}

}  // namespace facet::frame
