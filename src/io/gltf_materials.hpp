#pragma once

// What the readers of materials and textures share: numbers and references below a JSON object.

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>

#include "io/gltf_document.hpp"

namespace facet::io {

// The value at a path of keys, "clearcoatNormalTexture/scale", below an object; null where any of them is missing or
// holds null. Errors: something on the way is no object. `place` becomes that of the value.
Result<const nlohmann::json*> valueAt(const Document& doc, const nlohmann::json& object, std::string_view path,
                                      std::string& place);

// As many numbers as `to` takes; where there is no value, it stays as it is. A single one is a number, several are an
// array. inRange: the valid number next to a finite one; where it changes one, that is a warning. Errors: not numbers,
// not as many, not finite in single precision.
Result<void> readNumbers(Document& doc, const nlohmann::json& object, std::string_view path, std::string place,
                         std::span<float> to, const std::function<float(double)>& inRange);

// A textureInfo, with KHR_texture_transform. Without a value none; a set of coordinates that is not supported: none,
// with a warning. Errors: wrong types, no such texture.
Result<void> readTextureRef(Document& doc, const nlohmann::json& object, std::string_view path, std::string place,
                            scene::TextureRef& to);

}  // namespace facet::io
