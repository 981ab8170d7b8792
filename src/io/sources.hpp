#pragma once

// Models and environments by the names that people give: a file, or "builtin:NAME"; a model, too, "-" for standard
// input, which can be read once.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "io/bump.hpp"
#include "io/gltf.hpp"
#include "io/safe_files.hpp"
#include "scene/environment.hpp"

namespace facet::io {

inline constexpr std::string_view builtinPrefix = "builtin:";
inline constexpr std::string_view standardInput = "-";

// What a name stands for, read and not yet looked at.
struct ModelBytes {
  std::string name;  // for messages
  FileBytes file;
  std::filesystem::path folder = {};  // that files it names are looked for below; empty: none may be named
  std::span<const uint8_t> bytes() const { return file.span(); }
};
// Errors: there is nothing to read.
Result<ModelBytes> readModelBytes(const std::string& source, const Limits& limits = {});

// The file or built-in scene, geometry completed (scene::completeGeometry). A bump is for built-in scenes alone: files
// bring normal textures of their own, and texture coordinates that only their authors know.
Result<LoadedModel> loadModel(const std::string& source, const Limits& limits = {}, const Bump& bump = {});
// Of what was read already.
Result<LoadedModel> loadModel(const ModelBytes& source, const Limits& limits = {});

// `with` in the same scene as `source` (scene::addModel). Notes about them name them.
Result<LoadedModel> loadModels(const std::string& source, std::span<const std::string> with, const Limits& limits = {},
                               const Bump& bump = {});

// An environment and the layer of its OpenEXR file in one: "passes.exr#Combined". layer empty: the source alone.
std::string withLayer(const std::string& source, const std::string& layer);
struct LayeredSource {
  std::string file, layer;
};
// A file whose whole name that is has no layer.
LayeredSource splitLayer(const std::string& source);

// What can be told of them without reading: there is no such file or built-in one, or it is no file.
Result<void> checkModelSource(const std::string& source, const Limits& limits = {}, const Bump& bump = {});
Result<void> checkEnvironmentSource(const std::string& source, const Limits& limits = {});

// The file, perhaps one of its layers, or built-in environment.
Result<scene::Environment> loadEnvironmentSource(const std::string& source, Notes& notes, const Limits& limits = {});

}  // namespace facet::io
