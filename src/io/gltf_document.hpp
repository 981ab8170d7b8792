#pragma once

// What the readers of the single sections share while a model is read. Internal to io/: tinygltf ends here.

#include <tiny_gltf.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "io/json_scan.hpp"
#include "io/safe_files.hpp"
#include "scene/model.hpp"

namespace facet::io {

struct Document {
  std::string name;              // for messages
  std::filesystem::path folder;  // canonical; empty: no files may be named
  Limits limits;
  uint64_t bytesRead = 0;  // counts towards limits.totalBytes

  std::string validUtf8, wholeNumbers;  // the text where json is not as the file has it (json_scan.hpp)
  std::string_view json;                // the whole text
  std::span<const uint8_t> binary;      // a .glb's chunk
  bool hasBinary = false;
  JsonOutline outline;

  tinygltf::Model gltf;                           // without buffers and images
  std::vector<std::span<const uint8_t>> buffers;  // by index; into storage or binary
  std::vector<bool> isFallback;                   // by the file's buffer: a stand-in for compressed views, empty
  std::vector<FileBytes> files;                   // storage
  std::vector<std::vector<uint8_t>> embedded;     // storage
  scene::Model model;
  Notes notes;

  tl::unexpected<Error> error(std::string place, std::string problem,
                              std::string remedy = "export the model again") const {
    return fail(name, std::move(place), std::move(problem), std::move(remedy));
  }
  // What the model can be shown without.
  void lost(const Error& error, std::string_view instead) {
    notes.push_back({Note::Severity::warning, error.place, error.problem + ": " + std::string(instead), error.about});
  }
  void info(std::string place, std::string text) {
    notes.push_back({Note::Severity::info, std::move(place), std::move(text)});
  }
  void warning(std::string place, std::string text) {
    notes.push_back({Note::Severity::warning, std::move(place), std::move(text)});
  }
};

// "/meshes/3" from "/meshes", 3.
inline std::string pointer(std::string_view path, size_t index) {
  return std::string(path) + "/" + std::to_string(index);
}

// Of an object; null where it is none or has no such member (tinygltf asserts that it is one).
inline const tinygltf::Value& memberValue(const tinygltf::Value& value, std::string_view key) {
  static const tinygltf::Value none;
  return value.IsObject() ? value.Get(std::string(key)) : none;
}

// The one check for every index in the file. what: "buffer view", "node" and so on.
Result<void> checkIndex(const Document& doc, int index, size_t count, const std::string& place, const char* what);

// -- One function per section; each fills its part of doc.model. --

// gltf_data.cpp: needs only the text. Buffers are read; images are found, not read.
Result<void> readBuffers(Document& doc);
Result<void> readImages(Document& doc);  // after tinygltf's buffer views

// gltf_meshopt.cpp: EXT_ and KHR_meshopt_compression. Before checkBufferViews; its views point to decoded bytes
// afterwards.
Result<void> decodeMeshopt(Document& doc);

// gltf_skins.cpp
Result<void> readSkins(Document& doc);
// gltf_nodes.cpp: after readSkins
Result<void> readNodes(Document& doc);  // and scenes
// gltf_instancing.cpp: EXT_mesh_gpu_instancing of one node; `bytes` is what those before it take
Result<void> readInstances(Document& doc, const tinygltf::Node& from, const std::string& place, scene::Node& node,
                           uint64_t& bytes);
// gltf_lights.cpp
Result<void> readLights(Document& doc);
Result<void> readCameras(Document& doc);
// gltf_profiles.cpp: EXT_lights_ies; after readLights and readNodes
Result<void> readProfiledLights(Document& doc);
// gltf_textures.cpp
Result<void> readTextures(Document& doc);  // and samplers
// gltf_materials.cpp
Result<void> readMaterials(Document& doc);
// gltf_variants.cpp: KHR_materials_variants
Result<void> readVariants(Document& doc);
// Primitive::variantMaterials; after readVariants.
Result<std::vector<int>> variantMaterials(Document& doc, const tinygltf::Primitive& primitive,
                                          const std::string& place);
// gltf_meshes.cpp: after checkAccessors, readMaterials, readVariants and readNodes
Result<void> readMeshes(Document& doc);
// gltf_animations.cpp: after all that can be animated
Result<void> readAnimations(Document& doc);

// gltf_xmp.cpp: KHR_xmp_json_ld
Result<void> readXmp(Document& doc);

// -- Extensions (gltf_extensions.cpp) --

// Errors: a required extension that is not supported and that more than looks depend on; one that only concerns looks
// is a warning. Notes those that are used and not supported.
Result<void> checkExtensions(Document& doc);

// -- Whole files (gltf.cpp) --

// Its text and its buffers, for who writes it anew. Errors: those of loadGltfBytes up to there.
Result<std::vector<uint8_t>> withBuffers(std::span<const uint8_t> bytes, const std::string& name,
                                         const std::filesystem::path& baseFolder, const Limits& limits,
                                         const std::function<Result<std::vector<uint8_t>>(Document&)>& use);

}  // namespace facet::io
