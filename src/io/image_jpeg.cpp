#include <turbojpeg.h>

#include <algorithm>
#include <cstring>
#include <memory>

#include "io/image_formats.hpp"

namespace facet::io {

namespace {

// A block of 8 x 8 samples takes a bit at least.
constexpr uint64_t pixelsPerByte = 512;

struct DestroyJpeg {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using JpegHandle = std::unique_ptr<void, DestroyJpeg>;

JpegHandle makeJpegDecoder() {
  JpegHandle handle(tjInitDecompress());
  if (!handle) throw std::bad_alloc();
  return handle;
}

// As Adobe stores them: 255 is no ink.
std::vector<uint8_t> rgbOfInks(const std::vector<uint8_t>& cmyk) {
  std::vector<uint8_t> rgb(cmyk.size() / 4 * 3);
  for (size_t i = 0; i < cmyk.size() / 4; ++i)
    for (size_t c = 0; c < 3; ++c)
      rgb[3 * i + c] = static_cast<uint8_t>((cmyk[4 * i + c] * cmyk[4 * i + 3] + 127) / 255);
  return rgb;
}

struct JpegFrame {
  ImageHeader header;
  bool inks = false;
};

Result<JpegFrame> readJpegFrame(void* handle, std::span<const uint8_t> bytes) {
  int width = 0, height = 0, sampling = -1, space = -1;
  // It also fails where it has no name for the sampling, which decoding does not need.
  tjDecompressHeader3(handle, bytes.data(), static_cast<unsigned long>(bytes.size()), &width, &height, &sampling,
                      &space);
  if (width <= 0 || height <= 0 || space < 0) return damagedHeader();
  JpegFrame frame{{width, height, space == TJCS_GRAY ? 1 : 3}, space == TJCS_CMYK || space == TJCS_YCCK};
  return frame;
}

}  // namespace

bool isJpeg(std::span<const uint8_t> bytes) {
  return bytes.size() >= 3 && std::memcmp(bytes.data(), "\xff\xd8\xff", 3) == 0;
}

Result<ImageHeader> readJpegHeader(std::span<const uint8_t> bytes) {
  const JpegHandle handle = makeJpegDecoder();
  const auto frame = readJpegFrame(handle.get(), bytes);
  if (!frame) return tl::unexpected(frame.error());
  ImageHeader header = frame->header;
  header.leastBytes = header.pixels() / pixelsPerByte;
  // Within entropy-coded data each ff is followed by 0, so this counts too many only by what a profile or a thumbnail
  // holds.
  const uint8_t scan[] = {0xff, 0xda};
  const auto end = bytes.end();
  header.passes = 0;
  for (auto at = bytes.begin(); (at = std::search(at, end, std::begin(scan), std::end(scan))) != end; ++at)
    ++header.passes;
  return header;
}

Result<Pixels> decodeJpeg(std::span<const uint8_t> bytes, const ImageHeader& header) {
  const JpegHandle handle = makeJpegDecoder();
  const auto frame = readJpegFrame(handle.get(), bytes);
  if (!frame) return tl::unexpected(frame.error());
  if (frame->header.width != header.width || frame->header.height != header.height ||
      frame->header.channels != header.channels)
    return damagedImage("its size changes");
  Pixels pixels;
  pixels.width = header.width;
  pixels.height = header.height;
  pixels.channels = header.channels;
  pixels.data.resize(header.pixels() * static_cast<uint64_t>(frame->inks ? 4 : header.channels));
  const int format = frame->inks ? TJPF_CMYK : header.channels == 1 ? TJPF_GRAY : TJPF_RGB;
  const int status =
      tjDecompress2(handle.get(), bytes.data(), static_cast<unsigned long>(bytes.size()), pixels.data.data(),
                    header.width, 0, header.height, format, TJFLAG_ACCURATEDCT | TJFLAG_LIMITSCANS);
  if (status != 0) {
    const std::string reason = tjGetErrorStr2(handle.get());
    if (tjGetErrorCode(handle.get()) != TJERR_WARNING) return damagedImage(reason);
    pixels.flaw = reason;
  }
  if (frame->inks) pixels.data = rgbOfInks(pixels.data);
  return pixels;
}

std::vector<uint8_t> jpegOf(const Pixels& pixels, int quality) {
  const JpegHandle handle(tjInitCompress());
  if (!handle) throw std::bad_alloc();
  constexpr int fine = 90;  // from here on colours are not subsampled
  const int sampling = quality >= fine ? TJSAMP_444 : TJSAMP_420;
  unsigned long size = tjBufSize(pixels.width, pixels.height, sampling);
  if (size == static_cast<unsigned long>(-1)) return {};
  std::vector<uint8_t> bytes(size);
  uint8_t* into = bytes.data();
  const int status = tjCompress2(handle.get(), pixels.data.data(), pixels.width, 0, pixels.height, TJPF_RGB, &into,
                                 &size, sampling, quality, TJFLAG_NOREALLOC | TJFLAG_ACCURATEDCT);
  bytes.resize(status == 0 ? size : 0);
  return bytes;
}

}  // namespace facet::io
