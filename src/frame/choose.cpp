#include "frame/choose.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <initializer_list>
#include <set>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "base/whole_number.hpp"
#include "frame/settings.hpp"
#include "io/sources.hpp"
#include "scene/animation.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/edited.hpp"

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
  return fail(model.name, "", "the scene has no camera " + inQuotes(wanted),
              known.empty() ? "it has none at all: choose no camera of the file" : "it has " + known, Setting::camera);
}

const scene::BuiltinScene* builtinOf(const std::string& source) {
  return source.starts_with("builtin:") ? scene::findBuiltinScene(source) : nullptr;
}

bool wantsRays(const Quality& quality) {
  return quality.visibility == Visibility::automatic || quality.visibility == Visibility::rays;
}

bool isPart(const PictureSettings& settings) {
  const int channel = std::max(0, shading::channelIndex(settings.look.channel));
  return channel != 0 && shading::showsLight(channel);
}
bool isPart(const PictureSettings& settings, std::initializer_list<shading::Channel> parts) {
  const int channel = std::max(0, shading::channelIndex(settings.look.channel));
  return std::ranges::any_of(parts, [&](shading::Channel part) { return shading::isChannel(channel, part); });
}

// Of light in a picture that is drawn, once.
bool drawsLight(const PictureSettings& settings) {
  return settings.look.channel.empty() && settings.comparison.brdfCompare == BrdfCompare::none &&
         !tracesPaths(settings);
}

}  // namespace

bool tracesPaths(const PictureSettings& settings) {
  const Quality& quality = settings.quality;
  if (!settings.look.channel.empty()) return false;
  return quality.transport == Transport::paths ||
         (quality.visibility == Visibility::automatic && quality.samples > correctedUpTo) ||
         (wantsRays(quality) && quality.maxError);  // what rays smooth over no estimate sees
}

bool correctedByRays(const PictureSettings& settings) { return wantsRays(settings.quality) && drawsLight(settings); }

bool usesScreen(const PictureSettings& settings) {
  if (isPart(settings)) return settings.quality.visibility != Visibility::none;
  return settings.quality.visibility == Visibility::screen && drawsLight(settings);
}

VisibilityChosen chosenVisibility(const PictureSettings& settings, const DrawList& list) {
  const bool asked = settings.quality.transport == Transport::paths || settings.quality.visibility == Visibility::rays;
  if (list.features.paths) {
    std::string why = asked                       ? "asked for"
                      : settings.quality.maxError ? "an error is to be kept to"
                                                  : "more than " + std::to_string(correctedUpTo) + " samples";
    if (settings.quality.caustics == Caustics::soft) why += "; caustics are softened";
    return {"paths", std::move(why)};
  }
  if (list.features.difference) return {"rays", asked ? "asked for" : "few samples"};
  if (list.features.shadows || list.features.horizons)
    return {"screen", isPart(settings) ? "parts of the light are drawn" : "asked for"};
  if (!list.untraced.empty()) return {"none", list.untraced};
  if (!settings.look.channel.empty() && !isPart(settings)) return {"none", "a channel shows no light"};
  if (settings.comparison.brdfCompare != BrdfCompare::none && settings.quality.visibility != Visibility::none)
    return {"none", "a fitted model is compared"};
  return {"none", "asked for"};
}

bool converges(const PictureSettings& settings) {
  const Quality& quality = settings.quality;
  return quality.maxError.has_value() || quality.samples > convergedAbove || tracesPaths(settings);
}

PictureSettings movingSettings(const PictureSettings& settings) {
  PictureSettings moving = settings;
  if (moving.quality.transport == Transport::paths || moving.quality.visibility != Visibility::none)
    moving.quality.visibility = Visibility::screen;
  moving.quality.transport = Transport::direct;
  moving.quality.samples = std::min(settings.quality.samples, convergedAbove);
  moving.quality.maxError.reset();
  return moving;
}

TextureFilter chooseTextureFilter(TextureFilter wish, bool software) {
  if (wish != TextureFilter::automatic) return wish;
  return software ? TextureFilter::reads : TextureFilter::hardware;
}

PictureSettings restingSettings(const PictureSettings& settings) {
  PictureSettings resting = settings;
  if (correctedByRays(settings)) resting.quality.visibility = Visibility::screen;
  return resting;
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
  if (tracesPaths(settings)) options.tracing = Tracing::paths;
  if (correctedByRays(settings)) options.tracing = Tracing::difference;
  if (usesScreen(settings)) options.tracing = Tracing::screen;
  options.tracesAnyway =
      settings.quality.transport == Transport::paths || settings.quality.visibility == Visibility::rays;
  options.ground = settings.frame.ground && settings.look.channel.empty();
  options.sceneLights = settings.look.lights != Lights::none;
  options.demoLights = settings.look.lights == Lights::demo;
  // A part of the light is the picture without the other lights.
  using enum shading::Channel;
  options.features.sampledBehind = isPart(settings) && options.features.environment;
  if (isPart(settings) && !isPart(settings, {environmentDiffuse, environmentSpecular, interreflected}))
    options.features.environment = false;
  if (isPart(settings) && !isPart(settings, {lightsDiffuse, lightsSpecular}))
    options.sceneLights = options.demoLights = false;
  options.moving = !settings.placement.animation.empty();
  options.without = settings.look.without;
  if (settings.look.material.on) options.material = settings.look.material;
  return options;
}

glm::vec3 backgroundColor(const PictureSettings& settings) {
  const bool without = isPart(settings) && !isPart(settings, {shading::Channel::background});
  return without ? glm::vec3(0) : settings.frame.backgroundColor;
}

bool backgroundVisible(const PictureSettings& settings, bool hasEnvironment) {
  return settings.frame.background == Background::environment && hasEnvironment &&
         (settings.look.channel.empty() || isPart(settings, {shading::Channel::background}));
}

Result<int> chooseScene(const Placement& placement, const scene::Model& model) {
  const int scene = placement.scene < 0 ? model.defaultScene : placement.scene;
  if (scene >= static_cast<int>(model.scenes.size()) && placement.scene >= 0)
    return fail(model.name, "", "there is no scene " + std::to_string(scene),
                "the file has " + std::to_string(model.scenes.size()), Setting::scene);
  return scene;
}

Result<int> chooseVariant(const Look& look, const scene::Model& model) {
  if (look.variant.empty()) return -1;
  const int count = static_cast<int>(model.variants.size());
  std::string known;
  for (int i = 0; i < count; ++i) {
    const std::string& name = model.variants[static_cast<size_t>(i)];
    if (name == look.variant) return i;
    known += (i == 0 ? "" : ", ") + std::to_string(i) + (name.empty() ? "" : " (" + name + ")");
  }
  if (const std::optional<int> index = wholeNumber(look.variant); index && *index >= 0 && *index < count) return *index;
  return fail(model.name, "", "the file has no material variant " + inQuotes(look.variant),
              known.empty() ? "it has none at all: choose none" : "it has " + known, Setting::variant);
}

Result<std::vector<int>> chooseNodes(const std::vector<std::string>& wanted, const scene::Model& model) {
  std::vector<int> nodes;
  for (const std::string& name : wanted) {
    const size_t before = nodes.size();
    for (size_t i = 0; i < model.nodes.size(); ++i)
      if (model.nodes[i].name == name) nodes.push_back(static_cast<int>(i));
    const std::optional<int> index = wholeNumber(name);
    if (nodes.size() == before && index && *index >= 0 && static_cast<size_t>(*index) < model.nodes.size())
      nodes.push_back(*index);
    if (nodes.size() > before) continue;
    std::vector<std::string_view> known;
    for (const scene::Node& node : model.nodes)
      if (!node.name.empty() && known.size() < 20) known.push_back(node.name);
    return fail(model.name, "", "there is no node " + inQuotes(name),
                known.empty() ? "give an index below " + std::to_string(model.nodes.size()) : suggestion(name, known),
                Setting::only);
  }
  return nodes;
}

namespace {

// The model at a time, changed as it is wished.
Result<scene::Pose> poseOf(const Arrangement& arrangement, const scene::Model& model,
                           const std::vector<int>& animations, double time) {
  scene::Pose pose = scene::poseAt(model, animations, time);
  if (Result<void> r = scene::applyEdits(pose, model, arrangement.edits); !r) return tl::unexpected(r.error());
  Result<std::vector<int>> only = chooseNodes(arrangement.only, model);
  if (!only) return tl::unexpected(only.error());
  pose.only = std::move(*only);
  const glm::dmat4 world = worldFromModel(arrangement);
  if (world != glm::dmat4(1)) pose.worldFromModel = world;
  return pose;
}

}  // namespace

glm::dmat4 worldFromModel(const Arrangement& of) {
  // Columns: where the model's axes point.
  constexpr glm::dmat3 up[] = {
      {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  glm::dmat4 world = glm::translate(glm::dmat4(1), of.position);
  for (const int axis : {2, 1, 0}) {
    glm::dvec3 about(0);
    about[axis] = 1;
    if (of.rotationDeg[axis] != 0) world = glm::rotate(world, glm::radians(of.rotationDeg[axis]), about);
  }
  return glm::scale(world * glm::dmat4(up[static_cast<size_t>(of.up)]), glm::dvec3(of.scale));
}

Result<scene::Pose> choosePose(const Placement& placement, const scene::Model& model) {
  const Result<std::vector<int>> animations = scene::chooseAnimations(model, placement.animation);
  if (!animations) return tl::unexpected(animations.error());
  return poseOf(placement.arrangement, model, *animations, placement.timeSeconds);
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

scene::Bounds framingBounds(const Placement& placement, const scene::Model& model, int scene,
                            const scene::Bounds& poseBounds) {
  const Result<std::vector<int>> animations = scene::chooseAnimations(model, placement.animation);
  if (!animations || animations->empty()) return poseBounds;
  // Large scenes take few moments, because each is a walk through all that they draw.
  size_t work = 1 + model.nodes.size();
  for (const scene::Node& node : model.nodes) work += node.instances.size();
  scene::Bounds all;
  for (const double time : framedMoments(model, *animations, std::clamp<size_t>(1'000'000 / work, 4, 48))) {
    const Result<scene::Pose> pose = poseOf(placement.arrangement, model, *animations, time);
    if (!pose) return poseBounds;
    const scene::Bounds bounds = scene::sceneBounds(model, scene, *pose);
    if (!bounds.empty()) all.add(bounds.min), all.add(bounds.max);
  }
  return all;
}

scene::OrbitCamera chooseOrbit(const Viewpoint& viewpoint, double aspect, const std::string& source,
                               const scene::Bounds& bounds) {
  const scene::BuiltinScene* builtin = builtinOf(source);
  scene::OrbitCamera like;
  like.fovY = viewpoint.fovYDeg.value_or(45.0);
  like.orthographic = viewpoint.projection == Projection::orthographic;
  like.up = viewpoint.up, like.roll = viewpoint.rollDeg;
  scene::OrbitCamera camera = scene::frameBounds(bounds, aspect, like);
  if (builtin && !viewpoint.fovYDeg) {
    camera = builtin->camera;
    camera.radius /= std::min(aspect, 1.0);  // it is made for square and wider pictures
    camera.orthographic = like.orthographic, camera.up = like.up, camera.roll = like.roll;
  }
  if (viewpoint.target) camera.target = *viewpoint.target;
  if (viewpoint.orbit) {
    camera.theta = viewpoint.orbit->thetaDeg;
    camera.phi = viewpoint.orbit->phiDeg;
    if (viewpoint.orbit->radius) camera.radius = *viewpoint.orbit->radius;
  }
  if (viewpoint.viewHeight) camera.radius = scene::radiusForHeight(*viewpoint.viewHeight, camera.fovY);
  return camera;
}

Result<scene::View> chooseView(const Viewpoint& viewpoint, double aspect, const std::string& source,
                               const scene::Model& model, const DrawList& list, const scene::Bounds& framing) {
  if (viewpoint.camera.empty())
    return scene::orbitView(chooseOrbit(viewpoint, aspect, source, framing), aspect, list.bounds);
  Result<FileCamera> camera = findCamera(viewpoint.camera, model, list);
  if (!camera) return tl::unexpected(camera.error());
  if (viewpoint.fovYDeg) camera->lens.fovY = glm::radians(*viewpoint.fovYDeg), camera->lens.aspectRatio = 0;
  return scene::cameraView(camera->lens, camera->placed.worldFromNode, aspect, list.bounds);
}

std::string chooseEnvironment(const PictureSettings& settings, const std::string& source, const scene::Model& model,
                              int scene) {
  if (!settings.sources.environment.empty())
    return io::withLayer(settings.sources.environment, settings.sources.environmentLayer);
  if (const scene::BuiltinScene* builtin = builtinOf(source)) return std::string(builtin->environment);
  const DrawOptions options = drawOptions(settings, true);
  // Of a part of the light, too, which shows it or not, but what is behind glass as the whole picture does.
  const bool shaded =
      shading::showsLight(options.features.channel) && (options.features.environment || options.features.sampledBehind);
  if (!shaded || !scene::anythingLit(model, scene)) return "none";
  const int own = model.scenes[static_cast<size_t>(scene)].imageLight;  // of the file
  return own < 0 || source.starts_with(io::builtinPrefix) ? "builtin:studio"
                                                          : io::withLayer(source, std::to_string(own));
}

}  // namespace facet::frame
