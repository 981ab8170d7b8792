#pragma once

// Accessors: typed views of buffers (glTF 2.0, section 3.6.2). checkAccessors proves once that every element of every
// accessor lies inside its buffer; the readers rely on it.

#include <cstdint>
#include <optional>
#include <vector>

#include "io/gltf_document.hpp"

namespace facet::io {

// A strided run of elements. data is null where the accessor has no buffer view: zeros.
struct Elements {
  const uint8_t* data = nullptr;
  size_t count = 0, stride = 0;
  int componentType = 0, components = 0;
  bool normalized = false;
};

// Bytes of one element without padding between elements; 0 for an unknown type. Columns of matrices are padded to 4.
size_t elementSize(int componentType, int type);

// Doubles are KHR_accessor_float64's; they are read as floats.
constexpr bool isFloatingPoint(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_FLOAT || componentType == TINYGLTF_COMPONENT_TYPE_DOUBLE;
}

inline const tinygltf::Accessor& accessorAt(const Document& doc, int index) {
  return doc.gltf.accessors[static_cast<size_t>(index)];
}

// Errors: an index out of range, an element outside its view, a view outside its buffer, sparse indices that do not
// rise.
Result<void> checkBufferViews(const Document& doc);
Result<void> checkAccessors(const Document& doc);

// The bytes of a buffer view. Valid after checkBufferViews.
std::span<const uint8_t> viewBytes(const Document& doc, int view);

// The dense part of a checked accessor.
Elements elements(const Document& doc, int accessor);

// Into rows of `width` floats, as readFloats; without sparse substitution. data must not be null.
void convertElements(const Elements& from, bool normalized, int width, float* out);

// Reads a checked accessor with sparse substitution into rows of `width` floats, of which the first min(width,
// components) are written: integers as f = c / max (normalised; c / max >= -1 when signed) or as they are. out must
// hold min(count, limit) * width floats, zero or the default where the accessor has fewer components; what comes after
// `limit` elements is not read.
void readFloats(const Document& doc, int accessor, int width, float* out, bool alwaysNormalized = false,
                size_t limit = SIZE_MAX);

// Unsigned integers of any width; sparse included.
std::vector<uint32_t> readIndices(const Document& doc, int accessor);

}  // namespace facet::io
