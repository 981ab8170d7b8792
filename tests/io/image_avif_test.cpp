#include <avif/avif.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>

#include "io/image.hpp"
#include "support/gltf_load.hpp"

using namespace facet;

namespace {

using Bytes = std::vector<uint8_t>;

struct AvifMade {
  int channels = 3, depth = 8;
  avifColorPrimaries primaries = AVIF_COLOR_PRIMARIES_BT709;
};

// Lossless: the planes are green, blue and red themselves. Empty where libavif can't write.
Bytes avifBytes(uint32_t width, uint32_t height, const AvifMade& made, Bytes data) {
  const std::unique_ptr<avifImage, decltype(&avifImageDestroy)> image(
      avifImageCreate(int(width), int(height), made.depth, AVIF_PIXEL_FORMAT_YUV444), avifImageDestroy);
  image->matrixCoefficients = AVIF_MATRIX_COEFFICIENTS_IDENTITY;
  image->colorPrimaries = made.primaries;
  image->transferCharacteristics = AVIF_TRANSFER_CHARACTERISTICS_SRGB;
  avifRGBImage rgb;
  avifRGBImageSetDefaults(&rgb, image.get());
  rgb.format = made.channels == 4 ? AVIF_RGB_FORMAT_RGBA : AVIF_RGB_FORMAT_RGB;
  rgb.depth = uint32_t(made.depth);
  rgb.pixels = data.data();
  rgb.rowBytes = width * uint32_t(made.channels) * (made.depth > 8 ? 2 : 1);
  const std::unique_ptr<avifEncoder, decltype(&avifEncoderDestroy)> encoder(avifEncoderCreate(), avifEncoderDestroy);
  encoder->minQuantizer = encoder->maxQuantizer = AVIF_QUANTIZER_LOSSLESS;
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = AVIF_QUANTIZER_LOSSLESS;
  encoder->speed = 10;
  avifRWData out = AVIF_DATA_EMPTY;
  const bool written = avifImageRGBToYUV(image.get(), &rgb) == AVIF_RESULT_OK &&
                       avifEncoderWrite(encoder.get(), image.get(), &out) == AVIF_RESULT_OK;
  const Bytes bytes = written ? Bytes(out.data, out.data + out.size) : Bytes();
  avifRWDataFree(&out);
  return bytes;
}

Bytes avifSamples(size_t count) {
  Bytes data(count);
  for (size_t i = 0; i < count; ++i) data[i] = static_cast<uint8_t>(1 + 37 * i % 255);
  return data;
}

std::string decodeAvifText(const Bytes& bytes, const io::Limits& limits = {}) {
  const auto pixels = io::decodeImage(bytes, "i", limits);
  return pixels ? "decoded" : describe(pixels.error());
}

}  // namespace

TEST_CASE("AVIF, RGB and RGBA", "[io][image]") {
  for (const int channels : {3, 4}) {
    const Bytes data = avifSamples(static_cast<size_t>(8 * 6 * channels));
    const auto pixels = io::decodeImage(avifBytes(8, 6, {.channels = channels}, data), "i");
    REQUIRE(pixels);
    CHECK(pixels->width == 8);
    CHECK(pixels->height == 6);
    CHECK(pixels->channels == channels);
    CHECK(pixels->bytesPerSample == 1);
    CHECK(pixels->data == data);
    CHECK(pixels->remarks.empty());
  }
}

TEST_CASE("AVIF of 10 bits becomes 16", "[io][image]") {
  std::vector<uint16_t> values(4 * 4 * 3);
  for (size_t i = 0; i < values.size(); ++i) values[i] = static_cast<uint16_t>(21 * i);
  const auto* bytes = reinterpret_cast<const uint8_t*>(values.data());
  const auto pixels = io::decodeImage(avifBytes(4, 4, {.depth = 10}, {bytes, bytes + 2 * values.size()}), "i");
  REQUIRE(pixels);
  REQUIRE(pixels->bytesPerSample == 2);
  for (size_t i = 0; i < values.size(); ++i) {
    uint16_t got = 0;
    std::memcpy(&got, &pixels->data[2 * i], 2);
    CHECK(std::abs(got - 65535.0 * values[i] / 1023) <= 1);
  }
}

TEST_CASE("Faulty AVIF says why", "[io][image]") {
  const Bytes good = avifBytes(16, 16, {}, avifSamples(16 * 16 * 3));
  CHECK(decodeAvifText(Bytes(good.begin(), good.begin() + 40)) == "i: the image's header is damaged; save it again.");
  CHECK_THAT(decodeAvifText(Bytes(good.begin(), good.end() - 40)), Catch::Contains("damaged"));
  io::Limits limits;
  limits.imagePixels = 255;
  CHECK(decodeAvifText(good, limits) ==
        "i: the image has 16 x 16 pixels, more than the limit of 255; use a smaller image.");
  const auto wide = io::decodeImage(avifBytes(4, 4, {.primaries = AVIF_COLOR_PRIMARIES_BT2020}, avifSamples(48)), "i");
  REQUIRE(wide);
  CHECK(wide->remarks == std::vector<std::string>{"its primaries are not those of Rec. 709, but taken as such"});
  for (size_t i = 0; i < good.size(); ++i) {  // one wrong byte is no fault of ours
    Bytes bad = good;
    bad[i] ^= 0x5A;
    decodeAvifText(bad);
  }
}

TEST_CASE("EXT_texture_avif: its image, else the core's", "[io][gltf]") {
  test::GltfBuilder b = test::triangle();
  b.append("images", {{"uri", test::dataUri(avifBytes(4, 4, {}, avifSamples(48)), "image/avif")}});
  b.append("images", {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, Bytes(3, 9)), "image/png")}});
  b.append("textures", {{"source", 1}, {"extensions", {{"EXT_texture_avif", {{"source", 0}}}}}});
  b.json["extensionsUsed"] = {"EXT_texture_avif"};
  const auto model = test::loaded(b);
  CHECK(model.model.textures[0].image == 0);
  CHECK(model.model.images[0].fallback == 1);
  Notes notes;
  const auto pixels = io::decodeImages(model.model, {true, false}, notes);
  CHECK(pixels[0].width == 4);
  CHECK(notes.empty());
}
