#include <webp/decode.h>
#include <webp/encode.h>

#include <cstring>
#include <memory>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

// One colour takes no bytes, however large the picture is. Up to that it is decoded; beyond, flat pictures of that many
// pixels a byte are not made by people.
constexpr uint64_t freeWebpPixels = uint64_t{1} << 24, webpPixelsPerByte = 4096;

}  // namespace

bool isWebp(std::span<const uint8_t> bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 &&
         std::memcmp(bytes.data() + 8, "WEBP", 4) == 0;
}

Result<ImageHeader> readWebpHeader(std::span<const uint8_t> bytes) {
  WebPBitstreamFeatures features;
  if (WebPGetFeatures(bytes.data(), bytes.size(), &features) != VP8_STATUS_OK || features.width <= 0 ||
      features.height <= 0)
    return damagedHeader();
  if (features.has_animation) return fail("", "", "is an animated WebP image", "use a still image");
  ImageHeader header{features.width, features.height, features.has_alpha ? 4 : 3};
  if (header.pixels() > freeWebpPixels) header.leastBytes = header.pixels() / webpPixelsPerByte;
  return header;
}

Result<Pixels> decodeWebp(std::span<const uint8_t> bytes, const ImageHeader& header) {
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.data.resize(header.pixels() * static_cast<uint64_t>(header.channels));
  const auto function = header.channels == 4 ? WebPDecodeRGBAInto : WebPDecodeRGBInto;
  if (!function(bytes.data(), bytes.size(), pixels.data.data(), pixels.data.size(), header.width * header.channels))
    return damagedImage("its WebP data is faulty or too short");
  return pixels;
}

std::vector<uint8_t> webpOf(const Pixels& pixels, int quality) {
  WebPConfig config;
  WebPPicture picture;
  if (!WebPConfigInit(&config) || !WebPPictureInit(&picture)) return {};
  config.quality = static_cast<float>(quality);
  // Also the colour of what is transparent stays.
  if (quality == 100 && !WebPConfigLosslessPreset(&config, 2)) return {};
  config.exact = 1;
  config.use_sharp_yuv = 1;  // colours have half the resolution: made so that their edges stay where they are
  config.thread_level = 1;
  picture.use_argb = 1;
  picture.width = pixels.width, picture.height = pixels.height;
  const std::unique_ptr<WebPPicture, decltype(&WebPPictureFree)> freed(&picture, WebPPictureFree);
  const auto import = pixels.channels == 4 ? WebPPictureImportRGBA : WebPPictureImportRGB;
  if (!import(&picture, pixels.data.data(), pixels.width * pixels.channels)) return {};
  std::vector<uint8_t> bytes;
  picture.custom_ptr = &bytes;
  picture.writer = [](const uint8_t* data, size_t size, const WebPPicture* to) {
    auto* const out = static_cast<std::vector<uint8_t>*>(to->custom_ptr);
    try {
      out->insert(out->end(), data, data + size);
    } catch (const std::bad_alloc&) {
      return 0;
    }
    return 1;
  };
  return WebPEncode(&config, &picture) ? bytes : std::vector<uint8_t>();
}

}  // namespace facet::io
