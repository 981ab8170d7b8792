#pragma once

#include <filesystem>
#include <vector>

namespace facet::io {

// Of a .gltf or .glb: the files that its buffers and images name, missing ones too, each below the model's folder or
// that other one (Limits::allowOutside).
// Whatever cannot be read names none: reading the model itself says what is wrong.
std::vector<std::filesystem::path> referencedFiles(const std::filesystem::path& gltf,
                                                   const std::string& allowOutside = {});

}  // namespace facet::io
