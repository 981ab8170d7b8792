#include "io/image.hpp"

#include <sys/stat.h>
#include <webp/encode.h>

#include <catch2/catch.hpp>

#include "support/gltf_builder.hpp"

namespace {

using namespace facet;
using Bytes = std::vector<uint8_t>;

std::string outcome(const Result<io::Pixels>& result) {
  return result ? std::string("decoded") : describe(result.error());
}
std::string decode(const Bytes& bytes, const io::Limits& limits = {}) {
  return outcome(io::decodeImage(bytes, "i", limits));
}
Bytes text(std::string_view t) { return Bytes(t.begin(), t.end()); }

// JPEG, 16 x 8 pixels of grey 200: one 8 x 8 block coded twice. Written by hand after ITU T.81: quantisation by 1,
// Huffman codes 0 -> category 0 / end of block, 10 -> category 10 (DC).
Bytes greyJpeg() {
  const Bytes head = {0xff, 0xd8, 0xff, 0xdb, 0x00, 0x43, 0x00};
  Bytes jpeg(head.size() + 64, 1);
  std::copy(head.begin(), head.end(), jpeg.begin());
  const Bytes rest = {0xff, 0xc0, 0x00, 0x0b, 8, 0, 8, 0, 16, 1, 1, 0x11, 0,                                // frame
                      0xff, 0xc4, 0x00, 0x15, 0x00, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 10,  // DC codes
                      0xff, 0xc4, 0x00, 0x14, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,      // AC codes
                      0xff, 0xda, 0x00, 0x08, 1, 1, 0x00, 0, 63, 0,                                         // scan
                      // DC difference 8 * (200 - 128) = 576: 10 + 1001000000, end of block 0; then 0 + 0; ones to fill
                      0b10100100, 0b00000001, 0xff, 0xd9};
  jpeg.insert(jpeg.end(), rest.begin(), rest.end());
  return jpeg;
}

// Lossless.
Bytes webpBytes(int width, int height, int channels, const Bytes& data) {
  uint8_t* out = nullptr;
  const auto encode = channels == 4 ? WebPEncodeLosslessRGBA : WebPEncodeLosslessRGB;
  const size_t size = encode(data.data(), width, height, width * channels, &out);
  const Bytes bytes(out, out + size);
  WebPFree(out);
  return bytes;
}

// Every sample differs from its neighbours, alpha is never 0 (the encoder may drop the colour there).
Bytes samples(size_t count) {
  Bytes data(count);
  for (size_t i = 0; i < count; ++i) data[i] = static_cast<uint8_t>(1 + 37 * i % 255);
  return data;
}

}  // namespace

TEST_CASE("WebP, RGB and RGBA", "[io][image]") {
  for (const int channels : {3, 4}) {
    const Bytes data = samples(static_cast<size_t>(5 * 3 * channels));
    const auto pixels = io::decodeImage(webpBytes(5, 3, channels, data), "i");
    REQUIRE(outcome(pixels) == "decoded");
    CHECK(pixels->width == 5);
    CHECK(pixels->height == 3);
    CHECK(pixels->channels == channels);
    CHECK(pixels->bytesPerSample == 1);
    CHECK(pixels->data == data);
  }
}

TEST_CASE("Faulty WebP says why", "[io][image]") {
  const Bytes good = webpBytes(16, 16, 3, samples(16 * 16 * 3));
  CHECK(decode(Bytes(good.begin(), good.begin() + 24)) == "i: the image's header is damaged; save it again.");
  CHECK(decode(Bytes(good.begin(), good.end() - 40)) ==
        "i: the image is damaged: its WebP data is faulty or too short; save it again.");
  io::Limits limits;
  limits.imagePixels = 255;
  CHECK(decode(good, limits) == "i: the image has 16 x 16 pixels, more than the limit of 255; use a smaller image.");
  // RIFF, VP8X with the flag for animation, 1 x 1 pixel
  CHECK(decode(text(std::string_view("RIFF\x16\0\0\0WEBPVP8X\x0a\0\0\0\x02\0\0\0\0\0\0\0\0\0", 30))) ==
        "i: is an animated WebP image; use a still image.");
}

TEST_CASE("PNG keeps its channels and its depth", "[io][image]") {
  for (int channels = 1; channels <= 4; ++channels) {
    Bytes data(static_cast<size_t>(3 * 2 * channels));
    for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<uint8_t>(11 * i + 5);
    const auto pixels = io::decodeImage(test::pngBytes(3, 2, channels, 8, data), "i");
    REQUIRE(pixels);
    CHECK(pixels->width == 3);
    CHECK(pixels->height == 2);
    CHECK(pixels->channels == channels);
    CHECK(pixels->bytesPerSample == 1);
    CHECK(pixels->data == data);
    CHECK_FALSE(pixels->placeholder);
  }
}

TEST_CASE("PNG of 16 bits keeps them", "[io][image]") {
  const Bytes data = {0x12, 0x34, 0xff, 0xff, 0x00, 0x01, 0xab, 0xcd};  // big-endian in the file
  const auto pixels = io::decodeImage(test::pngBytes(2, 2, 1, 16, data), "i");
  REQUIRE(pixels);
  CHECK(pixels->bytesPerSample == 2);
  CHECK(pixels->channels == 1);
  const uint16_t wanted[] = {0x1234, 0xffff, 0x0001, 0xabcd};
  REQUIRE(pixels->data.size() == sizeof wanted);
  CHECK(std::memcmp(pixels->data.data(), wanted, sizeof wanted) == 0);
}

TEST_CASE("JPEG", "[io][image]") {
  const auto pixels = io::decodeImage(greyJpeg(), "i");
  REQUIRE(outcome(pixels) == "decoded");
  CHECK(pixels->width == 16);
  CHECK(pixels->height == 8);
  CHECK(pixels->channels == 1);
  CHECK(pixels->data == Bytes(16 * 8, 200));
}

TEST_CASE("Images that are refused say why", "[io][image]") {
  const Bytes white(12, 255);
  const auto png = test::pngBytes(2, 2, 3, 8, white);
  const std::string convert = ", which is not supported; convert it to PNG or JPEG.";
  CHECK(decode(png) == "decoded");
  CHECK(decode({}) == "i: the image is empty; save it again.");
  CHECK(decode(text("hello, world")) == "i: is no PNG, JPEG or WebP image; convert it to PNG or JPEG.");
  CHECK(decode(text(std::string_view("RIFF\x04\0\0\0WEBPVP8 ", 16))) ==
        "i: the image's header is damaged; save it again.");
  CHECK(decode(text("\xabKTX 20\xbb\r\n\x1a\n")) == "i: is a KTX2 image" + convert);
  CHECK(decode(text("GIF89a")) == "i: is a GIF image" + convert);
  CHECK(decode(text("BM123456")) == "i: is a BMP image" + convert);
  CHECK(decode(text("#?RADIANCE\n")) == "i: is a Radiance HDR image" + convert);
  // 18 bytes of TGA that claim 23170 x 23170 pixels
  CHECK(decode({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x82, 0x5a, 0x82, 0x5a, 32, 0}) ==
        "i: is no PNG, JPEG or WebP image; convert it to PNG or JPEG.");
  CHECK(decode(Bytes(png.begin(), png.begin() + 20)) == "i: the image's header is damaged; save it again.");
  CHECK(decode(Bytes(png.begin(), png.begin() + 50)) == "i: the image is damaged: outofdata; save it again.");
  CHECK(decode(test::pngBytes(0, 4, 1, 8, {})) == "i: the image's header is damaged; save it again.");
  auto damaged = greyJpeg();
  damaged.resize(100);
  CHECK(decode(damaged) == "i: the image is damaged: expected marker; save it again.");
}

TEST_CASE("A decompression bomb is refused by its header", "[io][image]") {
  CHECK(decode(test::pngBytes(16385, 16384, 1, 8, {})) ==
        "i: the image has 16385 x 16384 pixels, more than the limit of 268435456; use a smaller image.");
  // Within the limit, but deflate cannot hold that much in so few bytes.
  CHECK(decode(test::pngBytes(16384, 16384, 1, 8, {})) ==
        "i: the file is too short for 16384 x 16384 pixels; save it again.");
  io::Limits limits;
  limits.imagePixels = 5;
  CHECK(decode(test::pngBytes(3, 2, 1, 8, Bytes(6)), limits) ==
        "i: the image has 3 x 2 pixels, more than the limit of 5; use a smaller image.");
  auto jpeg = greyJpeg();
  const size_t height = 71 + 5;  // the frame's sizes follow the tables
  jpeg[height] = jpeg[height + 1] = jpeg[height + 2] = jpeg[height + 3] = 0xff;
  CHECK(decode(jpeg) ==
        "i: the image has 65535 x 65535 pixels, more than the limit of 268435456; use a smaller image.");
}

TEST_CASE("Damage anywhere never crashes the decoders", "[io][image]") {
  Bytes data(16 * 16 * 3);
  for (size_t i = 0; i < data.size(); ++i) data[i] = static_cast<uint8_t>(i * i);
  uint32_t state = 7;
  const auto random = [&] { return (state = state * 1664525u + 1013904223u) >> 8; };
  io::Limits limits;
  limits.imagePixels = 1 << 16;
  for (const Bytes& good : {test::pngBytes(16, 16, 3, 8, data), greyJpeg(), webpBytes(16, 16, 3, data)}) {
    for (int round = 0; round < 2000; ++round) {
      Bytes bytes = good;
      for (int change = 0; change < 1 + round % 3; ++change)
        bytes[random() % bytes.size()] = static_cast<uint8_t>(random());
      bytes.resize(round % 5 == 0 ? random() % bytes.size() : bytes.size());
      const auto pixels = io::decodeImage(bytes, "i", limits);
      if (pixels)
        CHECK(pixels->data.size() ==
              static_cast<size_t>(pixels->width * pixels->height * pixels->channels * pixels->bytesPerSample));
    }
  }
}

TEST_CASE("Missing and corrupt images become placeholders with a warning", "[io][image]") {
  test::TemporaryFolder folder;
  const Bytes pixel = {1, 2, 3};
  const auto good = test::pngBytes(1, 1, 3, 8, pixel);
  REQUIRE(::mkfifo((folder.path() / "pipe").c_str(), 0600) == 0);
  scene::Model model;
  const auto add = [&](const char* name) -> scene::Image& {
    model.images.push_back({name, {}, {}, {}});
    return model.images.back();
  };
  add("good").encoded = good;
  add("file").file = folder.write("a.png", good);
  add("lost").file = folder.path() / "lost.png";
  add("pipe").file = folder.path() / "pipe";
  add("broken").encoded = text("rubbish");
  add("named").problem = "the file \"x.png\" does not exist";
  add("unwanted").encoded = text("rubbish");
  add("short").encoded = Bytes(good.begin(), good.begin() + 45);
  std::vector<bool> wanted(model.images.size(), true);
  wanted[6] = false;
  Notes notes;
  const auto images = io::decodeImages(model, wanted, notes);
  REQUIRE(images.size() == model.images.size());
  CHECK(images[0].data == pixel);
  CHECK(images[1].data == pixel);
  CHECK(images[6].width == 0);
  for (const size_t i : {2u, 3u, 4u, 5u, 7u}) {
    INFO(i);
    CHECK(images[i].placeholder);
    CHECK(images[i].data == io::placeholderImage().data);
  }
  std::string all;
  for (const Note& note : notes) {
    CHECK(note.severity == Note::Severity::warning);
    all += note.place + ": " + note.text + "\n";
  }
  const std::string instead = "; a placeholder takes its place\n";
  CHECK(all == "/images/2: the image \"lost\" cannot be shown: no such file" + instead +
                   "/images/3: the image \"pipe\" cannot be shown: is not a regular file" + instead +
                   "/images/4: the image \"broken\" cannot be shown: is no PNG, JPEG or WebP image" + instead +
                   "/images/5: the image \"named\" cannot be shown: the file \"x.png\" does not exist" + instead +
                   "/images/7: the image \"short\" cannot be shown: the image is damaged: outofdata" + instead);
}

TEST_CASE("All images together stay within the budget", "[io][image]") {
  scene::Model model;
  for (int i = 0; i < 4; ++i) model.images.push_back({std::to_string(i), {}, test::pngBytes(2, 2, 1, 8, Bytes(4)), {}});
  io::Limits limits;
  limits.totalPixels = 11;
  Notes notes;
  const auto images = io::decodeImages(model, std::vector<bool>(4, true), notes, limits);
  CHECK_FALSE(images[0].placeholder);
  CHECK_FALSE(images[1].placeholder);
  CHECK(images[2].placeholder);
  CHECK(images[3].placeholder);
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].text ==
        "the image \"2\" cannot be shown: the images together have more than 11 pixels; a placeholder takes its place");
}

TEST_CASE("The placeholder is magenta and black", "[io][image]") {
  const auto pixels = io::placeholderImage();
  CHECK(pixels.placeholder);
  CHECK(pixels.channels == 3);
  CHECK(Bytes(pixels.data.begin(), pixels.data.begin() + 3) == Bytes{255, 0, 255});
  CHECK(Bytes(pixels.data.begin() + 24, pixels.data.begin() + 27) == Bytes{0, 0, 0});
}

TEST_CASE("PNG written and read again", "[io][image]") {
  test::TemporaryFolder folder;
  for (const int channels : {1, 3, 4}) {
    io::Pixels pixels;
    pixels.width = 37;
    pixels.height = 11;
    pixels.channels = channels;
    for (int i = 0; i < 37 * 11 * channels; ++i) pixels.data.push_back(static_cast<uint8_t>(i * i / 7));
    const auto path = folder.path() / "out.png";
    REQUIRE(io::writePng(path, pixels));
    const auto read = io::readImage(path);
    REQUIRE(read);
    CHECK(read->channels == 4);
    const auto c = static_cast<size_t>(channels);
    for (const size_t i : {0u, 36u, 37u, 300u}) {
      for (size_t k = 0; k < 4; ++k) {
        const int wanted = k < c ? pixels.data[i * c + k] : k == 3 ? 255 : pixels.data[i * c];
        CHECK(read->data[i * 4 + k] == wanted);
      }
    }
  }
}

TEST_CASE("Reading a picture turns 16 bits and grey into 8-bit RGBA", "[io][image]") {
  test::TemporaryFolder folder;
  const auto path = folder.write("a.png", test::pngBytes(1, 1, 2, 16, Bytes{0x80, 0x80, 0xff, 0xff}));
  const auto pixels = io::readImage(path);
  REQUIRE(pixels);
  CHECK(pixels->data == Bytes{128, 128, 128, 255});
}

TEST_CASE("Pictures that cannot be written or read say why", "[io][image]") {
  test::TemporaryFolder folder;
  const auto inNoFolder = folder.path() / "none/out.png";
  const auto written = io::writePng(inNoFolder, io::placeholderImage());
  REQUIRE_FALSE(written);
  CHECK(describe(written.error()) == inNoFolder.string() +
                                         ": cannot be written: No such file or directory; check the folder, its "
                                         "permissions and the space left.");
  CHECK(outcome(io::readImage(inNoFolder)) == inNoFolder.string() + ": no such file; check the path.");
  const auto wrong = folder.write("x.png", std::string("text"));
  CHECK(outcome(io::readImage(wrong)) ==
        wrong.string() + ": is no PNG, JPEG or WebP image; convert it to PNG or JPEG.");
  const auto full = io::writePng("/dev/full", io::placeholderImage());
  REQUIRE_FALSE(full);
  CHECK(describe(full.error()) ==
        "/dev/full: cannot be written: No space left on device; check the folder, its permissions and the space left.");
}
