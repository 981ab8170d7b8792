#pragma once

// EXT_lights_image_based: environments that a glTF file brings along, as cube maps of images.

#include <filesystem>
#include <string>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "scene/environment.hpp"

namespace facet::io {

bool isGltfName(const std::filesystem::path& path);  // by its ending

// The light of that index ("", "0", "1", ...; none: the first). Its images' first level, the radiance itself, becomes
// the map; the tables are facet's own. Read are the file's buffers and those six images alone. Errors: no such light,
// images that are missing or no cube.
Result<scene::Environment> loadGltfEnvironment(const std::filesystem::path& path, const std::string& index,
                                               Notes& notes, const Limits& limits = {});

}  // namespace facet::io
