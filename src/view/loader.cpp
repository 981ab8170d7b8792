#include "view/loader.hpp"

#include <algorithm>
#include <iterator>
#include <new>

#include "ibl/cache.hpp"
#include "io/measured.hpp"
#include "io/referenced_files.hpp"
#include "io/sources.hpp"

namespace facet::view {

namespace {

tl::unexpected<Error> tooLarge(const std::string& source) {
  return fail(source, "", "the memory does not suffice", "give a smaller input");
}

std::vector<std::filesystem::path> filesOf(const std::string& source, const std::string& allowOutside = {}) {
  if (source.starts_with("builtin:")) return {};
  std::vector<std::filesystem::path> files = {source};
  for (std::filesystem::path& file : io::referencedFiles(source, allowOutside)) files.push_back(std::move(file));
  return files;
}

// What is asked for of a model: all but what comes of it.
ModelLoaded loadModel(ModelLoaded asked, const io::Limits& limits) {
  try {
    std::vector<std::filesystem::path> files = filesOf(asked.source, limits.allowOutside);
    for (const std::string& other : asked.with)
      std::ranges::move(filesOf(other, limits.allowOutside), std::back_inserter(files));
    asked.watch = watchFiles(files, std::chrono::steady_clock::now());
    asked.model = io::loadModels(asked.source, asked.with, limits, asked.bump).map([](io::LoadedModel loaded) {
      return std::make_shared<const io::LoadedModel>(std::move(loaded));
    });
  } catch (const std::bad_alloc&) {
    asked.model = tooLarge(asked.source);
  }
  return asked;
}

EnvironmentLoaded loadEnvironment(const std::string& source, bool again) {
  EnvironmentLoaded out{source, again, nullptr, {}, {}};
  if (source == "none") return out;
  try {
    Result<scene::Environment> loaded = io::loadEnvironmentSource(source, out.notes);
    if (loaded) {
      out.content = ibl::contentKey(*loaded);
      out.prepared =
          std::make_shared<const ibl::PreparedEnvironment>(ibl::prepareEnvironment(*loaded, {.takeSunOut = true}));
      out.environment = std::make_shared<const scene::Environment>(std::move(*loaded));
    } else {
      out.environment = tl::unexpected(loaded.error());
    }
  } catch (const std::bad_alloc&) {
    out.environment = tooLarge(source);
  }
  return out;
}

MeasuredLoaded loadMeasured(const frame::MeasuredSource& source, bool again) {
  MeasuredLoaded out{source, again, {}, {}};
  try {
    const Result<std::string> path = io::resolveMeasured(source.name, source.folder);
    if (!path) return {source, again, tl::unexpected(path.error())};
    out.watch = watchFiles(filesOf(*path), std::chrono::steady_clock::now());
    out.read = frame::readMeasuredBytes(source);
  } catch (const std::bad_alloc&) {
    out.read = tooLarge(source.name);
  }
  return out;
}

FitMade makeFit(const frame::MeasuredSource& source, optics::DiffuseModel diffuse) {
  try {
    return {source, diffuse, frame::fitMeasured(source, diffuse)};
  } catch (const std::bad_alloc&) {
    return {source, diffuse, tooLarge(source.name)};
  }
}

TableRead readTable(const frame::MeasuredSource& source) {
  try {
    Result<optics::MeasuredBrdf> table = frame::readMeasuredTable(source);
    if (!table) return {source, tl::unexpected(table.error())};
    return {source, std::make_shared<const optics::MeasuredBrdf>(std::move(*table))};
  } catch (const std::bad_alloc&) {
    return {source, tooLarge(source.name)};
  }
}

ImagesDecoded decodeImages(const std::shared_ptr<const io::LoadedModel>& model, const std::vector<bool>& wanted) {
  ImagesDecoded out{model, {}, {}};
  try {
    out.pixels = io::decodeImages(model->model, wanted, out.notes);
  } catch (const std::bad_alloc&) {
    out.pixels = tooLarge(model->model.name);
  }
  return out;
}

}  // namespace

void startModel(Loader& loader, const std::string& source, Opening opening, const io::Bump& bump) {
  const io::Limits limits{.allowOutside = loader.allowOutside, .editable = loader.editable};
  ModelLoaded asked{.source = source, .opening = opening, .model = {}, .with = loader.with, .bump = bump};
  loader.model.start([asked = std::move(asked), limits] { return loadModel(asked, limits); });
}

void startEnvironment(Loader& loader, const std::string& source, bool again) {
  loader.environment.start([source, again] { return loadEnvironment(source, again); });
}

void startMeasured(Loader& loader, const frame::MeasuredSource& source, bool again) {
  loader.measured.start([source, again] { return loadMeasured(source, again); });
}

void startFit(Loader& loader, const frame::MeasuredSource& source, optics::DiffuseModel diffuse) {
  loader.fit.start([source, diffuse] { return makeFit(source, diffuse); });
}

void startTable(Loader& loader, const frame::MeasuredSource& source) {
  loader.table.start([source] { return readTable(source); });
}

void startImages(Loader& loader, std::shared_ptr<const io::LoadedModel> model, std::vector<bool> wanted) {
  loader.imagesAsked = {model, wanted};
  loader.images.start([model = std::move(model), wanted = std::move(wanted)] { return decodeImages(model, wanted); });
}

bool decodes(const Loader& loader, const std::shared_ptr<const io::LoadedModel>& model,
             const std::vector<bool>& wanted) {
  const ImagesAsked& asked = loader.imagesAsked;
  if (!loader.images.running() || asked.model != model) return false;
  for (size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] && !asked.wanted[i]) return false;
  return true;
}

}  // namespace facet::view
