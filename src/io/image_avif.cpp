#include <avif/avif.h>
#include <dlfcn.h>

#include <cstring>
#include <memory>
#include <new>
#include <optional>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

// Beyond, the header says what no picture needs; image.cpp has the limits that count.
constexpr uint32_t mostAvifPixels = 16384 * 16384;

// What is called of libavif, which no start without an AVIF waits for.
struct AvifLibrary {
  decltype(&avifDecoderCreate) decoderCreate = nullptr;
  decltype(&avifDecoderDestroy) decoderDestroy = nullptr;
  decltype(&avifCodecName) codecName = nullptr;
  decltype(&avifDecoderSetIOMemory) decoderSetIOMemory = nullptr;
  decltype(&avifDecoderParse) decoderParse = nullptr;
  decltype(&avifDecoderNextImage) decoderNextImage = nullptr;
  decltype(&avifResultToString) resultToString = nullptr;
  decltype(&avifRGBImageSetDefaults) rgbSetDefaults = nullptr;
  decltype(&avifImageYUVToRGB) yuvToRGB = nullptr;
  decltype(&avifImageRGBToYUV) rgbToYUV = nullptr;
  decltype(&avifImageCreate) imageCreate = nullptr;
  decltype(&avifImageDestroy) imageDestroy = nullptr;
  decltype(&avifEncoderCreate) encoderCreate = nullptr;
  decltype(&avifEncoderWrite) encoderWrite = nullptr;
  decltype(&avifEncoderDestroy) encoderDestroy = nullptr;
  decltype(&avifRWDataFree) dataFree = nullptr;
};

template <class Function>
bool find(void* library, const char* name, Function& function) {
  return (function = reinterpret_cast<Function>(dlsym(library, name))) != nullptr;
}

// Null: it is not installed. It stays loaded.
const AvifLibrary* avif() {
  static const std::optional<AvifLibrary> loaded = []() -> std::optional<AvifLibrary> {
    void* library = dlopen(FACET_AVIF_LIBRARY, RTLD_LAZY | RTLD_LOCAL);
    AvifLibrary f;
    const bool whole =
        library && find(library, "avifDecoderCreate", f.decoderCreate) &&
        find(library, "avifDecoderDestroy", f.decoderDestroy) && find(library, "avifCodecName", f.codecName) &&
        find(library, "avifDecoderSetIOMemory", f.decoderSetIOMemory) &&
        find(library, "avifDecoderParse", f.decoderParse) &&
        find(library, "avifDecoderNextImage", f.decoderNextImage) &&
        find(library, "avifResultToString", f.resultToString) &&
        find(library, "avifRGBImageSetDefaults", f.rgbSetDefaults) && find(library, "avifImageYUVToRGB", f.yuvToRGB) &&
        find(library, "avifImageRGBToYUV", f.rgbToYUV) && find(library, "avifImageCreate", f.imageCreate) &&
        find(library, "avifImageDestroy", f.imageDestroy) && find(library, "avifEncoderCreate", f.encoderCreate) &&
        find(library, "avifEncoderWrite", f.encoderWrite) && find(library, "avifEncoderDestroy", f.encoderDestroy) &&
        find(library, "avifRWDataFree", f.dataFree);
    return whole ? std::optional(f) : std::nullopt;
  }();
  return loaded ? &*loaded : nullptr;
}

tl::unexpected<Error> noAvif() {
  return fail({}, {}, "this is AVIF, and " FACET_AVIF_LIBRARY " is not installed", "install it, or make it a PNG");
}

struct FreeAvif {
  void operator()(avifDecoder* decoder) const { avif()->decoderDestroy(decoder); }
};
using AvifDecoder = std::unique_ptr<avifDecoder, FreeAvif>;

// Reads all but the picture's data. What the strict flags refuse are lacks that no picture shows.
AvifDecoder openAvif(std::span<const uint8_t> bytes, avifResult& result) {
  AvifDecoder decoder(avif()->decoderCreate());
  if (!decoder) throw std::bad_alloc();
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  // dav1d, which would be taken first, prints what it finds wrong.
  if (avif()->codecName(AVIF_CODEC_CHOICE_AOM, AVIF_CODEC_FLAG_CAN_DECODE))
    decoder->codecChoice = AVIF_CODEC_CHOICE_AOM;
  decoder->imageSizeLimit = mostAvifPixels;
  decoder->strictFlags = AVIF_STRICT_DISABLED;
  result = avif()->decoderSetIOMemory(decoder.get(), bytes.data(), bytes.size());
  if (result == AVIF_RESULT_OK) result = avif()->decoderParse(decoder.get());
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
  if (!avif()) return noAvif();
  avifResult result = AVIF_RESULT_OK;
  const AvifDecoder decoder = openAvif(bytes, result);
  if (result != AVIF_RESULT_OK || decoder->image->width == 0 || decoder->image->height == 0) return damagedHeader();
  ImageHeader header{static_cast<int>(decoder->image->width), static_cast<int>(decoder->image->height),
                     decoder->alphaPresent ? 4 : 3};
  header.bytesPerSample = decoder->image->depth > 8 ? 2 : 1;
  return header;
}

Result<Pixels> decodeAvif(std::span<const uint8_t> bytes, const ImageHeader& header) {
  if (!avif()) return noAvif();
  avifResult result = AVIF_RESULT_OK;
  const AvifDecoder decoder = openAvif(bytes, result);
  if (result == AVIF_RESULT_OK) result = avif()->decoderNextImage(decoder.get());
  if (result != AVIF_RESULT_OK) return damagedImage(std::string("its AVIF data: ") + avif()->resultToString(result));
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
  avif()->rgbSetDefaults(&rgb, decoder->image);
  rgb.format = header.channels == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.depth = header.bytesPerSample == 2 ? 16 : 8;
  rgb.pixels = pixels.data.data();
  rgb.rowBytes = static_cast<uint32_t>(rowBytes);
  result = avif()->yuvToRGB(decoder->image, &rgb);
  if (result != AVIF_RESULT_OK) return damagedImage(std::string("its AVIF data: ") + avif()->resultToString(result));
  return pixels;
}

bool canReadAvif() { return avif() != nullptr; }

std::vector<uint8_t> avifOf(const Pixels& pixels, int quality) {
  const bool lossless = quality == 100;
  const std::unique_ptr<avifImage, decltype(&avifImageDestroy)> image(
      avif()->imageCreate(static_cast<uint32_t>(pixels.width), static_cast<uint32_t>(pixels.height), 8,
                          AVIF_PIXEL_FORMAT_YUV444),
      avif()->imageDestroy);
  const std::unique_ptr<avifEncoder, decltype(&avifEncoderDestroy)> encoder(avif()->encoderCreate(),
                                                                            avif()->encoderDestroy);
  if (!image || !encoder) throw std::bad_alloc();
  image->colorPrimaries = AVIF_COLOR_PRIMARIES_BT709;
  image->transferCharacteristics = AVIF_TRANSFER_CHARACTERISTICS_SRGB;
  // Green, blue and red as they are, where nothing may be lost.
  image->matrixCoefficients = lossless ? AVIF_MATRIX_COEFFICIENTS_IDENTITY : AVIF_MATRIX_COEFFICIENTS_BT601;
  image->yuvRange = AVIF_RANGE_FULL;
  avifRGBImage rgb;
  avif()->rgbSetDefaults(&rgb, image.get());
  rgb.format = pixels.channels == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.depth = 8;
  rgb.pixels = const_cast<uint8_t*>(pixels.data.data());
  rgb.rowBytes = static_cast<uint32_t>(pixels.width * pixels.channels);
  if (avif()->rgbToYUV(image.get(), &rgb) != AVIF_RESULT_OK) return {};
  encoder->codecChoice = AVIF_CODEC_CHOICE_AOM;
  encoder->speed = 8;
  encoder->maxThreads = 1;  // the same bytes on all machines
  encoder->minQuantizer = encoder->maxQuantizer = AVIF_QUANTIZER_WORST_QUALITY * (100 - quality) / 100;
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = AVIF_QUANTIZER_BEST_QUALITY;
  avifRWData data = AVIF_DATA_EMPTY;
  const avifResult result = avif()->encoderWrite(encoder.get(), image.get(), &data);
  const std::unique_ptr<avifRWData, decltype(&avifRWDataFree)> freed(&data, avif()->dataFree);
  return result == AVIF_RESULT_OK ? std::vector<uint8_t>(data.data, data.data + data.size) : std::vector<uint8_t>();
}

}  // namespace facet::io
