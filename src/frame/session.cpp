#include "frame/session.hpp"

#include <malloc.h>

#include <algorithm>
#include <iterator>
#include <thread>
#include <utility>

#include "frame/settings.hpp"
#include "frame/user_stores.hpp"
#include "io/sources.hpp"

namespace facet::frame {

namespace {

constexpr size_t keptEnvironments = 4;

Result<LoadedEnvironment*> findEnvironment(Shelf& shelf, const std::string& source, Notes& notes) {
  std::unique_ptr<LoadedEnvironment>& entry = shelf.environments[source];
  if (entry) return entry.get();
  auto made = std::make_unique<LoadedEnvironment>();
  made->source = source;
  made->cache = shelf.tableCache;
  if (source != "none") {
    Result<scene::Environment> loaded = io::loadEnvironmentSource(source, notes);
    if (!loaded) return tl::unexpected(loaded.error());
    made->environment = std::make_shared<const scene::Environment>(std::move(*loaded));
    findSun(*made);
  }
  entry = std::move(made);
  LoadedEnvironment* const found = entry.get();
  // A suite that goes through many maps should not keep them all.
  if (shelf.environments.size() > keptEnvironments)
    std::erase_if(shelf.environments, [&](const auto& kept) { return kept.second.get() != found; });
  malloc_trim(0);  // what was needed only while reading goes back to the system
  return found;
}

// A few at a time, so that never more of them than the machine decodes at once are in memory twice.
Result<bool> decodeSome(LoadedScene& scene, const std::vector<bool>& missing, Notes& notes) {
  const size_t atOnce = std::max(2u, std::thread::hardware_concurrency());
  std::vector<bool> some(missing.size(), false);
  size_t count = 0;
  for (size_t image = 0; image < missing.size() && count < atOnce; ++image)
    if (missing[image]) some[image] = true, ++count;
  scene.pixels = io::decodeImages(scene.model(), some, notes);
  return true;
}

}  // namespace

Supply supplyAtOnce(Shelf& shelf, shading::ProgramStore& programs, Notes& notes) {
  Supply supply;
  supply.environment = [&](const std::string& source) { return findEnvironment(shelf, source, notes); };
  supply.measured = [&, told = std::make_shared<bool>(false)](const MeasuredSource& source) {
    Notes again;  // each step of a plan asks; its notes are told once
    return findMeasured(shelf.measured, source, std::exchange(*told, true) ? again : notes);
  };
  supply.fitted = [&](const MeasuredSource& source, optics::DiffuseModel diffuse) {
    auto fit = findFit(shelf.measured, source, diffuse);
    if (fit) std::ranges::move(fitNotes((*fit)->fitted), std::back_inserter(notes));
    return fit;
  };
  supply.images = [&](LoadedScene& scene, const std::vector<bool>& missing) {
    return decodeSome(scene, missing, notes);
  };
  supply.tables = [&](LoadedEnvironment& environment, const ibl::Needs& needs) {
    return prepareTables(environment, needs, programs);
  };
  return supply;
}

Session::Session(gl::HeadlessContext context, const SessionOptions& options)
    : context_(std::move(context)),
      programs_(userPrograms(context_.info(), options.shaderDir, options.diskCache)),
      shelf_{userTables(context_.info(), options.shaderDir, options.diskCache)} {}

Result<std::unique_ptr<Session>> Session::create(const SessionOptions& options) {
  Result<gl::HeadlessContext> context = gl::HeadlessContext::create(options.debug, options.among);
  if (!context) return tl::unexpected(context.error());
  return std::unique_ptr<Session>(new Session(std::move(*context), options));
}

Result<void> Session::load(const std::string& source, const PictureSettings& settings, Notes& notes) {
  const Sources& sources = settings.sources;
  const io::Bump bump{sources.bump, sources.bumpScale};
  const bool editable = !settings.placement.arrangement.edits.empty() || !settings.look.material.edits.empty();
  if (scene_ && scene_->source == source && scene_->with == sources.with && scene_->bump == bump &&
      allowOutside_ == sources.allowOutside && (model_->editable || !editable))
    return {};
  scene_.reset(), model_.reset();  // frees the old one before the new one grows
  Result<io::LoadedModel> loaded =
      io::loadModels(source, sources.with, {.allowOutside = sources.allowOutside, .editable = editable}, bump);
  if (!loaded) return tl::unexpected(loaded.error());
  model_ = std::make_shared<io::LoadedModel>(std::move(*loaded));
  allowOutside_ = sources.allowOutside;
  scene_ = std::make_unique<LoadedScene>(
      LoadedScene{.source = source, .with = sources.with, .bump = bump, .loaded = model_});
  notes.insert(notes.end(), model_->notes.begin(), model_->notes.end());
  return {};
}

Result<Picture> Session::render(const std::string& model, const PictureSettings& settings,
                                const PictureRequest& request, Notes& notes, Stages& stages) {
  Result<Picture> picture = draw(model, settings, request, notes, stages);
  // The driver's trouble may be why there is none.
  if (Result<void> r = gl::checkDriver("the picture"); !r) return tl::unexpected(r.error());
  return picture;
}

Result<Picture> Session::draw(const std::string& model, const PictureSettings& settings, const PictureRequest& request,
                              Notes& notes, Stages& stages) {
  programs_.keepLatest(shading::keptPrograms);
  if (Result<void> r = load(model, settings, notes); !r) return tl::unexpected(r.error());
  stages.mark("read model");
  PictureStatistics statistics;
  const Supply supply = supplyAtOnce(shelf_, programs_, notes);
  const Result<Drawable> drawable =
      preparePicture(settings, request, *scene_, supply, programs_, statistics, notes, stages);
  if (!drawable) return tl::unexpected(drawable.error());
  environmentName_ = drawable->environment->source;
  if (request.last) {
    drawable->environment->environment.reset(), drawable->environment->found.reset();
    for (scene::Image& image : model_->model.images) image.encoded = {};
  }
  malloc_trim(0);
  if (Result<void> r = gl::checkDriver("the scene"); !r) return tl::unexpected(r.error());
  return drawPicture(settings, request, *drawable, std::move(statistics), programs_, context_.info(), stages);
}

}  // namespace facet::frame
