#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "base/disk_cache.hpp"
#include "fuzz/seeds.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"

namespace facet::fuzz {

Bytes bytesOf(std::string_view text) { return {text.begin(), text.end()}; }

Bytes ramp(size_t count, size_t step) {
  Bytes out(count);
  for (size_t i = 0; i < count; ++i) out[i] = static_cast<uint8_t>(1 + step * i % 255);
  return out;
}

std::vector<Bytes> texts(std::initializer_list<std::string_view> all) {
  std::vector<Bytes> out;
  for (const std::string_view text : all) out.push_back(bytesOf(text));
  return out;
}

std::vector<Bytes> jsonSeeds() {
  std::vector<Bytes> out =
      texts({R"({"a":[1,2.0,3e2,{"b":null}],"a":"x\"\\\u00e9","accessors":[{"count":3},{"bufferView":0}]})",
             R"([{"mesh":1.0},{"mesh":1.5}])", R"({"nodes":[{"children":[1.0,2e0]}]})", "{\"n\":\"caf\xe9\"}",
             "{\"a\":[[[[[[[[[[1]]]]]]]]]]}", "{ } x"});
  out.push_back(bytesOf(test::triangle().json.dump(1)));
  return out;
}

std::vector<Bytes> uriSeeds() {
  return texts({"a.bin", "b/c.png", "./b/../a.bin", "../secret", "out", "in/c.png", "%2e%2e/secret", "/etc/passwd",
                "file:///etc/passwd", "C:\\x", "http://x/y", "a%00b", "caf%C3%A9.png", "data:,plain%20text",
                "data:image/png;base64,AAEC AwQ=", "data:;base64,A*==", "//x/y", "b//c.png", "b/."});
}

namespace {

void append(Bytes& to, double value) {
  for (const uint8_t byte : std::bit_cast<std::array<uint8_t, 8>>(value)) to.push_back(byte);
}

}  // namespace

std::vector<Bytes> merlSeeds() {
  Bytes dims(12, 0);
  dims[0] = dims[4] = 90, dims[8] = 180;
  Bytes cells = dims, wide = dims;
  for (const double value : {1.0, -1.0, 0.25, 1500.0}) append(cells, value);
  wide[8] = 104, wide[9] = 1;  // 360
  return {dims, cells, wide, Bytes(12, 0)};
}

std::vector<Bytes> utiaSeeds() {
  std::vector<Bytes> out;
  for (uint8_t decode = 0; decode < 3; ++decode) {
    Bytes bytes(1, decode);
    for (const double value : {0.1, 0.0, 0.5, -0.01}) append(bytes, value);
    out.push_back(bytes);
  }
  return out;
}

namespace {

Bytes fileBytes(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return Bytes(std::istreambuf_iterator<char>(in), {});
}

}  // namespace

std::vector<Bytes> cacheSeeds() {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 1 << 20};
  std::vector<Bytes> out;
  for (const size_t size : {0, 5, 500}) {
    const Bytes value = ramp(size);
    writeCached(cache, "key", std::as_bytes(std::span(value)));
    out.push_back(fileBytes(std::filesystem::directory_iterator(cache.folder)->path()));
  }
  return out;
}

}  // namespace facet::fuzz
