#pragma once

// glTF files made in a test: a JSON document to change at will and the bytes of its buffer 0.

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

#include "support/temporary_folder.hpp"

namespace facet::test {

// componentType values of glTF.
enum Component { byteType = 5120, ubyteType, shortType, ushortType, uintType = 5125, floatType };

class GltfBuilder {
 public:
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::vector<uint8_t> bytes;  // buffer 0; declared when the file is made, unless json already has "buffers"

  // Appends to buffer 0, aligned to 4, and adds a buffer view; returns its index.
  int addView(const void* data, size_t size, size_t stride = 0);
  int addAccessor(nlohmann::json accessor);  // returns its index

  template <class T>
  int addView(const std::vector<T>& values, size_t stride = 0) {
    return addView(values.data(), values.size() * sizeof(T), stride);
  }
  // A tightly packed accessor in a view of its own; type is "SCALAR", "VEC3" and so on.
  template <class T>
  int add(const std::vector<T>& values, Component component, const std::string& type, bool normalized = false) {
    const size_t width = type == "SCALAR" ? 1 : static_cast<size_t>(type.back() - '0');
    return addAccessor({{"bufferView", addView(values)},
                        {"componentType", component},
                        {"type", type},
                        {"count", values.size() / width},
                        {"normalized", normalized}});
  }
  // Appends to a root array; returns the index.
  int append(const char* key, nlohmann::json value);

  std::string text() const;  // .gltf, buffer 0 as a data: URI
  std::vector<uint8_t> glb() const;

 private:
  nlohmann::json withBuffer(bool dataUri) const;
};

// One triangle (0,0,0) (1,0,0) (0,1,0), accessor 0, in mesh 0, node 0, scene 0.
GltfBuilder triangle();

std::vector<uint8_t> glbBytes(const std::string& json, std::span<const uint8_t> binary);
std::string base64(std::span<const uint8_t> bytes);
std::string dataUri(std::span<const uint8_t> bytes, const std::string& mime = "application/octet-stream");

// A valid PNG: channels 1 to 4, bits 8 or 16 (samples big-endian in data), stored without compression.
std::vector<uint8_t> pngBytes(uint32_t width, uint32_t height, int channels, int bits, std::span<const uint8_t> data);

}  // namespace facet::test
