#include <webp/decode.h>

#include <cstring>

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

}  // namespace facet::io
