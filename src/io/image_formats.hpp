#pragma once

// The decoders behind io/image.hpp, one for each format. Internal to io/. Errors come without a name; no call keeps or
// changes the bytes. Limits on sizes are image.cpp's, which looks at the header before it calls decode.

#include <cstdint>
#include <span>
#include <string>

#include "base/error.hpp"
#include "io/image.hpp"

namespace facet::io {

struct ImageHeader {
  int width = 0, height = 0;  // > 0
  int channels = 0;           // as in Pixels
  int bytesPerSample = 1;
  uint64_t leastBytes = 0;  // no file of so many pixels is shorter
  uint64_t passes = 1;      // how often the file comes back to all pixels
  int levels = 1;           // mip levels
  std::string texels = {};  // of KTX2: "UASTC, Zstandard"
  uint64_t pixels() const { return static_cast<uint64_t>(width) * static_cast<uint64_t>(height); }
};

inline tl::unexpected<Error> damagedHeader() { return fail("", "", "the image's header is damaged", "save it again"); }
inline tl::unexpected<Error> damagedImage(const std::string& reason) {
  return fail("", "", "the image is damaged: " + reason, "save it again");
}

// image_jpeg.cpp, through libjpeg-turbo: baseline and progressive; grey, RGB, and CMYK as Adobe writes it (inverted).
bool isJpeg(std::span<const uint8_t> bytes);
Result<ImageHeader> readJpegHeader(std::span<const uint8_t> bytes);
Result<Pixels> decodeJpeg(std::span<const uint8_t> bytes, const ImageHeader& header);

// image_png.cpp, through libspng: palettes and less than 8 bits become 8, tRNS becomes alpha.
bool isPng(std::span<const uint8_t> bytes);
Result<ImageHeader> readPngHeader(std::span<const uint8_t> bytes);
Result<Pixels> decodePng(std::span<const uint8_t> bytes, const ImageHeader& header);

// image_webp.cpp, through libwebp: RGB or RGBA; no animations.
bool isWebp(std::span<const uint8_t> bytes);
Result<ImageHeader> readWebpHeader(std::span<const uint8_t> bytes);
Result<Pixels> decodeWebp(std::span<const uint8_t> bytes, const ImageHeader& header);

// image_avif.cpp, through libavif: RGB or RGBA, 16 bits a sample where the file has more than 8.
bool isAvif(std::span<const uint8_t> bytes);
Result<ImageHeader> readAvifHeader(std::span<const uint8_t> bytes);
Result<Pixels> decodeAvif(std::span<const uint8_t> bytes, const ImageHeader& header);

// ktx2/decode.cpp: what its formats hold, as 8-bit or 16-bit RGB or RGBA, all mip levels.
bool isKtx2(std::span<const uint8_t> bytes);
Result<ImageHeader> readKtx2Header(std::span<const uint8_t> bytes);
Result<Pixels> decodeKtx2(std::span<const uint8_t> bytes, const ImageHeader& header);

// "image/png" by what it begins with; empty: none that glTF and its extensions know.
std::string mediaType(std::span<const uint8_t> bytes);

std::string pngText(std::span<const uint8_t> bytes, std::string_view keyword);

// The pixels as files; empty where memory does not do. PNG of 8 or 16 bits a channel, as the pixels have; the others of
// 8. quality: io/picture_file.hpp.
std::vector<uint8_t> pngOf(const Pixels& pixels, std::span<const PngText> texts);
std::vector<uint8_t> jpegOf(const Pixels& pixels, int quality);  // RGB
std::vector<uint8_t> webpOf(const Pixels& pixels, int quality);  // RGB, RGBA
std::vector<uint8_t> avifOf(const Pixels& pixels, int quality);  // RGB, RGBA; canReadAvif()
bool canReadAvif();                                              // its library is installed

}  // namespace facet::io
