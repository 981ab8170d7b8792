#include "support/gltf_builder.hpp"

#include <array>
#include <cstdlib>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace facet::test {

namespace fs = std::filesystem;
using Json = nlohmann::json;

int GltfBuilder::addView(const void* data, size_t size, size_t stride) {
  bytes.resize((bytes.size() + 3) / 4 * 4);
  Json view = {{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}};
  if (stride > 0) view["byteStride"] = stride;
  const auto* begin = static_cast<const uint8_t*>(data);
  bytes.insert(bytes.end(), begin, begin + size);
  return append("bufferViews", view);
}

int GltfBuilder::addAccessor(Json accessor) { return append("accessors", std::move(accessor)); }

int GltfBuilder::append(const char* key, Json value) {
  json[key].push_back(std::move(value));
  return static_cast<int>(json[key].size()) - 1;
}

Json GltfBuilder::withBuffer(bool uri) const {
  Json result = json;
  if (result.contains("buffers") || bytes.empty()) return result;
  result["buffers"] = {{{"byteLength", bytes.size()}}};
  if (uri) result["buffers"][0]["uri"] = dataUri(bytes);
  return result;
}

std::string GltfBuilder::text() const { return withBuffer(true).dump(); }

std::vector<uint8_t> GltfBuilder::glb() const { return glbBytes(withBuffer(false).dump(), bytes); }

GltfBuilder triangle() {
  GltfBuilder builder;
  builder.add(std::vector<float>{0, 0, 0, 1, 0, 0, 0, 1, 0}, floatType, "VEC3");
  builder.append("meshes", {{"primitives", {{{"attributes", {{"POSITION", 0}}}}}}});
  builder.append("nodes", {{"mesh", 0}});
  builder.append("scenes", {{"nodes", {0}}});
  return builder;
}

namespace {

void appendLittleEndian(std::vector<uint8_t>& out, size_t value) {
  for (int i = 0; i < 4; ++i) out.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

void appendBigEndian(std::vector<uint8_t>& out, size_t value) {
  for (int i = 3; i >= 0; --i) out.push_back(static_cast<uint8_t>(value >> (8 * i)));
}

// Byte by byte: GCC 12 warns wrongly about inserting ranges into short vectors.
void appendBytes(std::vector<uint8_t>& out, std::span<const uint8_t> bytes) {
  for (const uint8_t byte : bytes) out.push_back(byte);
}

void appendText(std::vector<uint8_t>& out, std::string_view text) {
  for (const char c : text) out.push_back(static_cast<uint8_t>(c));
}

// PNG specification, annex D.
uint32_t crc32(std::span<const uint8_t> bytes) {
  uint32_t crc = 0xFFFFFFFFu;
  for (const uint8_t byte : bytes) {
    crc ^= byte;
    for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xEDB88320u ^ crc >> 1 : crc >> 1;
  }
  return ~crc;
}

void appendChunk(std::vector<uint8_t>& png, std::string_view type, std::span<const uint8_t> data) {
  appendBigEndian(png, data.size());
  const size_t begin = png.size();
  appendText(png, type);
  appendBytes(png, data);
  appendBigEndian(png, crc32(std::span(png).subspan(begin)));
}

// RFC 1950 and 1951: blocks of type 0.
std::vector<uint8_t> storedZlib(std::span<const uint8_t> data) {
  std::vector<uint8_t> out = {0x78, 0x01};
  uint32_t a = 1, b = 0;
  for (size_t at = 0; at == 0 || at < data.size(); at += 65535) {
    const size_t size = std::min<size_t>(65535, data.size() - at);
    out.push_back(at + size == data.size() ? 1 : 0);
    for (const size_t value : {size, ~size}) {
      out.push_back(static_cast<uint8_t>(value));
      out.push_back(static_cast<uint8_t>(value >> 8));
    }
    appendBytes(out, data.subspan(at, size));
  }
  for (const uint8_t byte : data) a = (a + byte) % 65521, b = (b + a) % 65521;
  appendBigEndian(out, b << 16 | a);
  return out;
}

}  // namespace

std::vector<uint8_t> glbBytes(const std::string& json, std::span<const uint8_t> binary) {
  std::string text = json;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const size_t padded = (binary.size() + 3) / 4 * 4;
  std::vector<uint8_t> out;
  appendText(out, "glTF");
  appendLittleEndian(out, 2);
  appendLittleEndian(out, 12 + 8 + text.size() + (binary.empty() ? 0 : 8 + padded));
  appendLittleEndian(out, text.size());
  appendText(out, "JSON");
  appendText(out, text);
  if (binary.empty()) return out;
  appendLittleEndian(out, padded);
  appendText(out, std::string_view("BIN\0", 4));
  appendBytes(out, binary);
  out.resize(out.size() + padded - binary.size());
  return out;
}

std::string base64(std::span<const uint8_t> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t count = std::min<size_t>(3, bytes.size() - i);
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (k < count ? bytes[i + k] : 0u);
    for (size_t k = 0; k < 4; ++k) out += k <= count ? digits[bits >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

std::string dataUri(std::span<const uint8_t> bytes, const std::string& mime) {
  return "data:" + mime + ";base64," + base64(bytes);
}

std::vector<uint8_t> pngBytes(uint32_t width, uint32_t height, int channels, int bits, std::span<const uint8_t> data) {
  constexpr std::array<uint8_t, 5> colourTypes = {0, 0, 4, 2, 6};
  std::vector<uint8_t> png = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
  std::vector<uint8_t> header;
  appendBigEndian(header, width);
  appendBigEndian(header, height);
  appendBytes(header,
              std::array<uint8_t, 5>{static_cast<uint8_t>(bits), colourTypes[static_cast<size_t>(channels)], 0, 0, 0});
  appendChunk(png, "IHDR", header);
  std::vector<uint8_t> rows;
  const size_t rowSize = data.size() / std::max<size_t>(height, 1);
  for (size_t y = 0; y < height && rowSize > 0; ++y) {
    rows.push_back(0);  // no filter
    const auto row = data.subspan(y * rowSize, rowSize);
    appendBytes(rows, row);
  }
  appendChunk(png, "IDAT", storedZlib(rows));
  appendChunk(png, "IEND", {});
  return png;
}

}  // namespace facet::test
