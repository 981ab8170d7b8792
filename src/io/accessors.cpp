#include "io/accessors.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include "io/gltf_draco.hpp"

namespace facet::io {

namespace {

constexpr uint64_t overflow = std::numeric_limits<uint64_t>::max();
// Accessors without data cost the file nothing and us everything; real ones are sparse morph targets, of as many
// elements as others that have data.
constexpr uint64_t freeZeroElements = uint64_t{1} << 20;

// offset + stride * (count - 1) + size: one past the last byte; `overflow` when it does not fit 64 bits.
uint64_t endOf(uint64_t offset, uint64_t stride, uint64_t count, uint64_t size) {
  if (count == 0) return offset;
  uint64_t end = 0;
  if (__builtin_mul_overflow(stride, count - 1, &end)) return overflow;
  if (__builtin_add_overflow(end, offset, &end)) return overflow;
  if (__builtin_add_overflow(end, size, &end)) return overflow;
  return end;
}

std::string bytesText(uint64_t bytes) { return bytes == overflow ? "more than 2^64" : std::to_string(bytes); }

size_t componentSize(int componentType) {
  switch (componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return 8;
    default:
      return 0;
  }
}

// Bytes that `count` elements of `size` bytes need of a view from offset on; stride 0: tightly packed.
Result<void> checkRange(const Document& doc, const std::string& place, int view, uint64_t offset, uint64_t stride,
                        uint64_t count, uint64_t size) {
  if (auto ok = checkIndex(doc, view, doc.gltf.bufferViews.size(), place, "buffer view"); !ok) return ok;
  if (stride != 0 && stride < size) {
    return doc.error(place,
                     "elements of " + std::to_string(size) + " bytes lie " + std::to_string(stride) + " bytes apart");
  }
  const uint64_t end = endOf(offset, stride == 0 ? size : stride, count, size);
  const uint64_t have = doc.gltf.bufferViews[static_cast<size_t>(view)].byteLength;
  if (end > have) {
    return doc.error(place, "needs " + bytesText(end) + " bytes of buffer view " + std::to_string(view) +
                                ", which has " + std::to_string(have));
  }
  return {};
}

template <class T>
T load(const uint8_t* data) {
  T value;
  std::memcpy(&value, data, sizeof value);
  return value;
}

uint32_t loadUnsigned(const uint8_t* data, int componentType) {
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return *data;
  if (componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<uint16_t>(data);
  return load<uint32_t>(data);
}

bool isUnsigned(int componentType) {
  return componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

Result<void> checkSparse(const Document& doc, const tinygltf::Accessor& accessor, const std::string& place) {
  const auto& sparse = accessor.sparse;
  if (sparse.count < 0 || static_cast<uint64_t>(sparse.count) > accessor.count) {
    return doc.error(place + "/sparse/count", "replaces " + std::to_string(sparse.count) + " of " +
                                                  std::to_string(accessor.count) + " elements");
  }
  if (!isUnsigned(sparse.indices.componentType)) {
    return doc.error(place + "/sparse/indices/componentType",
                     std::to_string(sparse.indices.componentType) + " is no unsigned integer type");
  }
  // tinygltf 2.9 has them unsigned.
  if (static_cast<int64_t>(sparse.indices.byteOffset) < 0 || static_cast<int64_t>(sparse.values.byteOffset) < 0) {
    return doc.error(place + "/sparse", "an offset is negative");
  }
  const size_t indexSize = componentSize(sparse.indices.componentType);
  const auto count = static_cast<uint64_t>(sparse.count);
  if (auto ok = checkRange(doc, place + "/sparse/indices", sparse.indices.bufferView,
                           static_cast<uint64_t>(sparse.indices.byteOffset), 0, count, indexSize);
      !ok) {
    return ok;
  }
  if (auto ok = checkRange(doc, place + "/sparse/values", sparse.values.bufferView,
                           static_cast<uint64_t>(sparse.values.byteOffset), 0, count,
                           elementSize(accessor.componentType, accessor.type));
      !ok) {
    return ok;
  }
  const uint8_t* data = viewBytes(doc, sparse.indices.bufferView).data() + sparse.indices.byteOffset;
  int64_t last = -1;
  for (uint64_t i = 0; i < count; ++i) {
    const int64_t index = loadUnsigned(data + i * indexSize, sparse.indices.componentType);
    if (index <= last || static_cast<uint64_t>(index) >= accessor.count) {
      return doc.error(place + "/sparse/indices",
                       "index " + std::to_string(i) + " is " + std::to_string(index) +
                           (index <= last ? ", not above the one before it"
                                          : ", but there are " + std::to_string(accessor.count) + " elements"));
    }
    last = index;
  }
  return {};
}

Result<void> checkAccessor(const Document& doc, const tinygltf::Accessor& accessor, const std::string& place,
                           bool draco, uint64_t mostZeroElements) {
  const size_t size = elementSize(accessor.componentType, accessor.type);
  if (size == 0) {
    return doc.error(place + "/componentType", std::to_string(accessor.componentType) + " is not a component type");
  }
  // 32-bit indices reach no further, and no later sum of counts overflows.
  if (accessor.count > std::numeric_limits<uint32_t>::max()) {
    return doc.error(place + "/count", std::to_string(accessor.count) + " elements are more than 2^32 - 1");
  }
  if (accessor.bufferView == -1) {
    if (accessor.count > mostZeroElements && !draco) {
      return doc.error(place + "/count", std::to_string(accessor.count) +
                                             " elements without a buffer view are more than " +
                                             std::to_string(mostZeroElements));
    }
  } else {
    if (auto ok =
            checkIndex(doc, accessor.bufferView, doc.gltf.bufferViews.size(), place + "/bufferView", "buffer view");
        !ok) {
      return ok;
    }
    const auto& view = doc.gltf.bufferViews[static_cast<size_t>(accessor.bufferView)];
    if (auto ok =
            checkRange(doc, place, accessor.bufferView, accessor.byteOffset, view.byteStride, accessor.count, size);
        !ok) {
      return ok;
    }
  }
  return accessor.sparse.isSparse ? checkSparse(doc, accessor, place) : Result<void>();
}

// c -> c / largest, bounded below by -1 (glTF 2.0, section 3.6.2.2).
template <class T>
float toFloat(T value, bool normalized) {
  if constexpr (std::is_floating_point_v<T>) return static_cast<float>(value);
  if (!normalized) return static_cast<float>(value);
  const double scaled = static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max());
  return static_cast<float>(std::max(scaled, -1.0));
}

template <class T>
void convert(const uint8_t* data, size_t stride, size_t count, int components, bool normalized, int width, float* out) {
  const auto used = static_cast<size_t>(std::min(components, width));
  for (size_t i = 0; i < count; ++i, data += stride, out += width) {
    for (size_t c = 0; c < used; ++c) out[c] = toFloat(load<T>(data + c * sizeof(T)), normalized);
  }
}

}  // namespace

size_t elementSize(int componentType, int type) {
  const size_t component = componentSize(componentType);
  const auto columns = [&](size_t n) { return n * ((n * component + 3) / 4 * 4); };
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return component;
    case TINYGLTF_TYPE_VEC2:
    case TINYGLTF_TYPE_VEC3:
    case TINYGLTF_TYPE_VEC4:
      return component * static_cast<size_t>(type);
    case TINYGLTF_TYPE_MAT2:
      return columns(2);
    case TINYGLTF_TYPE_MAT3:
      return columns(3);
    case TINYGLTF_TYPE_MAT4:
      return columns(4);
    default:
      return 0;
  }
}

Result<void> checkBufferViews(const Document& doc) {
  for (size_t i = 0; i < doc.gltf.bufferViews.size(); ++i) {
    const auto& view = doc.gltf.bufferViews[i];
    const std::string place = pointer("/bufferViews", i);
    if (auto ok = checkIndex(doc, view.buffer, doc.buffers.size(), place + "/buffer", "buffer"); !ok) return ok;
    const uint64_t end = endOf(view.byteOffset, 0, 1, view.byteLength);
    const uint64_t have = doc.buffers[static_cast<size_t>(view.buffer)].size();
    if (end > have) {
      return doc.error(place, "ends at byte " + bytesText(end) + " of buffer " + std::to_string(view.buffer) +
                                  ", which has " + std::to_string(have));
    }
  }
  return {};
}

Result<void> checkAccessors(const Document& doc) {
  const std::vector<bool> draco = accessorsOfDraco(doc);
  uint64_t most = freeZeroElements;
  for (size_t i = 0; i < doc.gltf.accessors.size(); ++i) {
    const auto& accessor = doc.gltf.accessors[i];
    if (draco[i] || accessor.bufferView >= 0) most = std::max<uint64_t>(most, accessor.count);
  }
  for (size_t i = 0; i < doc.gltf.accessors.size(); ++i) {
    if (auto ok = checkAccessor(doc, doc.gltf.accessors[i], pointer("/accessors", i), draco[i], most); !ok) return ok;
  }
  return {};
}

std::span<const uint8_t> viewBytes(const Document& doc, int view) {
  const auto& v = doc.gltf.bufferViews[static_cast<size_t>(view)];
  return doc.buffers[static_cast<size_t>(v.buffer)].subspan(v.byteOffset, v.byteLength);
}

Elements elements(const Document& doc, int accessor) {
  const auto& a = doc.gltf.accessors[static_cast<size_t>(accessor)];
  Elements result;
  result.count = a.count;
  result.componentType = a.componentType;
  result.components = tinygltf::GetNumComponentsInType(static_cast<uint32_t>(a.type));
  result.normalized = a.normalized;
  result.stride = elementSize(a.componentType, a.type);
  if (a.bufferView >= 0) {
    const size_t stride = doc.gltf.bufferViews[static_cast<size_t>(a.bufferView)].byteStride;
    if (stride != 0) result.stride = stride;
    result.data = viewBytes(doc, a.bufferView).data() + a.byteOffset;
  }
  return result;
}

void convertElements(const Elements& from, bool normalized, int width, float* out) {
  const auto run = [&]<class T>(T) {
    convert<T>(from.data, from.stride, from.count, from.components, normalized, width, out);
  };
  switch (from.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return run(int8_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return run(uint8_t{});
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return run(int16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return run(uint16_t{});
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return run(uint32_t{});
    case TINYGLTF_COMPONENT_TYPE_DOUBLE:
      return run(double{});
    default:
      break;
  }
  const size_t tight = static_cast<size_t>(width) * sizeof(float);
  if (from.components == width && from.stride == tight && from.count > 0) {
    std::memcpy(out, from.data, tight * from.count);
  } else {
    run(float{});
  }
}

void readFloats(const Document& doc, int accessor, int width, float* out, bool alwaysNormalized, size_t limit) {
  const auto& a = doc.gltf.accessors[static_cast<size_t>(accessor)];
  Elements from = elements(doc, accessor);
  const bool normalized = from.normalized || alwaysNormalized;
  from.count = std::min(from.count, limit);
  if (from.data != nullptr) {
    convertElements(from, normalized, width, out);
  } else {
    const auto used = static_cast<size_t>(std::min(from.components, width));
    for (size_t i = 0; i < from.count; ++i) std::fill_n(out + i * static_cast<size_t>(width), used, 0.0f);
  }
  if (!a.sparse.isSparse) return;
  const int indexType = a.sparse.indices.componentType;
  const uint8_t* indices = viewBytes(doc, a.sparse.indices.bufferView).data() + a.sparse.indices.byteOffset;
  const uint8_t* values = viewBytes(doc, a.sparse.values.bufferView).data() + a.sparse.values.byteOffset;
  from.stride = elementSize(a.componentType, a.type);
  from.count = 1;
  for (int i = 0; i < a.sparse.count; ++i) {
    const uint32_t index = loadUnsigned(indices + static_cast<size_t>(i) * componentSize(indexType), indexType);
    if (index >= limit) break;  // they rise
    from.data = values + static_cast<size_t>(i) * from.stride;
    convertElements(from, normalized, width, out + static_cast<size_t>(index) * static_cast<size_t>(width));
  }
}

std::vector<uint32_t> readIndices(const Document& doc, int accessor) {
  const auto& a = doc.gltf.accessors[static_cast<size_t>(accessor)];
  const Elements from = elements(doc, accessor);
  std::vector<uint32_t> indices(from.count);
  if (from.data != nullptr && from.componentType == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT && from.stride == 4) {
    if (from.count > 0) std::memcpy(indices.data(), from.data, from.count * 4);
  } else if (from.data != nullptr) {
    for (size_t i = 0; i < from.count; ++i) indices[i] = loadUnsigned(from.data + i * from.stride, from.componentType);
  }
  if (!a.sparse.isSparse) return indices;
  const int indexType = a.sparse.indices.componentType;
  const uint8_t* places = viewBytes(doc, a.sparse.indices.bufferView).data() + a.sparse.indices.byteOffset;
  const uint8_t* values = viewBytes(doc, a.sparse.values.bufferView).data() + a.sparse.values.byteOffset;
  for (size_t i = 0; i < static_cast<size_t>(a.sparse.count); ++i) {
    const uint32_t place = loadUnsigned(places + i * componentSize(indexType), indexType);
    indices[place] = loadUnsigned(values + i * componentSize(a.componentType), a.componentType);
  }
  return indices;
}

}  // namespace facet::io
