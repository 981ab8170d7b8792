#pragma once

// The textures that materials name, wherever in them they stand.

#include <string>
#include <vector>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

struct TextureUse {
  std::string place;  // of its object: "/materials/0/normalTexture"
  int texture = -1;
  int texCoord = 0;     // KHR_texture_transform's where it has one
  bool colour = false;  // an sRGB curve counts
};

struct MaterialTextures {
  std::vector<TextureUse> uses;
  bool hasNormalMap = false;  // any, or directions along the surface

  bool hasBaseNormalMap = false;  // normalTexture
  bool needsTangents = false;     // by something else: anisotropy
};

MaterialTextures texturesOf(const Asset& asset, int material);

}  // namespace facet::io::validate
