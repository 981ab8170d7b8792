#pragma once

// Images of the model as they are on the GPU.

#include <cstddef>
#include <string>
#include <vector>

namespace facet::frame {
struct GpuScene;
}
namespace facet::scene {
struct Model;
}

namespace facet::view {

struct ShownTexture {
  int image = -1;  // of the model
  std::string name;
  unsigned id = 0;  // OpenGL's
  int width = 0, height = 0, levels = 1;
  std::string format;  // "sRGB, 8 bits, red green blue"
  size_t bytes = 0;
  std::string users;  // names of materials
};

// Those that are loaded, in the order of images; one that is stored for several uses stands there several times.
std::vector<ShownTexture> shownTextures(const scene::Model& model, const frame::GpuScene& gpu);

// On the last item: a tooltip with the picture and what is known of it.
void textureHint(const ShownTexture& texture);

// All of them, in rows.
void textureList(const std::vector<ShownTexture>& textures, const std::string& filter);

}  // namespace facet::view
