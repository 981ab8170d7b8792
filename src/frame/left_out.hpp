#pragma once

#include <string>
#include <vector>

#include "frame/picture.hpp"

namespace facet::frame {

// What the picture did not need and what therefore was not done, one sentence each.
std::vector<std::string> leftOut(const scene::Model& model, const frame::PictureStatistics& statistics);

// Per drawn material: its variants, the textures it reads, and those that it names but does not read.
struct MaterialUsage {
  std::string name;
  std::vector<std::string> variants;
  std::vector<std::string> textures;
  std::vector<std::string> unusedTextures;
};
std::vector<MaterialUsage> materialUsage(const scene::Model& model, const frame::DrawList& list);

}  // namespace facet::frame
