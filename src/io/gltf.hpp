#pragma once

// glTF 2.0 (.gltf with files or data URIs, .glb) -> scene::Model, through tinygltf, which never leaves this folder.
// Everything that a later step relies on is checked here: every index in range, every number finite, no cycle, every
// attribute array as long as its positions. Hostile input is answered by an Error, never by a crash, a hang or a read
// outside the model's folder.

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>

#include "base/error.hpp"
#include "scene/model.hpp"

namespace facet::io {

struct Limits {
  uint64_t fileBytes = uint64_t{4} << 30;       // one file
  uint64_t totalBytes = uint64_t{8} << 30;      // all files of a model together
  uint64_t imageSide = 16384;                   // of any image: what every OpenGL 4.5 can hold
  uint64_t imagePixels = uint64_t{1} << 28;     // one image, 16384 x 16384
  uint64_t totalPixels = uint64_t{1} << 30;     // all images of a model together
  uint64_t radiancePixels = uint64_t{1} << 27;  // one .hdr or .exr, 16384 x 8192
  uint64_t geometryBytes = uint64_t{4} << 30;   // decoded vertices and indices of a model
  int jsonDepth = 256;
  std::string allowOutside = {};  // folder that files of a model may lie in besides its own; empty: none
  bool editable = false;          // materials will be changed: what any value of theirs can show is read, too
};

struct LoadedModel {
  scene::Model model;
  Notes notes;            // repaired, ignored, missing
  bool editable = false;  // Limits'
};

Result<LoadedModel> loadGltf(const std::filesystem::path& path, const Limits& limits = {});

// A .glb or .gltf text in memory; files that it names are looked for below baseFolder (empty: none may be named).
Result<LoadedModel> loadGltfBytes(std::span<const uint8_t> bytes, const std::string& name,
                                  const std::filesystem::path& baseFolder = {}, const Limits& limits = {});

}  // namespace facet::io
