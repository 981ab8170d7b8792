#include <avif/avif.h>
#include <turbojpeg.h>
#include <webp/encode.h>

#include <string>

#include "fuzz/seeds.hpp"
#include "support/gltf_builder.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"

namespace facet::fuzz {

std::vector<Bytes> pngSeeds() {
  std::vector<Bytes> out;
  for (const int channels : {1, 2, 3, 4})
    for (const int bits : {8, 16})
      out.push_back(test::pngBytes(3, 2, channels, bits, ramp(static_cast<size_t>(6 * channels * bits / 8))));
  return out;
}

std::vector<Bytes> jpegSeeds() {
  std::vector<Bytes> out;
  tjhandle handle = tjInitCompress();
  const Bytes pixels = ramp(size_t{24} * 17 * 4, 11);
  const auto add = [&](int format, int sampling, int flags) {
    unsigned char* data = nullptr;
    unsigned long size = 0;
    if (tjCompress2(handle, pixels.data(), 24, 0, 17, format, &data, &size, sampling, 60, flags) == 0)
      out.emplace_back(data, data + size);
    tjFree(data);
  };
  for (const int sampling : {TJSAMP_444, TJSAMP_420, TJSAMP_GRAY}) add(TJPF_RGB, sampling, 0);
  add(TJPF_RGB, TJSAMP_422, TJFLAG_PROGRESSIVE);
  add(TJPF_CMYK, TJSAMP_444, 0);
  tjDestroy(handle);
  return out;
}

std::vector<Bytes> webpSeeds() {
  std::vector<Bytes> out;
  const Bytes pixels = ramp(size_t{20} * 13 * 4, 11);
  const auto add = [&](auto encode, int channels, auto... quality) {
    uint8_t* data = nullptr;
    const size_t size = encode(pixels.data(), 20, 13, 20 * channels, quality..., &data);
    out.emplace_back(data, data + size);
    WebPFree(data);
  };
  add(WebPEncodeLosslessRGB, 3), add(WebPEncodeLosslessRGBA, 4);
  add(WebPEncodeRGB, 3, 50.0f), add(WebPEncodeRGBA, 4, 50.0f);
  return out;
}

// None where libavif has no encoder.
std::vector<Bytes> avifSeeds() {
  std::vector<Bytes> out;
  for (const int depth : {8, 10})
    for (const auto format : {AVIF_PIXEL_FORMAT_YUV444, AVIF_PIXEL_FORMAT_YUV420, AVIF_PIXEL_FORMAT_YUV400}) {
      const bool alpha = format == AVIF_PIXEL_FORMAT_YUV420;
      Bytes pixels = ramp(size_t{12} * 10 * (alpha ? 4 : 3) * (depth > 8 ? 2 : 1), 11);
      if (depth > 8)
        for (size_t i = 1; i < pixels.size(); i += 2) pixels[i] &= 3;
      avifImage* image = avifImageCreate(12, 10, depth, format);
      avifRGBImage rgb;
      avifRGBImageSetDefaults(&rgb, image);
      rgb.format = alpha ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
      rgb.pixels = pixels.data(), rgb.rowBytes = static_cast<uint32_t>(pixels.size() / 10);
      avifEncoder* encoder = avifEncoderCreate();
      encoder->speed = 10;
      avifRWData data = AVIF_DATA_EMPTY;
      if (avifImageRGBToYUV(image, &rgb) == AVIF_RESULT_OK && avifEncoderWrite(encoder, image, &data) == AVIF_RESULT_OK)
        out.emplace_back(data.data, data.data + data.size);
      avifRWDataFree(&data);
      avifEncoderDestroy(encoder);
      avifImageDestroy(image);
    }
  return out;
}

std::vector<Bytes> ktx2Seeds() {
  std::vector<Bytes> out;
  for (const std::string_view hex :
       {test::etc1sOpaque, test::etc1sAlpha, test::uastcAlpha, test::uastcRamps, test::etc1sRamps})
    out.push_back(test::fromHex(hex));
  const auto add = [&](uint32_t format, size_t blockBytes, int width, int height, uint8_t model) {
    test::Ktx2File file;
    file.vkFormat = format, file.model = model;
    file.width = static_cast<uint32_t>(width), file.height = static_cast<uint32_t>(height);
    file.levels = {ramp(blockBytes)};
    out.push_back(file.bytes());
    file.uncompressed = {blockBytes};
    file.scheme = 2, file.levels = {test::zstandard(ramp(blockBytes))};
    out.push_back(file.bytes());
    file.scheme = 3, file.levels = {test::zlibDeflated(ramp(blockBytes))};
    out.push_back(file.bytes());
  };
  add(37, 3 * 2 * 4, 3, 2, 1);                                                        // RGBA8
  for (const uint32_t format : {131u, 133u, 139u}) add(format, 8, 4, 4, 128);         // BC1, BC1 with alpha, BC4
  for (const uint32_t format : {135u, 137u, 141u, 145u}) add(format, 16, 4, 4, 128);  // BC2, BC3, BC5, BC7
  for (const uint32_t format : {147u, 149u, 153u}) add(format, 8, 4, 4, 161);         // ETC2, EAC
  for (const uint32_t format : {151u, 155u}) add(format, 16, 4, 4, 161);
  for (const uint32_t format : {157u, 171u}) add(format, 16, 4, 4, 162);  // ASTC 4 x 4, 8 x 8
  return out;
}

std::vector<Bytes> hdrSeeds() {
  const std::string magic = "#?RADIANCE\n", format = "FORMAT=32-bit_rle_rgbe\n";
  const auto file = [&](const std::string& header, const Bytes& data) {
    Bytes out = bytesOf(header);
    out.insert(out.end(), data.begin(), data.end());
    return out;
  };
  Bytes runs;
  for (int row = 0; row < 2; ++row) {
    runs.insert(runs.end(), {2, 2, 0, 9});
    for (int plane = 0; plane < 4; ++plane) runs.insert(runs.end(), {128 + 5, 130, 4, 1, 2, 3, 4});
  }
  Bytes old = ramp(16);
  old.insert(old.end(), {1, 1, 1, 4});
  return {file(magic + format + "\n-Y 2 +X 9\n", runs),
          file(magic + format +
                   "EXPOSURE=2\nCOLORCORR=1 2 3\nPRIMARIES=0.64 0.33 0.3 0.6 0.15 0.06 0.31 0.33\n\n-Y 2 +X 4\n",
               old),
          file(magic + "FORMAT=32-bit_rle_xyze\n\n+X 2 -Y 2\n", ramp(16)),
          file("#?RGBE\n" + format + "\n+Y 2 -X 2\n", ramp(16))};
}

}  // namespace facet::fuzz
