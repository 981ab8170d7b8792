#include "frame/session.hpp"

#include <malloc.h>

#include "io/sources.hpp"

namespace facet::frame {

namespace {

constexpr size_t keptEnvironments = 4;

std::string driverName(const gl::ContextInfo& info) { return info.vendor + "\n" + info.renderer + "\n" + info.version; }

}  // namespace

Session::Session(gl::HeadlessContext context, const SessionOptions& options)
    : context_(std::move(context)),
      programs_(shading::shaderReader(options.shaderDir),
                options.diskCache && context_.info().programBinaries ? userCacheFolder() : std::filesystem::path(),
                driverName(context_.info())) {
  // Shaders of the user's may make other tables.
  if (options.diskCache && options.shaderDir.empty()) tableCache_ = ibl::userTableCache(driverName(context_.info()));
}

Result<std::unique_ptr<Session>> Session::create(const SessionOptions& options) {
  Result<gl::HeadlessContext> context = gl::HeadlessContext::create(options.debug);
  if (!context) return tl::unexpected(context.error());
  return std::unique_ptr<Session>(new Session(std::move(*context), options));
}

Result<void> Session::loadScene(const std::string& source, const io::Bump& bump, Notes& notes) {
  if (scene_ && scene_->source == source && scene_->bump == bump) return {};
  scene_.reset();  // frees the old one before the new one grows
  Result<io::LoadedModel> loaded = io::loadModel(source, {}, bump);
  if (!loaded) return tl::unexpected(loaded.error());
  scene_ = std::make_unique<LoadedScene>(LoadedScene{source, bump, std::move(*loaded), {}});
  scene_->onGpu.source = source;
  scene_->onGpu.model = &scene_->loaded.model;
  scene_->onGpu.measured = measured_;
  notes.insert(notes.end(), scene_->loaded.notes.begin(), scene_->loaded.notes.end());
  return {};
}

Result<LoadedEnvironment*> Session::findEnvironment(const std::string& source, Notes& notes) {
  std::unique_ptr<LoadedEnvironment>& entry = environments_[source];
  if (entry) return entry.get();
  auto made = std::make_unique<LoadedEnvironment>();
  if (source != "none") {
    Result<scene::Environment> loaded = io::loadEnvironmentSource(source, notes);
    if (!loaded) return tl::unexpected(loaded.error());
    made->environment = std::move(*loaded);
    made->onGpu.environment = &made->environment;
    findSun(made->onGpu);
  }
  made->onGpu.cache = tableCache_;
  entry = std::move(made);
  LoadedEnvironment* const found = entry.get();
  // A suite that goes through many maps should not keep them all.
  if (environments_.size() > keptEnvironments)
    std::erase_if(environments_, [&](const auto& kept) { return kept.second.get() != found; });
  return found;
}

Result<Picture> Session::render(const std::string& model, const PictureSettings& settings,
                                const PictureRequest& request, Notes& notes, Stages& stages) {
  if (Result<void> r = loadScene(model, {settings.sources.bump, settings.sources.bumpScale}, notes); !r)
    return tl::unexpected(r.error());
  stages.mark("read model");
  const Result<int> scene = chooseScene(settings, scene_->loaded.model);
  if (!scene) return tl::unexpected(scene.error());
  environmentName_ = chooseEnvironment(settings, model, scene_->loaded.model, *scene);
  Result<LoadedEnvironment*> environment = findEnvironment(environmentName_, notes);
  if (!environment) return tl::unexpected(environment.error());
  malloc_trim(0);  // what was needed only while reading goes back to the system
  stages.mark("read environment");
  Result<PreparedPicture> prepared =
      preparePicture(settings, scene_->onGpu, (*environment)->onGpu, programs_, notes, stages);
  if (!prepared) return tl::unexpected(prepared.error());
  if (request.last) {
    (*environment)->environment.radiance = {};
    for (scene::Image& image : scene_->loaded.model.images) image.encoded = {};
  }
  malloc_trim(0);
  return drawPicture(settings, request, std::move(*prepared), scene_->onGpu, (*environment)->onGpu, programs_,
                     context_.info(), stages);
}

}  // namespace facet::frame
