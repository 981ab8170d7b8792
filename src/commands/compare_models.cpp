#include "commands/compare_models.hpp"

#include <algorithm>
#include <array>

#include "base/file_ending.hpp"
#include "base/log.hpp"
#include "commands/confine.hpp"
#include "frame/choose.hpp"
#include "frame/session.hpp"
#include "io/sources.hpp"
#include "options/picture_options.hpp"
#include "scene/changes.hpp"
#include "scene/nodes.hpp"

namespace facet::commands {

namespace {

Result<io::LoadedModel> loadForFraming(const std::string& source, const frame::PictureSettings& settings) {
  return io::loadModel(source, {.allowOutside = settings.sources.allowOutside},
                       {settings.sources.bump, settings.sources.bumpScale});
}

Result<scene::Bounds> framingOf(const scene::Model& model, const frame::PictureSettings& settings) {
  const Result<int> scene = frame::chooseScene(settings.placement, model);
  if (!scene) return tl::unexpected(scene.error());
  const Result<scene::Pose> pose = frame::choosePose(settings.placement, model);
  if (!pose) return tl::unexpected(pose.error());
  return frame::framingBounds(settings.placement, model, *scene, scene::sceneBounds(model, *scene, *pose));
}

// The orbit as it is said, whichever model is drawn.
void settleView(frame::PictureSettings& settings, const std::string& source, const scene::Bounds& bounds) {
  frame::Viewpoint& viewpoint = settings.viewpoint;
  if (!viewpoint.camera.empty()) return;
  const scene::OrbitCamera camera = frame::chooseOrbit(viewpoint, frame::aspectOf(settings.frame), source, bounds);
  viewpoint.orbit = frame::Orbit{camera.theta, camera.phi, camera.radius};
  viewpoint.target = camera.target, viewpoint.fovYDeg = camera.fovY;
  viewpoint.viewHeight.reset();
}

Result<io::Pixels> drawOne(const std::string& source, const frame::PictureSettings& settings, bool last,
                           frame::Session& session) {
  Notes notes;
  Stages stages;
  Result<frame::Picture> picture = session.render(source, settings, {.display = true, .last = last}, notes, stages);
  if (!picture) return tl::unexpected(picture.error());
  for (const Note& note : notes)
    if (note.severity == Note::Severity::warning) log::warning(options::describe(source, note));
  return std::move(picture->display);
}

}  // namespace

bool isModelSource(const std::string& source) {
  if (source.starts_with(io::builtinPrefix)) return true;
  const std::string ending = fileEnding(std::filesystem::path(source));
  return ending == ".glb" || ending == ".gltf";
}

std::vector<std::string_view> comparedOptions() {
  constexpr std::array<std::string_view, 2> others = {"max-error", "shader-dir"};
  std::vector<std::string_view> names = options::optionNames();
  std::erase_if(names, [&](std::string_view name) { return std::ranges::find(others, name) != others.end(); });
  return names;
}

Result<DrawnModels> drawModels(ModelPair pair, bool& noOpenGL) {
  frame::PictureSettings& settings = pair.settings;
  if (pair.sandbox) keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session = frame::Session::create({});
  noOpenGL = !session;
  if (!session) return tl::unexpected(session.error());
  for (const std::string& source : {pair.first, pair.second}) needPicture(pair.needed, source, settings);
  if (pair.sandbox) confine(std::move(pair.needed), true);
  DrawnModels drawn;
  {
    const Result<io::LoadedModel> first = loadForFraming(pair.first, settings);
    if (!first) return tl::unexpected(first.error());
    const Result<io::LoadedModel> second = loadForFraming(pair.second, settings);
    if (!second) return tl::unexpected(second.error());
    drawn.changes = scene::changesBetween(first->model, second->model);
    Result<scene::Bounds> bounds = framingOf(first->model, settings);
    const Result<scene::Bounds> others = framingOf(second->model, settings);
    if (!bounds || !others) return tl::unexpected(bounds ? others.error() : bounds.error());
    if (!others->empty()) bounds->add(others->min), bounds->add(others->max);
    settleView(settings, pair.first, *bounds);
  }
  Result<io::Pixels> first = drawOne(pair.first, settings, false, **session);
  if (!first) return tl::unexpected(first.error());
  settings.sources.environment = (*session)->environmentName(), settings.sources.environmentLayer.clear();
  Result<io::Pixels> second = drawOne(pair.second, settings, true, **session);
  if (!second) return tl::unexpected(second.error());
  drawn.first = std::move(*first), drawn.second = std::move(*second);
  drawn.origin = gl::originOn((*session)->context());
  drawn.origin.environment = (*session)->environmentName(), drawn.origin.model = pair.second;
  drawn.origin.seed = settings.quality.seed;
  return drawn;
}

}  // namespace facet::commands
