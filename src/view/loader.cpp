#include "view/loader.hpp"

#include <new>

#include "ibl/cache.hpp"
#include "io/sources.hpp"

namespace facet::view {

namespace {

tl::unexpected<Error> tooLarge(const std::string& source) {
  return fail(source, "", "the memory does not suffice", "give a smaller input");
}

ModelLoaded loadModel(const std::string& source, const io::Bump& bump) {
  try {
    Result<io::LoadedModel> loaded = io::loadModel(source, {}, bump);
    if (!loaded) return {source, tl::unexpected(loaded.error())};
    return {source, std::make_shared<const io::LoadedModel>(std::move(*loaded))};
  } catch (const std::bad_alloc&) {
    return {source, tooLarge(source)};
  }
}

EnvironmentLoaded loadEnvironment(const std::string& source) {
  EnvironmentLoaded out{source, nullptr, {}, {}};
  if (source == "none") return out;
  try {
    Result<scene::Environment> loaded = io::loadEnvironmentSource(source, out.notes);
    if (loaded) {
      out.content = ibl::contentKey(*loaded);
      out.environment = std::make_shared<const scene::Environment>(std::move(*loaded));
    } else {
      out.environment = tl::unexpected(loaded.error());
    }
  } catch (const std::bad_alloc&) {
    out.environment = tooLarge(source);
  }
  return out;
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

void startModel(Loader& loader, const std::string& source, const io::Bump& bump) {
  loader.model.start([source, bump] { return loadModel(source, bump); });
}

void startEnvironment(Loader& loader, const std::string& source) {
  loader.environment.start([source] { return loadEnvironment(source); });
}

void startImages(Loader& loader, std::shared_ptr<const io::LoadedModel> model, std::vector<bool> wanted) {
  loader.images.start([model = std::move(model), wanted = std::move(wanted)] { return decodeImages(model, wanted); });
}

}  // namespace facet::view
