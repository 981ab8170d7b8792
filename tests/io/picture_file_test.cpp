#include "io/picture_file.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "support/temporary_folder.hpp"

using namespace facet;
using io::PictureFormat;

namespace {

// Smooth colours, each pixel another one; alpha from 0 on.
io::Pixels gradient(int width, int height, int channels, int bytesPerSample = 1) {
  io::Pixels pixels{width, height, channels, bytesPerSample, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int c = 0; c < channels; ++c) {
        const double share = c == 0   ? double(x) / width
                             : c == 1 ? double(y) / height
                                      : double(x + y) / (width + height);
        const auto value = static_cast<uint16_t>(std::lround(share * (bytesPerSample == 2 ? 65535 : 255)));
        if (bytesPerSample == 2) pixels.data.push_back(0);
        pixels.data.push_back(static_cast<uint8_t>(value));
        if (bytesPerSample == 2) std::memcpy(&pixels.data[pixels.data.size() - 2], &value, 2);
      }
  return pixels;
}

std::vector<uint8_t> encoded(PictureFormat format, const io::Pixels& pixels, int quality = 90) {
  const auto bytes = io::encodePicture(format, pixels, quality, "p");
  if (!bytes) FAIL(describe(bytes.error()));
  return *bytes;
}

io::Pixels readBack(const std::vector<uint8_t>& bytes) {
  auto read = io::decodeImage(bytes, "p");
  if (!read) FAIL(describe(read.error()));
  return std::move(*read);
}

double rms(const io::Pixels& a, const io::Pixels& b) {
  REQUIRE(a.data.size() == b.data.size());
  double squares = 0;
  for (size_t i = 0; i < a.data.size(); ++i) squares += std::pow(double(a.data[i]) - double(b.data[i]), 2);
  return std::sqrt(squares / double(a.data.size()));
}

}  // namespace

TEST_CASE("picture files: the ending says the format, in any case") {
  CHECK(io::pictureFormat("a.PNG") == PictureFormat::png);
  CHECK(io::pictureFormat("a.b/c.jpeg") == PictureFormat::jpeg);
  CHECK(io::pictureFormat("a.Jpg") == PictureFormat::jpeg);
  CHECK(io::pictureFormat("a.webp") == PictureFormat::webp);
  CHECK(io::pictureFormat("a.avif") == PictureFormat::avif);
  CHECK(io::pictureFormat("a.exr") == PictureFormat::exr);
  for (const char* other : {"", "a", "png", ".png", "a.gif", "a.png/", "a.pn"}) CHECK_FALSE(io::pictureFormat(other));
  CHECK(io::pictureEndings(true) == ".png, .jpg, .webp, .avif or .exr");
}

TEST_CASE("picture files: what loses nothing reads back as it was, colours under transparency too") {
  const int channels = GENERATE(3, 4);
  const auto format = GENERATE(PictureFormat::png, PictureFormat::webp, PictureFormat::avif);
  CAPTURE(channels, io::rowOf(format).name);
  const io::Pixels pixels = gradient(37, 23, channels), back = readBack(encoded(format, pixels, 100));
  CHECK(back.width == 37);
  CHECK(back.height == 23);
  CHECK(back.channels == channels);
  CHECK(back.data == pixels.data);
}

TEST_CASE("picture files: a PNG of 16 bits holds them all") {
  const int channels = GENERATE(3, 4);
  // More than one band of rows.
  const io::Pixels pixels = gradient(640, 301, channels, 2), back = readBack(encoded(PictureFormat::png, pixels));
  CHECK(back.bytesPerSample == 2);
  CHECK(back.data == pixels.data);
}

TEST_CASE("picture files: quality is paid in bytes, and the same pixels give the same bytes") {
  const auto format = GENERATE(PictureFormat::jpeg, PictureFormat::webp, PictureFormat::avif);
  CAPTURE(io::rowOf(format).name);
  const io::Pixels pixels = gradient(160, 96, 3);
  size_t before = 0;
  double error = 1e9;
  for (const int quality : {10, 60, 95}) {
    const auto bytes = encoded(format, pixels, quality);
    CHECK(bytes == encoded(format, pixels, quality));
    const double now = rms(readBack(bytes), pixels);
    CHECK(bytes.size() > before);
    CHECK(now < error);
    before = bytes.size(), error = now;
  }
  CHECK(error < 2);  // of 255
}

TEST_CASE("picture files: what a format does not hold is a sentence") {
  const auto says = [](PictureFormat format, const io::Pixels& pixels, const std::string& sentence) {
    const auto bytes = io::encodePicture(format, pixels, 90, "p.x");
    REQUIRE_FALSE(bytes);
    CHECK(describe(bytes.error()) == sentence);
  };
  says(PictureFormat::jpeg, gradient(4, 4, 4),
       "p.x: cannot be written as JPEG: it has no transparency; name it .png, .webp or .avif.");
  says(PictureFormat::webp, gradient(4, 4, 3, 2),
       "p.x: cannot be written as WebP: it has 8 bits a channel; name it .png, or ask for 8 bits.");
  says(PictureFormat::webp, gradient(16384, 1, 3),
       "p.x: WebP holds pictures of up to 16383 pixels along a side, not 16384 x 1; choose a smaller size, or name it "
       ".png.");
  CHECK(io::encodePicture(PictureFormat::webp, gradient(16383, 1, 3), 90, "p"));
}
