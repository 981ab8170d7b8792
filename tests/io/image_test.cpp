#include "io/image.hpp"

#include <sys/stat.h>
#include <webp/encode.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <functional>

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

// JPEG, 16 x 8 pixels: two MCUs of an 8 x 8 block for each component. Written by hand after ITU T.81: quantisation by
// 1, Huffman codes 0 -> category 0 / end of block, 10 -> category 10 (DC). A DC difference of 8 (v - 128) makes v.
// adobe: the components are inverted CMYK.
Bytes jpegBytes(int components, const std::string& bits, bool adobe = false) {
  Bytes jpeg = {0xff, 0xd8};
  const auto add = [&](const Bytes& bytes) { jpeg.insert(jpeg.end(), bytes.begin(), bytes.end()); };
  const auto n = static_cast<uint8_t>(components);
  if (adobe) add({0xff, 0xee, 0, 14, 'A', 'd', 'o', 'b', 'e', 0, 100, 0, 0, 0, 0, 0});
  add({0xff, 0xdb, 0x00, 0x43, 0x00});
  add(Bytes(64, 1));
  add({0xff, 0xc0, 0x00, static_cast<uint8_t>(8 + 3 * n), 8, 0, 8, 0, 16, n});  // frame
  for (uint8_t i = 1; i <= n; ++i) add({i, 0x11, 0});
  add({0xff, 0xc4, 0x00, 0x15, 0x00, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 10});  // DC codes
  add({0xff, 0xc4, 0x00, 0x14, 0x10, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0});      // AC codes
  add({0xff, 0xda, 0x00, static_cast<uint8_t>(6 + 2 * n), n});                                 // scan
  for (uint8_t i = 1; i <= n; ++i) add({i, 0x00});
  add({0, 63, 0});
  for (size_t i = 0; i < bits.size(); i += 8) {
    uint8_t byte = 0;
    for (size_t k = i; k < i + 8; ++k) byte = static_cast<uint8_t>(byte << 1 | (k >= bits.size() || bits[k] == '1'));
    jpeg.push_back(byte);
    if (byte == 0xff) jpeg.push_back(0);
  }
  add({0xff, 0xd9});
  return jpeg;
}

// 8 * (200 - 128) = 576: 10 + 1001000000, end of block 0; then 0 + 0.
Bytes greyJpeg() {
  return jpegBytes(1,
                   "10"
                   "1001000000"
                   "0"
                   "00");
}

// Writes the checksums of a PNG's chunks anew (PNG, annex D).
void sumChunks(Bytes& png) {
  for (size_t at = 8; at + 12 <= png.size();) {
    const size_t size = size_t{png[at]} << 24 | size_t{png[at + 1]} << 16 | size_t{png[at + 2]} << 8 | png[at + 3];
    uint32_t crc = 0xFFFFFFFFu;
    for (size_t i = at + 4; i < at + 8 + size; ++i) {
      crc ^= png[i];
      for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
    }
    for (size_t i = 0; i < 4; ++i) png[at + 8 + size + i] = static_cast<uint8_t>(~crc >> (24 - 8 * i));
    at += 12 + size;
  }
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
  for (int channels = 1; channels <= 4; ++channels) {
    const Bytes four = {0x12, 0x34, 0xff, 0xff, 0x00, 0x01, 0xab, 0xcd};  // big-endian in the file
    const uint16_t numbers[] = {0x1234, 0xffff, 0x0001, 0xabcd};
    Bytes data;
    std::vector<uint16_t> wanted;
    for (int i = 0; i < channels; ++i) {
      data.insert(data.end(), four.begin(), four.end());
      wanted.insert(wanted.end(), std::begin(numbers), std::end(numbers));
    }
    const auto pixels = io::decodeImage(test::pngBytes(2, 2, channels, 16, data), "i");
    REQUIRE(pixels);
    CHECK(pixels->bytesPerSample == 2);
    CHECK(pixels->channels == channels);
    REQUIRE(pixels->data.size() == wanted.size() * 2);
    CHECK(std::memcmp(pixels->data.data(), wanted.data(), pixels->data.size()) == 0);
  }
}

TEST_CASE("PNG of one, two and four bits, and of palettes, becomes 8 bits", "[io][image]") {
  // A row of one byte is relabelled (byte 19 width, 24 depth, 25 colour type).
  const auto packed = [](uint8_t bits, uint8_t type, const Bytes& chunks) {
    Bytes png = test::pngBytes(1, 1, 1, 8, Bytes{0b11'00'01'10});
    png[19] = static_cast<uint8_t>(8 / bits), png[24] = bits, png[25] = type;
    png.insert(png.begin() + 33, chunks.begin(), chunks.end());
    sumChunks(png);
    return png;
  };
  CHECK(io::decodeImage(packed(1, 0, {}), "i")->data == Bytes{255, 255, 0, 0, 0, 255, 255, 0});
  CHECK(io::decodeImage(packed(2, 0, {}), "i")->data == Bytes{255, 0, 85, 170});
  CHECK(io::decodeImage(packed(4, 0, {}), "i")->data == Bytes{12 * 17, 6 * 17});
  const Bytes palette = {0, 0, 0, 12, 'P', 'L', 'T', 'E', 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 0, 0, 0, 0};
  const auto colors = io::decodeImage(packed(2, 3, palette), "i");
  REQUIRE(outcome(colors) == "decoded");
  CHECK(colors->channels == 3);
  CHECK(colors->data == Bytes{10, 11, 12, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  Bytes withAlpha = palette;
  const Bytes alphas = {0, 0, 0, 2, 't', 'R', 'N', 'S', 50, 60, 0, 0, 0, 0};
  withAlpha.insert(withAlpha.end(), alphas.begin(), alphas.end());
  const auto clear = io::decodeImage(packed(2, 3, withAlpha), "i");
  REQUIRE(outcome(clear) == "decoded");
  CHECK(clear->channels == 4);
  CHECK(clear->data == Bytes{10, 11, 12, 255, 1, 2, 3, 50, 4, 5, 6, 60, 7, 8, 9, 255});
}

TEST_CASE("JPEG", "[io][image]") {
  const auto pixels = io::decodeImage(greyJpeg(), "i");
  REQUIRE(outcome(pixels) == "decoded");
  CHECK(pixels->width == 16);
  CHECK(pixels->height == 8);
  CHECK(pixels->channels == 1);
  CHECK(pixels->data == Bytes(16 * 8, 200));
}

TEST_CASE("JPEG of three and four components is RGB", "[io][image]") {
  // Y 128, Cb 128, Cr 200: R = Y + 1.402 * 72 = 228.9, G = Y - 0.714 * 72 = 76.6, B = Y (JFIF).
  const auto color = io::decodeImage(jpegBytes(3,
                                               "00"
                                               "00"
                                               "1010010000000"
                                               "000000"),
                                     "i");
  REQUIRE(outcome(color) == "decoded");
  CHECK(color->channels == 3);
  REQUIRE(color->data.size() == 16 * 8 * 3);
  const int wanted[] = {229, 77, 128};
  for (size_t i = 0; i < color->data.size(); ++i) REQUIRE(std::abs(color->data[i] - wanted[i % 3]) <= 1);
  // Inverted C 200, M and Y 128, K 255: each times K / 255.
  const auto print = io::decodeImage(jpegBytes(4,
                                               "10"
                                               "1001000000"
                                               "0"
                                               "00"
                                               "00"
                                               "10"
                                               "1111111000"
                                               "0"
                                               "00000000",
                                               true),
                                     "i");
  REQUIRE(outcome(print) == "decoded");
  CHECK(print->channels == 3);
  REQUIRE(print->data.size() == 16 * 8 * 3);
  const int inks[] = {200, 128, 128};
  for (size_t i = 0; i < print->data.size(); ++i) REQUIRE(std::abs(print->data[i] - inks[i % 3]) <= 1);
}

TEST_CASE("Images that are refused say why", "[io][image]") {
  const Bytes white(12, 255);
  const auto png = test::pngBytes(2, 2, 3, 8, white);
  const std::string convert = ", which is not supported; convert it to PNG or JPEG.";
  CHECK(decode(png) == "decoded");
  CHECK(decode({}) == "i: the image is empty; save it again.");
  CHECK(decode(text("hello, world")) == "i: is no PNG, JPEG, WebP, AVIF or KTX2 image; convert it to PNG or JPEG.");
  CHECK(decode(text(std::string_view("RIFF\x04\0\0\0WEBPVP8 ", 16))) ==
        "i: the image's header is damaged; save it again.");
  CHECK(decode(text("\xabKTX 11\xbb\r\n\x1a\n")) == "i: is a KTX 1 image" + convert);
  CHECK(decode(text("GIF89a")) == "i: is a GIF image" + convert);
  CHECK(decode(text("BM123456")) == "i: is a BMP image" + convert);
  CHECK(decode(text("#?RADIANCE\n")) == "i: is a Radiance HDR image" + convert);
  // 18 bytes of TGA that claim 23170 x 23170 pixels
  CHECK(decode({0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x82, 0x5a, 0x82, 0x5a, 32, 0}) ==
        "i: is no PNG, JPEG, WebP, AVIF or KTX2 image; convert it to PNG or JPEG.");
  CHECK(decode(Bytes(png.begin(), png.begin() + 20)) == "i: the image's header is damaged; save it again.");
  CHECK(decode(Bytes(png.begin(), png.begin() + 50)) == "i: the image is damaged: end of stream; save it again.");
  CHECK(decode(test::pngBytes(0, 4, 1, 8, {})) == "i: the image's header is damaged; save it again.");
  auto damaged = greyJpeg();
  damaged.resize(100);
  CHECK(decode(damaged) == "i: the image's header is damaged; save it again.");
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
  jpeg[height] = jpeg[height + 2] = 0xff, jpeg[height + 1] = jpeg[height + 3] = 0xdc;
  CHECK(decode(jpeg) ==
        "i: the image has 65500 x 65500 pixels, more than the limit of 268435456; use a smaller image.");
  jpeg[height] = jpeg[height + 2] = 0x3f, jpeg[height + 1] = jpeg[height + 3] = 0xff;
  CHECK(decode(jpeg) == "i: the file is too short for 16383 x 16383 pixels; save it again.");
}

TEST_CASE("A WebP picture of very many pixels in next to no bytes is refused by its header", "[io][image]") {
  const auto webp = [](uint32_t width, uint32_t height, size_t padding) {
    const uint32_t bits = (width - 1) | (height - 1) << 14;  // lossless, no alpha, version 0
    Bytes chunk = {0x2f};
    for (int i = 0; i < 4; ++i) chunk.push_back(static_cast<uint8_t>(bits >> (8 * i)));
    chunk.resize(chunk.size() + padding);
    if (chunk.size() % 2 == 1) chunk.push_back(0);
    Bytes bytes = {'R', 'I', 'F', 'F'};
    const auto add = [&](uint32_t value) {
      for (int i = 0; i < 4; ++i) bytes.push_back(static_cast<uint8_t>(value >> (8 * i)));
    };
    add(static_cast<uint32_t>(chunk.size() + 12));
    for (const char c : std::string("WEBPVP8L")) bytes.push_back(static_cast<uint8_t>(c));
    add(static_cast<uint32_t>(chunk.size()));
    bytes.insert(bytes.end(), chunk.begin(), chunk.end());
    return bytes;
  };
  CHECK(decode(webp(16383, 16383, 30)) == "i: the file is too short for 16383 x 16383 pixels; save it again.");
  // Enough bytes for their number, but they are nothing.
  CHECK(decode(webp(4096, 4097, 5000)).find("too short for") == std::string::npos);
}

TEST_CASE("A progressive JPEG of too many scans is refused by its header", "[io][image]") {
  auto jpeg = greyJpeg();
  const Bytes scan = {0xff, 0xda};
  for (int i = 0; i < 40; ++i) jpeg.insert(jpeg.end(), scan.begin(), scan.end());
  io::Limits limits;
  limits.imagePixels = 16 * 8;
  CHECK(decode(jpeg, limits) == "i: the image has 41 scans of 16 x 8 pixels; save it again.");
}

TEST_CASE("An image that is damaged in part is shown with a warning, and refused where nobody could be warned",
          "[io][image]") {
  auto cutOff = greyJpeg();
  cutOff.resize(cutOff.size() - 3);  // the last bits and the end
  CHECK(decode(cutOff) == "i: the image is damaged: Premature end of JPEG file; save it again.");
  // A wrong sum of the pixels, but not of the bytes that hold them.
  auto sum = test::pngBytes(2, 2, 1, 8, Bytes{1, 2, 3, 4});
  sum[sum.size() - 12 - 4 - 1] ^= 1;
  sumChunks(sum);
  CHECK(decode(sum) == "i: the image is damaged: its checksum does not fit; save it again.");

  scene::Model model;
  model.images.push_back({"cut", {}, cutOff, {}});
  model.images.push_back({"sum", {}, sum, {}});
  Notes notes;
  const auto images = io::decodeImages(model, {true, true}, notes);
  CHECK_FALSE(images[0].placeholder);
  CHECK(Bytes(images[0].data.begin(), images[0].data.begin() + 8) == Bytes(8, 200));
  CHECK(images[1].data == Bytes{1, 2, 3, 4});
  REQUIRE(notes.size() == 2);
  CHECK(notes[0].text == "the image \"cut\" is damaged, and a part of it may look wrong: Premature end of JPEG file");
  CHECK(notes[1].text == "the image \"sum\" is damaged, and a part of it may look wrong: its checksum does not fit");
}

TEST_CASE("What a PNG says besides its pixels cannot spoil them", "[io][image]") {
  const Bytes data = {1, 2, 3, 4};
  const auto with = [&](const std::string& type, const Bytes& content) {
    Bytes png = test::pngBytes(2, 2, 1, 8, data);
    Bytes chunk = {static_cast<uint8_t>(content.size() >> 24), static_cast<uint8_t>(content.size() >> 16),
                   static_cast<uint8_t>(content.size() >> 8), static_cast<uint8_t>(content.size())};
    chunk.insert(chunk.end(), type.begin(), type.end());
    chunk.insert(chunk.end(), content.begin(), content.end());
    chunk.insert(chunk.end(), 4, 0);
    png.insert(png.begin() + 33, chunk.begin(), chunk.end());
    sumChunks(png);
    return io::decodeImage(png, "i");
  };
  // A gamma, a rendering intent, a profile and a time that are none; half grey is what gamma would change.
  for (const auto& [type, content] : {std::pair<std::string, Bytes>("gAMA", {0}),
                                      {"gAMA", {0, 1, 0x86, 0xa0}},
                                      {"sRGB", {9}},
                                      {"iCCP", {'x', 0, 0, 'r', 'u', 'b'}},
                                      {"tIME", Bytes(7, 255)},
                                      {"tEXt", {0, 0}}}) {
    INFO(type);
    const auto pixels = with(type, content);
    REQUIRE(outcome(pixels) == "decoded");
    CHECK(pixels->data == data);
  }
  CHECK(outcome(with("tEXt", Bytes(size_t{17} << 20, 'a'))) == "decoded");  // longer than is kept
  CHECK(outcome(with("ABCD", {1})) == "i: the image's header is damaged; save it again.");
}

// Huffman tables that a decoder must not believe: counts of codes that no tree holds, codes of more bits than are left.
TEST_CASE("A JPEG with damaged Huffman tables is an error or a warning", "[io][image]") {
  const Bytes good = greyJpeg();
  const Bytes marker = {0xff, 0xc4};
  const auto table = std::search(good.begin(), good.end(), marker.begin(), marker.end()) - good.begin();
  for (size_t at = static_cast<size_t>(table) + 4; at < static_cast<size_t>(table) + 2 + 0x15 + 2 + 0x14; ++at) {
    for (const int value : {0, 1, 2, 16, 17, 127, 254, 255}) {
      Bytes bytes = good;
      bytes[at] = static_cast<uint8_t>(value);
      const auto pixels = io::decodeImage(bytes, "i");
      if (pixels) CHECK(pixels->data.size() == 16 * 8);
    }
  }
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
                   "/images/4: the image \"broken\" cannot be shown: is no PNG, JPEG, WebP, AVIF or KTX2 image" +
                   instead + "/images/5: the image \"named\" cannot be shown: the file \"x.png\" does not exist" +
                   instead + "/images/7: the image \"short\" cannot be shown: the image is damaged: end of stream" +
                   instead);
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

TEST_CASE("PNG of many bands: every pixel comes back, smooth, noisy or plain, in files of a known size",
          "[io][image]") {
  test::TemporaryFolder folder;
  struct Row {
    const char* name;
    std::function<int(int x, int y, int c)> value;
    double mostOfRaw;  // size of the file
  };
  uint32_t state = 1;
  const auto noise = [&](int, int, int) { return static_cast<int>((state = state * 1664525u + 1013904223u) >> 24); };
  for (const Row& row :
       {Row{"plain", [](int, int, int) { return 77; }, 0.006},
        Row{"smooth", [](int x, int y, int c) { return (x + 2 * y + 40 * c) / 8; }, 0.02}, Row{"noise", noise, 1.01}})
    for (const auto& [width, height] :
         {std::pair(700, 901), std::pair(1, 1), std::pair(3, 70000), std::pair(16384, 33)}) {
      io::Pixels pixels;
      pixels.width = width, pixels.height = height, pixels.channels = 3;
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          for (int c = 0; c < 3; ++c) pixels.data.push_back(static_cast<uint8_t>(row.value(x, y, c)));
      INFO(row.name << " " << width << " x " << height);
      const auto path = folder.path() / "bands.png";
      REQUIRE(io::writePng(path, pixels));
      const double size = static_cast<double>(std::filesystem::file_size(path));
      CHECK(size <= row.mostOfRaw * static_cast<double>(pixels.data.size() + static_cast<size_t>(height)) + 400);
      if (height > 16384) continue;  // more than is read
      const auto read = io::readImage(path);
      REQUIRE(read);
      size_t wrong = 0;
      for (size_t i = 0; i < pixels.data.size() / 3; ++i)
        for (size_t c = 0; c < 3; ++c) wrong += read->data[4 * i + c] != pixels.data[3 * i + c];
      CHECK(wrong == 0);
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
        wrong.string() + ": is no PNG, JPEG, WebP, AVIF or KTX2 image; convert it to PNG or JPEG.");
  const auto full = io::writePng("/dev/full", io::placeholderImage());
  REQUIRE_FALSE(full);
  CHECK(describe(full.error()) ==
        "/dev/full: cannot be written: No space left on device; check the folder, its permissions and the space left.");
}
