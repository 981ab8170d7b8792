#include "io/bump.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "io/sources.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

uint32_t crcOf(const std::string& bytes) {
  uint32_t crc = 0xffffffffu;
  for (const char c : bytes) {
    crc ^= static_cast<uint8_t>(c);
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

std::string bigEndian(uint32_t v) {
  return {static_cast<char>(v >> 24), static_cast<char>(v >> 16), static_cast<char>(v >> 8), static_cast<char>(v)};
}

std::string chunk(const std::string& type, const std::string& data) {
  return bigEndian(static_cast<uint32_t>(data.size())) + type + data + bigEndian(crcOf(type + data));
}

// A grey PNG of `bits` with stored (uncompressed) data.
std::string greyPng(int width, int height, int bits, const std::vector<uint16_t>& values) {
  std::string raw;
  for (int y = 0; y < height; ++y) {
    raw += '\0';
    for (int x = 0; x < width; ++x) {
      const uint16_t v = values[static_cast<size_t>(y * width + x)];
      if (bits == 16) raw += static_cast<char>(v >> 8);
      raw += static_cast<char>(v & 255);
    }
  }
  uint32_t a = 1, b = 0;
  for (const char c : raw) a = (a + static_cast<uint8_t>(c)) % 65521, b = (b + a) % 65521;
  const auto length = static_cast<uint16_t>(raw.size());
  std::string zlib = "\x78\x01\x01";
  zlib += {static_cast<char>(length & 255), static_cast<char>(length >> 8), static_cast<char>(~length & 255),
           static_cast<char>((~length >> 8) & 255)};
  zlib += raw + bigEndian(b << 16 | a);
  std::string header = bigEndian(static_cast<uint32_t>(width)) + bigEndian(static_cast<uint32_t>(height));
  header += static_cast<char>(bits);
  header += std::string(4, '\0');
  return "\x89PNG\r\n\x1a\n" + chunk("IHDR", header) + chunk("IDAT", zlib) + chunk("IEND", "");
}

glm::dvec3 decoded(const io::Pixels& pixels, int x, int y) {
  glm::dvec3 n;
  for (int c = 0; c < 3; ++c) n[c] = pixels.data[static_cast<size_t>((y * pixels.width + x) * 3 + c)] / 127.5 - 1;
  return glm::normalize(n);
}

}  // namespace

TEST_CASE("Heights: 8 and 16 bit, black 0, white the scale, colours are refused") {
  test::TemporaryFolder folder;
  folder.write("8.png", greyPng(2, 1, 8, {0, 255}));
  folder.write("16.png", greyPng(2, 1, 16, {257, 65535}));
  const auto eight = io::readHeights(folder.file("8.png"), 0.5);
  REQUIRE(eight.has_value());
  CHECK(eight->heights == std::vector<float>{0, 0.5f});
  const auto sixteen = io::readHeights(folder.file("16.png"), 255);
  REQUIRE(sixteen.has_value());
  CHECK(sixteen->heights[0] == Approx(1).epsilon(1e-6));  // 257 / 65535 = 1 / 255
  CHECK(sixteen->heights[1] == 255);
  const io::Pixels grey{.width = 1, .height = 1, .channels = 3, .data = {7, 7, 7}};
  const io::Pixels red{.width = 1, .height = 2, .channels = 3, .data = {7, 7, 7, 8, 7, 7}};
  REQUIRE(io::writePng(folder.file("grey.png"), grey).has_value());
  REQUIRE(io::writePng(folder.file("red.png"), red).has_value());
  CHECK(io::readHeights(folder.file("grey.png"), 1).has_value());
  const auto refused = io::readHeights(folder.file("red.png"), 1);
  REQUIRE_FALSE(refused.has_value());
  CHECK(refused.error().place == "pixel 0,1");
  CHECK_FALSE(io::readHeights(folder.file("none.png"), 1).has_value());
}

TEST_CASE("Normal map of a sphere's cap: 16-bit heights reach the stored normals' own error, 8-bit ones do not") {
  constexpr int size = 64;
  constexpr double radius = 0.8;
  const auto height = [](double x, double y) { return std::sqrt(radius * radius - x * x - y * y); };
  test::TemporaryFolder folder;
  double worst[2] = {};
  for (const int bits : {8, 16}) {
    std::vector<uint16_t> values;
    for (int i = 0; i < size * size; ++i) {
      const double x = (i % size + 0.5) / size - 0.5, y = 0.5 - (i / size + 0.5) / size;
      values.push_back(static_cast<uint16_t>(std::lround(height(x, y) / radius * (bits == 8 ? 255 : 65535))));
    }
    folder.write("cap.png", greyPng(size, size, bits, values));
    const auto map = io::readHeights(folder.file("cap.png"), radius);
    REQUIRE(map.has_value());
    const io::Pixels normals = io::encodeNormals(*map, false);
    double& largest = worst[bits == 8 ? 0 : 1];
    for (int row = 1; row < size - 1; ++row)
      for (int column = 1; column < size - 1; ++column) {
        const double x = (column + 0.5) / size - 0.5, y = 0.5 - (row + 0.5) / size;
        const glm::dvec3 truth = glm::dvec3(x, y, height(x, y)) / radius;
        largest = std::max(largest, std::acos(std::min(1.0, glm::dot(truth, decoded(normals, column, row)))));
      }
    largest *= 180 / 3.14159265358979;
  }
  INFO("8 bit " << worst[0] << " degrees, 16 bit " << worst[1]);
  CHECK(worst[1] < 0.5);
  CHECK(worst[0] > 2);
  CHECK(worst[0] < 8);
}

TEST_CASE("Bump: every material of a built-in scene gets the normal texture, and tangents, files keep theirs") {
  test::TemporaryFolder folder;
  folder.write("h.png", greyPng(2, 2, 8, {0, 255, 255, 0}));
  const auto loaded = io::loadModel("builtin:spheres", {}, {folder.file("h.png"), 0.1});
  REQUIRE(loaded.has_value());
  const scene::Model& model = loaded->model;
  REQUIRE(model.textures.size() == 1);
  for (const scene::Material& material : model.materials) CHECK(material.normal.texture == 0);
  CHECK(model.meshes[0].primitives[0].tangents.size() == model.meshes[0].primitives[0].positions.size());
  Notes notes;
  const std::vector<io::Pixels> pixels = io::decodeImages(model, {true}, notes);
  CHECK(notes.empty());
  CHECK(pixels.at(0).width == 2);
  CHECK(io::loadModel("builtin:spheres")->model.textures.empty());
  const auto file = io::loadModel("model.glb", {}, {folder.file("h.png"), 0.1});
  REQUIRE_FALSE(file.has_value());
  CHECK(file.error().problem == "a bump is for the built-in scenes");
}
