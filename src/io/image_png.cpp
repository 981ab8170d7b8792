#include <spng.h>

#include <cstring>
#include <memory>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

// Deflate cannot shrink more than this (zlib's manual: 1032:1).
constexpr uint64_t largestDeflateRatio = 1040;
// Profiles and texts, which nobody here reads: of one chunk, of all together.
constexpr size_t pngChunkBytes = size_t{16} << 20, pngAllChunksBytes = size_t{64} << 20;

struct FreeSpng {
  void operator()(spng_ctx* context) const { spng_ctx_free(context); }
};

struct PngDecoder {
  std::unique_ptr<spng_ctx, FreeSpng> context;
  spng_ihdr header = {};
  spng_format format = SPNG_FMT_PNG;
  bool transparent = false;  // tRNS
  int status = 0;            // of the library; 0: good
};

// Reads all up to the image's data.
PngDecoder openPng(std::span<const uint8_t> bytes, int flags = 0) {
  PngDecoder d{std::unique_ptr<spng_ctx, FreeSpng>(spng_ctx_new(flags))};
  spng_ctx* context = d.context.get();
  if (context == nullptr) throw std::bad_alloc();
  spng_set_crc_action(context, SPNG_CRC_ERROR, SPNG_CRC_DISCARD);
  spng_set_chunk_limits(context, pngChunkBytes, pngAllChunksBytes);
  d.status = spng_set_png_buffer(context, bytes.data(), bytes.size());
  if (d.status == 0) d.status = spng_get_ihdr(context, &d.header);
  if (d.status != 0) return d;
  spng_trns trns;
  const int found = spng_get_trns(context, &trns);
  d.transparent = found == 0;
  if (found != 0 && found != SPNG_ECHUNKAVAIL) d.status = found;
  const bool grey = d.header.color_type == SPNG_COLOR_TYPE_GRAYSCALE, wide = d.header.bit_depth == 16;
  const bool palette = d.header.color_type == SPNG_COLOR_TYPE_INDEXED;
  if (grey) {
    d.format = d.transparent ? (wide ? SPNG_FMT_GA16 : SPNG_FMT_GA8) : (wide ? SPNG_FMT_PNG : SPNG_FMT_G8);
  } else if (d.transparent) {
    d.format = wide ? SPNG_FMT_RGBA16 : SPNG_FMT_RGBA8;
  } else if (palette) {
    d.format = SPNG_FMT_RGB8;
  }
  return d;
}

int pngChannels(const PngDecoder& d) {
  switch (d.header.color_type) {
    case SPNG_COLOR_TYPE_GRAYSCALE:
      return d.transparent ? 2 : 1;
    case SPNG_COLOR_TYPE_GRAYSCALE_ALPHA:
      return 2;
    case SPNG_COLOR_TYPE_TRUECOLOR_ALPHA:
      return 4;
    default:
      return d.transparent ? 4 : 3;
  }
}

}  // namespace

bool isPng(std::span<const uint8_t> bytes) {
  return bytes.size() >= 8 && std::memcmp(bytes.data(), "\x89PNG\r\n\x1a\n", 8) == 0;
}

Result<ImageHeader> readPngHeader(std::span<const uint8_t> bytes) {
  const PngDecoder d = openPng(bytes);
  if (d.status != 0) return damagedHeader();
  ImageHeader header{static_cast<int>(d.header.width), static_cast<int>(d.header.height), pngChannels(d),
                     d.header.bit_depth == 16 ? 2 : 1};
  header.leastBytes = header.pixels() / 8 / largestDeflateRatio;  // 1 bit per pixel is the least
  return header;
}

Result<Pixels> decodePng(std::span<const uint8_t> bytes, const ImageHeader& header) {
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.bytesPerSample = header.bytesPerSample;
  pixels.data.resize(header.pixels() * static_cast<uint64_t>(header.channels * header.bytesPerSample));
  const auto read = [&](int flags) {
    const PngDecoder d = openPng(bytes, flags);
    size_t size = 0;
    int status = d.status != 0 ? d.status : spng_decoded_image_size(d.context.get(), d.format, &size);
    if (status == 0 && size != pixels.data.size()) status = SPNG_EBUFSIZ;
    return status != 0 ? status
                       : spng_decode_image(d.context.get(), pixels.data.data(), size, d.format, SPNG_DECODE_TRNS);
  };
  int status = read(0);
  if (status == SPNG_EIDAT_STREAM) {  // perhaps only the checksum is wrong, as some writers have it
    status = read(SPNG_CTX_IGNORE_ADLER32);
    pixels.flaw = "its checksum does not fit";
  }
  if (status == SPNG_EMEM) throw std::bad_alloc();
  if (status != 0) return damagedImage(spng_strerror(status));
  return pixels;
}

std::string pngText(std::span<const uint8_t> bytes, std::string_view keyword) {
  const PngDecoder d = openPng(bytes);
  uint32_t count = 0;
  if (d.status != 0 || spng_get_text(d.context.get(), nullptr, &count) != 0) return {};
  std::vector<spng_text> texts(count);
  if (spng_get_text(d.context.get(), texts.data(), &count) != 0) return {};
  for (const spng_text& text : texts)
    if (keyword == text.keyword) return {text.text, text.length};
  return {};
}

}  // namespace facet::io
