#include "io/sources.hpp"

#include <string_view>

#include "io/radiance.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/geometry.hpp"

namespace facet::io {

namespace {

constexpr std::string_view builtinPrefix = "builtin:";

bool isBuiltin(const std::string& source) { return source.starts_with(builtinPrefix); }

Result<LoadedModel> readModel(const std::string& source, const Limits& limits) {
  if (!isBuiltin(source)) return loadGltf(source, limits);
  const Result<std::vector<uint8_t>> bytes = scene::builtinScene(source.substr(builtinPrefix.size()));
  if (!bytes) return tl::unexpected(bytes.error());
  return loadGltfBytes(*bytes, source, {}, limits);
}

}  // namespace

Result<LoadedModel> loadModel(const std::string& source, const Limits& limits, const Bump& bump) {
  const bool bumped = !bump.file.empty();
  if (bumped && !isBuiltin(source))
    return fail(source, "", "--bump is for the built-in scenes", "leave it out, or show builtin:poster");
  Result<LoadedModel> loaded = readModel(source, limits);
  if (loaded && bumped)
    if (auto ok = applyBump(loaded->model, bump, limits); !ok) return tl::unexpected(ok.error());
  if (loaded) scene::completeGeometry(loaded->model, loaded->notes);
  return loaded;
}

Result<scene::Environment> loadEnvironmentSource(const std::string& source, Notes& notes, const Limits& limits) {
  if (isBuiltin(source)) return scene::builtinEnvironment(source.substr(builtinPrefix.size()));
  return loadEnvironment(source, notes, limits);
}

}  // namespace facet::io
