#pragma once

// Sections of the file that are read from the JSON itself: tinygltf keeps the integers of extensions in 32 bits only.

#include <nlohmann/json_fwd.hpp>

#include "io/gltf_document.hpp"

namespace facet::io {

// The root's array of objects of this name; an empty one where the key is missing.
Result<nlohmann::json> section(const Document& doc, std::string_view key);

// object.extensions[name]; null where there is none or it is no object.
const nlohmann::json* extensionOf(const nlohmann::json& object, const char* name);

// Empty where the key is missing or holds something else than a string.
std::string stringAt(const nlohmann::json& object, const char* key);

// What a uri names: bytes of the text, or a file below the model's folder. Errors: none of both; what the limits say.
Result<std::span<const uint8_t>> bytesOfUri(Document& doc, const std::string& uri, const std::string& place);

// The root's extension of that name; null where there is none.
nlohmann::json rootExtension(const Document& doc, const char* name);

// An index into `count` things that are called `what`. Errors: no whole number; out of range.
Result<int> readIndex(const Document& doc, const nlohmann::json& value, size_t count, const std::string& place,
                      const char* what);

}  // namespace facet::io
