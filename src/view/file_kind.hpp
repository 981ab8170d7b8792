#pragma once

#include <string_view>

#include "base/error.hpp"

namespace facet::view {

enum class FileKind { model, environment, brdf, folder };

// Folders as the file system says; files by the name's ending: .gltf and .glb are models, .hdr and .exr environments,
// .binary and .bin measured BRDFs. Errors: none of these.
Result<FileKind> fileKind(std::string_view path);

}  // namespace facet::view
