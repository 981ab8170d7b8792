#include "io/sources.hpp"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "io/gltf_environment.hpp"
#include "io/radiance.hpp"
#include "io/safe_files.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/builtin_scenes.hpp"
#include "scene/geometry.hpp"
#include "scene/together.hpp"

namespace facet::io {

namespace {

namespace fs = std::filesystem;

bool isBuiltin(const std::string& source) { return source.starts_with(builtinPrefix); }

LoadedModel completed(LoadedModel loaded, const Limits& limits) {
  scene::completeGeometry(loaded.model, loaded.notes, -1, limits.editable);
  loaded.editable = limits.editable;
  return loaded;
}

Result<void> checkBump(const std::string& source, const Bump& bump) {
  if (bump.file.empty() || isBuiltin(source)) return {};
  return fail(source, "", "a bump is for the built-in scenes", "leave it out, or show builtin:poster", Setting::bump);
}

}  // namespace

Result<void> checkModelSource(const std::string& source, const Limits& limits, const Bump& bump) {
  if (Result<void> r = checkBump(source, bump); !r) return r;
  if (!bump.file.empty())
    if (Result<void> r = checkRegularFile(bump.file, limits.fileBytes); !r) return r;
  if (source == standardInput) return {};
  if (!isBuiltin(source)) return checkRegularFile(source, limits.fileBytes);
  if (scene::findBuiltinScene(source)) return {};
  const Result<std::vector<uint8_t>> unknown = scene::builtinScene(source);
  return unknown ? Result<void>() : tl::unexpected(unknown.error());
}

std::string withLayer(const std::string& source, const std::string& layer) {
  return layer.empty() ? source : source + "#" + layer;
}

LayeredSource splitLayer(const std::string& source) {
  const size_t at = source.rfind('#');
  std::error_code ignored;
  if (at == std::string::npos || std::filesystem::exists(source, ignored)) return {source, ""};
  if (!std::filesystem::exists(source.substr(0, at), ignored)) return {source, ""};
  return {source.substr(0, at), source.substr(at + 1)};
}

Result<void> checkEnvironmentSource(const std::string& source, const Limits& limits) {
  if (!isBuiltin(source)) return checkRegularFile(splitLayer(source).file, limits.fileBytes);
  const auto named = [&](const auto& environment) { return source.substr(builtinPrefix.size()) == environment.name; };
  if (std::ranges::any_of(scene::builtinEnvironments(), named)) return {};
  const Result<scene::Environment> unknown = scene::builtinEnvironment(source);
  return unknown ? Result<void>() : tl::unexpected(unknown.error());
}

Result<ModelBytes> readModelBytes(const std::string& source, const Limits& limits) {
  const uint64_t most = std::min(limits.fileBytes, limits.totalBytes);
  if (source == standardInput)
    return readStandardInput(most).map([](FileBytes bytes) { return ModelBytes{"standard input", std::move(bytes)}; });
  if (isBuiltin(source))
    return scene::builtinScene(source).map([&](const std::vector<uint8_t>& bytes) {
      return ModelBytes{source, copyOf(bytes)};
    });
  const fs::path parent = fs::path(source).parent_path();
  return readRegularFile(source, most).map([&](FileBytes bytes) {
    return ModelBytes{source, std::move(bytes), parent.empty() ? "." : parent};
  });
}

Result<LoadedModel> loadModel(const ModelBytes& source, const Limits& limits) {
  return loadGltfBytes(source.bytes(), source.name, source.folder, limits).map([&](LoadedModel loaded) {
    return completed(std::move(loaded), limits);
  });
}

Result<LoadedModel> loadModel(const std::string& source, const Limits& limits, const Bump& bump) {
  if (Result<void> r = checkBump(source, bump); !r) return tl::unexpected(r.error());
  const Result<ModelBytes> bytes = readModelBytes(source, limits);
  if (!bytes) return tl::unexpected(bytes.error());
  Result<LoadedModel> loaded = loadGltfBytes(bytes->bytes(), bytes->name, bytes->folder, limits);
  if (loaded && !bump.file.empty())
    if (auto ok = applyBump(loaded->model, bump, limits); !ok) return tl::unexpected(ok.error());
  return loaded ? completed(std::move(*loaded), limits) : std::move(loaded);
}

Result<LoadedModel> loadModels(const std::string& source, std::span<const std::string> with, const Limits& limits,
                               const Bump& bump) {
  Result<LoadedModel> loaded = loadModel(source, limits, bump);
  for (const std::string& other : with) {
    if (!loaded) break;
    Result<LoadedModel> added = loadModel(other, limits);
    if (!added) return tl::unexpected(added.error());
    scene::addModel(loaded->model, std::move(added->model));
    for (Note& note : added->notes) {
      note.place = other + (note.place.empty() ? "" : ": " + note.place);
      loaded->notes.push_back(std::move(note));
    }
  }
  return loaded;
}

Result<scene::Environment> loadEnvironmentSource(const std::string& source, Notes& notes, const Limits& limits) {
  if (isBuiltin(source)) return scene::builtinEnvironment(source);
  const LayeredSource layered = splitLayer(source);
  Result<scene::Environment> loaded = isGltfName(layered.file)
                                          ? loadGltfEnvironment(layered.file, layered.layer, notes, limits)
                                          : loadEnvironment(layered.file, notes, limits, layered.layer);
  if (!loaded && !layered.layer.empty()) loaded.error().about = Setting::environmentLayer;
  return loaded;
}

}  // namespace facet::io
