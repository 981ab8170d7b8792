#pragma once

// KHR_draco_mesh_compression of one primitive.

#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "io/accessors.hpp"

namespace facet::io {

// Attributes as their accessors describe them, tightly packed.
struct DracoGeometry {
  std::map<std::string, std::vector<uint8_t>, std::less<>> attributes;
  std::vector<uint32_t> indices;  // of triangles
};

bool isDraco(const tinygltf::Primitive& primitive);

// Everything that can be said without decoding. The accessors are checked already.
Result<void> checkDraco(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place);

// Decodes a checked primitive; of its attributes only those that are wanted. Errors: data that is no Draco mesh of
// bitstream 2.2, whose counts are not those of the accessors, whose attributes are missing or have other components.
// May throw std::bad_alloc. Indices are not compared with the number of vertices.
Result<DracoGeometry> decodeDraco(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place,
                                  std::span<const char* const> wanted);

// A decoded attribute in its accessor's type.
Elements decodedElements(const Document& doc, int accessor, std::span<const uint8_t> bytes);

// One flag an accessor: whether a primitive with the extension uses it, so that it needs no buffer view.
std::vector<bool> accessorsOfDraco(const Document& doc);

}  // namespace facet::io
