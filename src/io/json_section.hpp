#pragma once

// Sections of the file that are read from the JSON itself: tinygltf keeps the integers of extensions in 32 bits only.

#include <nlohmann/json.hpp>

#include "io/gltf_document.hpp"

namespace facet::io {

// The root's array of objects of this name; an empty one where the key is missing.
Result<nlohmann::json> section(const Document& doc, std::string_view key);

// object.extensions[name]; null where there is none or it is no object.
const nlohmann::json* extensionOf(const nlohmann::json& object, const char* name);

}  // namespace facet::io
