#pragma once

#include "support/gltf_builder.hpp"

namespace facet::test {

// A triangle that covers the middle of the picture, unlit, with this texture.
inline std::vector<uint8_t> texturedTriangle(const std::vector<uint8_t>& rgb) {
  GltfBuilder b = triangle();
  const std::vector<uint8_t> png = pngBytes(1, 1, 3, 8, rgb);
  b.append("images", {{"uri", dataUri(png, "image/png")}});
  b.append("textures", {{"source", 0}});
  b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                         {"doubleSided", true},
                         {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}});
  b.json["extensionsUsed"] = {"KHR_materials_unlit"};
  const std::vector<float> uv = {0, 0, 1, 0, 0, 1}, normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  nlohmann::json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["NORMAL"] = b.add(normals, floatType, "VEC3");
  primitive["attributes"]["TEXCOORD_0"] = b.add(uv, floatType, "VEC2");
  primitive["material"] = 0;
  return b.glb();
}

}  // namespace facet::test
