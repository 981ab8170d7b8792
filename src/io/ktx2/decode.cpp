// KTX2: from the container's levels to pixels.

#include <zlib.h>
#include <zstd.h>

#include <cstring>

#include "io/image_formats.hpp"
#include "io/ktx2/astc.hpp"
#include "io/ktx2/container.hpp"
#include "io/ktx2/etc1s.hpp"
#include "io/ktx2/formats.hpp"

namespace facet::io {

namespace {

using Bytes = std::span<const uint8_t>;

// As WebP's: one colour takes next to no bytes with Zstandard or BasisLZ.
constexpr uint64_t freePixels = uint64_t{1} << 24, pixelsPerByte = 4096;

std::string combined(const std::string& first, const std::string& then) {
  std::string out = then;
  for (char& c : out) {
    const size_t at = std::string("rgba").find(c);
    if (at != std::string::npos) c = first[at];
  }
  return out;
}

// Where the shown red, green, blue and alpha come from in what the format decodes to: its channels' places, then
// KTXswizzle.
std::string shownSwizzle(const Ktx2& ktx, const TexelFormat& format) {
  return combined(format.channelSwizzle, ktx.swizzle);
}

int shownChannels(const Ktx2& ktx, const TexelFormat& format) {
  const std::string swizzle = shownSwizzle(ktx, format);
  if (swizzle == "rgba") return format.channels;
  return swizzle[3] == '1' || (swizzle[3] == 'a' && format.channels == 3) ? 3 : 4;
}

// One level's bytes without supercompression (schemes 2 and 3), into `storage` where they are not there already.
Result<Bytes> inflated(const Ktx2& ktx, const Ktx2Level& level, uint64_t wanted, std::vector<uint8_t>& storage) {
  if (ktx.scheme == Supercompression::none) {
    if (level.bytes.size() < wanted) return damagedImage("it is too short");
    return level.bytes.first(static_cast<size_t>(wanted));
  }
  if (level.uncompressedLength != wanted) return damagedImage("its level's length is not that of its size");
  storage.resize(static_cast<size_t>(wanted));
  if (ktx.scheme == Supercompression::zstandard) {
    const size_t got = ZSTD_decompress(storage.data(), storage.size(), level.bytes.data(), level.bytes.size());
    if (ZSTD_isError(got)) return damagedImage(std::string("its Zstandard data: ") + ZSTD_getErrorName(got));
    if (got != wanted) return damagedImage("its Zstandard data is too short");
    return Bytes(storage);
  }
  uLongf got = static_cast<uLongf>(wanted);
  const int status = uncompress(storage.data(), &got, level.bytes.data(), static_cast<uLong>(level.bytes.size()));
  if (status == Z_MEM_ERROR) throw std::bad_alloc();
  if (status != Z_OK || got != wanted) return damagedImage("its ZLIB data is faulty or too short");
  return Bytes(storage);
}

// Plain samples; a channel that is not stored is 0.
void unpackSamples(Bytes level, const TexelFormat& format, std::vector<uint8_t>& out) {
  const auto sample = static_cast<size_t>(format.bytesPerSample), stored = static_cast<size_t>(format.storedChannels),
             channels = static_cast<size_t>(format.channels);
  for (size_t from = 0, to = 0; to < out.size(); from += stored * sample, to += channels * sample) {
    for (size_t c = 0; c < stored; ++c) {
      const size_t target = format.bgr && c < 3 ? 2 - c : c;
      std::memcpy(&out[to + target * sample], &level[from + c * sample], sample);
    }
  }
}

std::vector<uint8_t> swizzled(const std::vector<uint8_t>& texels, int from, int to, int bytesPerSample,
                              const std::string& swizzle) {
  const auto sample = static_cast<size_t>(bytesPerSample), stride = static_cast<size_t>(from) * sample;
  const auto channels = static_cast<size_t>(to);
  std::vector<uint8_t> out(texels.size() / stride * channels * sample);
  for (size_t in = 0, at = 0; in < texels.size(); in += stride) {
    for (size_t c = 0; c < channels; ++c, at += sample) {
      const size_t source = std::string_view("rgba").find(swizzle[c]);
      if (source < static_cast<size_t>(from))
        std::memcpy(&out[at], &texels[in + source * sample], sample);
      else  // 0, 1, or the alpha of texels that have none
        std::memset(&out[at], swizzle[c] == '0' ? 0 : 255, sample);
    }
  }
  return out;
}

// Blocks of 4 x 4 texels; the number of those that are none.
size_t unpackBlocks(Bytes level, const TexelFormat& format, int width, int height, std::vector<uint8_t>& out) {
  const auto channels = static_cast<size_t>(format.channels), w = static_cast<size_t>(width),
             h = static_cast<size_t>(height), bytes = static_cast<size_t>(format.blockBytes);
  size_t faulty = 0;
  const uint8_t* block = level.data();
  uint8_t rgba[64];
  for (size_t top = 0; top < h; top += 4) {
    for (size_t left = 0; left < w; left += 4, block += bytes) {
      if (!format.decodeBlock(block, rgba)) {
        constexpr uint8_t magenta[] = {255, 0, 255, 255};
        for (size_t i = 0; i < 16; ++i) std::memcpy(rgba + 4 * i, magenta, 4);
        ++faulty;
      }
      for (size_t y = top; y < std::min(top + 4, h); ++y)
        for (size_t x = left; x < std::min(left + 4, w); ++x)
          std::memcpy(&out[(y * w + x) * channels], rgba + 4 * (4 * (y - top) + x - left), channels);
    }
  }
  return faulty;
}

struct Source {
  Ktx2 ktx;
  TexelFormat format;
  Etc1s etc1s;  // of BasisLZ
};

// Appends to the flaw what is wrong with blocks of the level.
Result<std::vector<uint8_t>> decodeLevel(const Source& from, size_t level, int channels, std::string& flaw) {
  const Ktx2& ktx = from.ktx;
  const TexelFormat& format = from.format;
  const int width = levelSide(ktx.width, level), height = levelSide(ktx.height, level);
  const auto texels = static_cast<size_t>(width) * static_cast<size_t>(height);
  std::vector<uint8_t> out(texels * static_cast<size_t>(format.channels * format.bytesPerSample));
  if (ktx.scheme == Supercompression::basisLz) {
    if (auto ok = decodeEtc1sLevel(from.etc1s, ktx, level, format.channels, out.data()); !ok)
      return tl::unexpected(ok.error());
  } else {
    std::vector<uint8_t> storage;
    const auto bytes = inflated(ktx, ktx.levels[level], levelBytes(format, width, height), storage);
    if (!bytes) return tl::unexpected(bytes.error());
    if (format.astc) {
      if (auto ok = decodeAstc(*bytes, format.blockWidth, format.blockHeight, format.srgb, width, height, out.data());
          !ok)
        return tl::unexpected(ok.error());
    } else if (format.decodeBlock == nullptr) {
      unpackSamples(*bytes, format, out);
    } else if (const size_t faulty = unpackBlocks(*bytes, format, width, height, out); faulty > 0 && flaw.empty()) {
      flaw = std::to_string(faulty) + " of the blocks of its mip level " + std::to_string(level) + " are not " +
             format.name + ", and are shown in magenta";
    }
  }
  const std::string swizzle = shownSwizzle(ktx, format);
  if (swizzle == "rgba") return out;
  return swizzled(out, format.channels, channels, format.bytesPerSample, swizzle);
}

}  // namespace

Result<ImageHeader> readKtx2Header(Bytes bytes) {
  const auto ktx = readContainer(bytes);
  if (!ktx) return tl::unexpected(ktx.error());
  const auto format = texelFormat(*ktx);
  if (!format) return tl::unexpected(format.error());
  ImageHeader header{ktx->width, ktx->height, shownChannels(*ktx, *format), format->bytesPerSample};
  constexpr const char* schemes[] = {"", ", BasisLZ", ", Zstandard", ", ZLIB"};
  header.texels = format->name + schemes[static_cast<uint32_t>(ktx->scheme)];
  header.levels = static_cast<int>(ktx->levels.size());
  if (ktx->scheme == Supercompression::none)
    header.leastBytes = levelBytes(*format, ktx->width, ktx->height);
  else if (header.pixels() > freePixels)
    header.leastBytes = header.pixels() / pixelsPerByte;
  return header;
}

Result<Pixels> decodeKtx2(Bytes bytes, const ImageHeader& header) {
  auto ktx = readContainer(bytes);
  if (!ktx) return tl::unexpected(ktx.error());
  const auto format = texelFormat(*ktx);
  if (!format) return tl::unexpected(format.error());
  Source from{std::move(*ktx), *format, {}};
  if (from.ktx.scheme == Supercompression::basisLz) {
    auto etc1s = readEtc1s(from.ktx);
    if (!etc1s) return tl::unexpected(etc1s.error());
    from.etc1s = std::move(*etc1s);
  }
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.bytesPerSample = header.bytesPerSample;
  pixels.remarks = from.ktx.remarks;
  const bool srgb = format->srgb || from.ktx.transfer == static_cast<uint8_t>(Transfer::srgb);
  if (srgb || from.ktx.transfer == static_cast<uint8_t>(Transfer::linear))
    pixels.transfer = srgb ? Pixels::Transfer::srgb : Pixels::Transfer::linear;
  for (size_t i = 0; i < from.ktx.levels.size(); ++i) {
    auto level = decodeLevel(from, i, header.channels, pixels.flaw);
    if (!level && i == 0) return tl::unexpected(level.error());
    if (!level) {  // it and those below can be made from the one above
      pixels.flaw = "its mip level " + std::to_string(i) + " cannot be read";
      break;
    }
    i == 0 ? void(pixels.data = std::move(*level)) : pixels.levels.push_back(std::move(*level));
  }
  return pixels;
}

}  // namespace facet::io
