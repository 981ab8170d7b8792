#include <avif/avif.h>

#include <cstring>
#include <memory>
#include <new>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

// Beyond, the header says what no picture needs; image.cpp has the limits that count.
constexpr uint32_t mostAvifPixels = 16384 * 16384;

struct FreeAvif {
  void operator()(avifDecoder* decoder) const { avifDecoderDestroy(decoder); }
};
using AvifDecoder = std::unique_ptr<avifDecoder, FreeAvif>;

// Reads all but the picture's data. What the strict flags refuse are lacks that no picture shows.
AvifDecoder openAvif(std::span<const uint8_t> bytes, avifResult& result) {
  AvifDecoder decoder(avifDecoderCreate());
  if (!decoder) throw std::bad_alloc();
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  // dav1d, which would be taken first, prints what it finds wrong.
  if (avifCodecName(AVIF_CODEC_CHOICE_AOM, AVIF_CODEC_FLAG_CAN_DECODE)) decoder->codecChoice = AVIF_CODEC_CHOICE_AOM;
  decoder->imageSizeLimit = mostAvifPixels;
  decoder->strictFlags = AVIF_STRICT_DISABLED;
  result = avifDecoderSetIOMemory(decoder.get(), bytes.data(), bytes.size());
  if (result == AVIF_RESULT_OK) result = avifDecoderParse(decoder.get());
  return decoder;
}

// What its header says that glTF has no place for (EXT_texture_avif: readers treat texels as those of a PNG).
std::vector<std::string> remarksOn(const avifImage& image) {
  std::vector<std::string> remarks;
  const auto p = image.colorPrimaries;
  if (p != AVIF_COLOR_PRIMARIES_BT709 && p != AVIF_COLOR_PRIMARIES_UNSPECIFIED && p != AVIF_COLOR_PRIMARIES_UNKNOWN)
    remarks.emplace_back("its primaries are not those of Rec. 709, but taken as such");
  const auto t = image.transferCharacteristics;
  if (t == AVIF_TRANSFER_CHARACTERISTICS_SMPTE2084 || t == AVIF_TRANSFER_CHARACTERISTICS_HLG)
    remarks.emplace_back("its curve is one for high dynamic range, but shown as sRGB");
  if (image.transformFlags & (AVIF_TRANSFORM_IROT | AVIF_TRANSFORM_IMIR))
    remarks.emplace_back("the turn or mirroring that it asks for is not applied");
  if (image.alphaPremultiplied) remarks.emplace_back("its alpha was multiplied in, and is divided out again");
  return remarks;
}

}  // namespace

bool isAvif(std::span<const uint8_t> bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data() + 4, "ftypavif", 8) == 0;
}

Result<ImageHeader> readAvifHeader(std::span<const uint8_t> bytes) {
  avifResult result = AVIF_RESULT_OK;
  const AvifDecoder decoder = openAvif(bytes, result);
  if (result != AVIF_RESULT_OK || decoder->image->width == 0 || decoder->image->height == 0) return damagedHeader();
  ImageHeader header{static_cast<int>(decoder->image->width), static_cast<int>(decoder->image->height),
                     decoder->alphaPresent ? 4 : 3};
  header.bytesPerSample = decoder->image->depth > 8 ? 2 : 1;
  return header;
}

Result<Pixels> decodeAvif(std::span<const uint8_t> bytes, const ImageHeader& header) {
  avifResult result = AVIF_RESULT_OK;
  const AvifDecoder decoder = openAvif(bytes, result);
  if (result == AVIF_RESULT_OK) result = avifDecoderNextImage(decoder.get());
  if (result != AVIF_RESULT_OK) return damagedImage(std::string("its AVIF data: ") + avifResultToString(result));
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.bytesPerSample = header.bytesPerSample;
  const uint64_t rowBytes =
      static_cast<uint64_t>(header.width) * static_cast<uint64_t>(header.channels * header.bytesPerSample);
  pixels.data.resize(rowBytes * static_cast<uint64_t>(header.height));
  if (decoder->image->width != static_cast<uint32_t>(header.width) ||
      decoder->image->height != static_cast<uint32_t>(header.height))
    return damagedImage("its size is not that of its header");
  pixels.remarks = remarksOn(*decoder->image);
  avifRGBImage rgb;
  avifRGBImageSetDefaults(&rgb, decoder->image);
  rgb.format = header.channels == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.depth = header.bytesPerSample == 2 ? 16 : 8;
  rgb.pixels = pixels.data.data();
  rgb.rowBytes = static_cast<uint32_t>(rowBytes);
  result = avifImageYUVToRGB(decoder->image, &rgb);
  if (result != AVIF_RESULT_OK) return damagedImage(std::string("its AVIF data: ") + avifResultToString(result));
  return pixels;
}

}  // namespace facet::io
