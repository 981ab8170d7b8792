#pragma once

// What a model's file says that no picture depends on: who made it, and what programs have left in it for themselves.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"

namespace facet::io {

struct MetadataEntry {
  std::string place;  // JSON pointer of what it is about: "/asset", "/nodes/3"; "": the whole file
  std::string kind;   // "asset", "extras"
  std::string text;   // JSON, indented; what is no UTF-8 has a replacement mark
};

// So long a text is; what is longer is cut, and says so.
inline constexpr size_t longestMetadata = 16384;

// The asset, and the extras of scenes, nodes, meshes, materials, textures, images, samplers, animations, skins, cameras
// and of the file, in this order. source: as loadModel has it. Errors: not readable, no JSON object, nested too deep.
Result<std::vector<MetadataEntry>> readMetadata(const std::string& source, const Limits& limits = {});
// A .glb or a .gltf text.
Result<std::vector<MetadataEntry>> readMetadata(std::span<const uint8_t> bytes, const std::string& name,
                                                const Limits& limits = {});

}  // namespace facet::io
