#include "scene/png_writer.hpp"

#include <spng.h>

#include <cstdlib>
#include <memory>
#include <new>

namespace facet::scene {

namespace {

std::vector<uint8_t> encoded(int width, int height, spng_color_type type, const spng_plte* palette,
                             std::span<const uint8_t> texels) {
  const auto close = [](spng_ctx* context) { spng_ctx_free(context); };
  const std::unique_ptr<spng_ctx, decltype(close)> png(spng_ctx_new(SPNG_CTX_ENCODER), close);
  spng_ihdr header = {
      static_cast<uint32_t>(width), static_cast<uint32_t>(height), 8, static_cast<uint8_t>(type), 0, 0, 0};
  spng_set_option(png.get(), SPNG_ENCODE_TO_BUFFER, 1);
  spng_set_option(png.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
  spng_set_option(png.get(), SPNG_FILTER_CHOICE, SPNG_DISABLE_FILTERING);
  spng_set_ihdr(png.get(), &header);
  spng_plte copy;
  if (palette) copy = *palette, spng_set_plte(png.get(), &copy);
  int status = spng_encode_image(png.get(), texels.data(), texels.size(), SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  size_t size = 0;
  const auto free = [](void* bytes) { std::free(bytes); };
  const std::unique_ptr<void, decltype(free)> bytes(spng_get_png_buffer(png.get(), &size, &status), free);
  if (status != 0) throw std::bad_alloc();
  const auto* first = static_cast<const uint8_t*>(bytes.get());
  return {first, first + size};
}

}  // namespace

std::vector<uint8_t> rgbPng(int width, int height, std::span<const uint8_t> rgb) {
  return encoded(width, height, SPNG_COLOR_TYPE_TRUECOLOR, nullptr, rgb);
}

std::vector<uint8_t> palettePng(int width, int height, std::span<const uint8_t> texels,
                                std::span<const glm::u8vec3, 256> colors) {
  spng_plte palette = {256, {}};
  for (size_t i = 0; i < colors.size(); ++i) palette.entries[i] = {colors[i].r, colors[i].g, colors[i].b, 0};
  return encoded(width, height, SPNG_COLOR_TYPE_INDEXED, &palette, texels);
}

}  // namespace facet::scene
