#pragma once

// The bytes of a file's buffer views, those that EXT or KHR_meshopt_compression hold decoded (gltf.cpp).

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"

namespace facet::io {

struct DecodedViews {
  std::shared_ptr<const void> owner;
  std::vector<std::span<const uint8_t>> bytes;  // by view
};

// `bytes` outlives them. Errors: those of loadGltfBytes up to there.
Result<DecodedViews> decodeViews(std::span<const uint8_t> bytes, const std::string& name,
                                 const std::filesystem::path& baseFolder, const Limits& limits);

}  // namespace facet::io
