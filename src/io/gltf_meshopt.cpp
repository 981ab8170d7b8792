// EXT_meshopt_compression and KHR_meshopt_compression, which adds a filter for colours and a version 1 of the vertex
// codec: buffer views whose bytes are decoded before anything looks at them.

#include <meshoptimizer.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/parallel.hpp"
#include "io/json_section.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

constexpr const char* extensionNames[] = {"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr size_t khr = 1;
constexpr const char* meshoptRemedy = "export the model again, or without meshopt compression";

enum class Mode { attributes, triangles, indices };
enum class Filter { none, octahedral, quaternion, exponential, color };

struct Named {
  std::string_view name;
  int value;
};
constexpr Named modes[] = {{"ATTRIBUTES", static_cast<int>(Mode::attributes)},
                           {"TRIANGLES", static_cast<int>(Mode::triangles)},
                           {"INDICES", static_cast<int>(Mode::indices)}};
constexpr Named filters[] = {{"NONE", static_cast<int>(Filter::none)},
                             {"OCTAHEDRAL", static_cast<int>(Filter::octahedral)},
                             {"QUATERNION", static_cast<int>(Filter::quaternion)},
                             {"EXPONENTIAL", static_cast<int>(Filter::exponential)},
                             {"COLOR", static_cast<int>(Filter::color)}};  // KHR only

struct CompressedView {
  size_t view = 0;
  std::string place;  // of the extension
  std::span<const uint8_t> encoded;
  uint64_t count = 0, stride = 0;
  Mode mode = Mode::attributes;
  Filter filter = Filter::none;
  std::vector<uint8_t> decoded;
  int status = 0;  // of the decoder

  uint64_t bytes() const { return count * stride; }  // both are below 2^32
};

// A whole number below 2^53; missing ones become `otherwise`, or an error where there is none.
Result<uint64_t> whole(const Document& doc, const Json& object, const char* key, const std::string& place,
                       std::optional<uint64_t> otherwise = {}) {
  const auto found = object.find(key);
  if (found == object.end() && otherwise) return *otherwise;
  if (found == object.end()) return doc.error(place + "/" + key, "is missing", meshoptRemedy);
  if (!found->is_number_unsigned() || found->get<uint64_t>() >> 53 != 0) {
    return doc.error(place + "/" + key, "is not a whole number of 0 to 2^53 - 1", meshoptRemedy);
  }
  return found->get<uint64_t>();
}

Result<int> named(const Document& doc, const Json& object, const char* key, const std::string& place,
                  std::span<const Named> table, std::optional<int> otherwise = {}) {
  const auto found = object.find(key);
  if (found == object.end() && otherwise) return *otherwise;
  const std::string text = found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
  std::string known;
  for (const Named& entry : table) {
    if (text == entry.name) return entry.value;
    known += (known.empty() ? "" : ", ") + std::string(entry.name);
  }
  return doc.error(place + "/" + key, inQuotes(text) + " is none of " + known, meshoptRemedy);
}

// The extension's table of valid strides and counts.
Result<void> checkLayout(const Document& doc, const CompressedView& v) {
  const auto wrong = [&](const char* key, uint64_t value, const char* rule) {
    return doc.error(v.place + "/" + key, std::to_string(value) + " is not " + rule, meshoptRemedy);
  };
  if (v.mode == Mode::attributes) {
    if (v.stride == 0 || v.stride > 256 || v.stride % 4 != 0) {
      return wrong("byteStride", v.stride, "a multiple of 4 up to 256, as the mode ATTRIBUTES asks for");
    }
  } else {
    if (v.stride != 2 && v.stride != 4) return wrong("byteStride", v.stride, "2 or 4, as indices ask for");
    if (v.filter != Filter::none)
      return doc.error(v.place + "/filter", "filters are for the mode ATTRIBUTES", meshoptRemedy);
  }
  if (v.mode == Mode::triangles && v.count % 3 != 0) return wrong("count", v.count, "a multiple of 3");
  if (v.filter == Filter::octahedral && v.stride != 4 && v.stride != 8) {
    return wrong("byteStride", v.stride, "4 or 8, as the filter OCTAHEDRAL asks for");
  }
  if (v.filter == Filter::color && v.stride != 4 && v.stride != 8) {
    return wrong("byteStride", v.stride, "4 or 8, as the filter COLOR asks for");
  }
  if (v.filter == Filter::quaternion && v.stride != 8) {
    return wrong("byteStride", v.stride, "8, as the filter QUATERNION asks for");
  }
  return {};
}

// The densest mode, ATTRIBUTES, spends two bits on sixteen bytes.
constexpr uint64_t largestMeshoptRatio = 64;

Result<void> checkSizes(const Document& doc, const CompressedView& v) {
  const auto& view = doc.gltf.bufferViews[v.view];
  if (v.count > std::numeric_limits<uint32_t>::max()) {
    return doc.error(v.place + "/count", std::to_string(v.count) + " elements are more than 2^32 - 1", meshoptRemedy);
  }
  if (view.byteStride != 0 && view.byteStride != v.stride) {
    return doc.error(v.place + "/byteStride",
                     "is " + std::to_string(v.stride) + ", but the buffer view's is " + std::to_string(view.byteStride),
                     meshoptRemedy);
  }
  if (v.bytes() != view.byteLength) {
    return doc.error(v.place + "/count",
                     std::to_string(v.count) + " elements of " + std::to_string(v.stride) + " bytes do not make the " +
                         std::to_string(view.byteLength) + " bytes of the buffer view",
                     meshoptRemedy);
  }
  if (v.bytes() / largestMeshoptRatio > v.encoded.size()) {
    return doc.error(v.place + "/byteLength",
                     std::to_string(v.encoded.size()) + " bytes are too few to decode to " + std::to_string(v.bytes()),
                     meshoptRemedy);
  }
  return {};
}

Result<std::span<const uint8_t>> encodedBytes(const Document& doc, const Json& extension, const std::string& place) {
  const auto buffer = whole(doc, extension, "buffer", place);
  if (!buffer) return tl::unexpected(buffer.error());
  const auto offset = whole(doc, extension, "byteOffset", place, 0);
  if (!offset) return tl::unexpected(offset.error());
  const auto length = whole(doc, extension, "byteLength", place);
  if (!length) return tl::unexpected(length.error());
  if (*buffer >= doc.buffers.size()) {
    return doc.error(
        place + "/buffer",
        "buffer " + std::to_string(*buffer) + " does not exist; there are " + std::to_string(doc.buffers.size()),
        meshoptRemedy);
  }
  if (doc.isFallback[*buffer]) {
    return doc.error(place + "/buffer", "buffer " + std::to_string(*buffer) + " is a fallback, which holds no data",
                     meshoptRemedy);
  }
  const auto bytes = doc.buffers[*buffer];
  if (*offset + *length > bytes.size()) {
    return doc.error(place,
                     "ends at byte " + std::to_string(*offset + *length) + " of buffer " + std::to_string(*buffer) +
                         ", which has " + std::to_string(bytes.size()),
                     meshoptRemedy);
  }
  return bytes.subspan(*offset, *length);
}

Result<CompressedView> readExtension(const Document& doc, const Json& extension, size_t name, size_t view) {
  CompressedView v;
  v.view = view;
  v.place = pointer("/bufferViews", view) + "/extensions/" + extensionNames[name];
  const auto encoded = encodedBytes(doc, extension, v.place);
  if (!encoded) return tl::unexpected(encoded.error());
  v.encoded = *encoded;
  const auto stride = whole(doc, extension, "byteStride", v.place);
  if (!stride) return tl::unexpected(stride.error());
  v.stride = *stride;
  const auto count = whole(doc, extension, "count", v.place);
  if (!count) return tl::unexpected(count.error());
  v.count = *count;
  const auto mode = named(doc, extension, "mode", v.place, modes);
  if (!mode) return tl::unexpected(mode.error());
  v.mode = static_cast<Mode>(*mode);
  const std::span<const Named> known(filters, std::size(filters) - (name == khr ? 0 : 1));
  const auto filter = named(doc, extension, "filter", v.place, known, 0);
  if (!filter) return tl::unexpected(filter.error());
  v.filter = static_cast<Filter>(*filter);
  if (auto ok = checkLayout(doc, v); !ok) return tl::unexpected(ok.error());
  if (auto ok = checkSizes(doc, v); !ok) return tl::unexpected(ok.error());
  return v;
}

// KHR_meshopt_compression, appendix B, filter 4: y, co, cg of K bits and alpha of K - 1 bits under a bit that is set,
// so that its place tells K. Alpha 0 has no such bit: not valid, black and transparent here.
template <class Unsigned>
void decodeColors(uint8_t* data, uint64_t count) {
  using Signed = std::make_signed_t<Unsigned>;
  constexpr auto largest = static_cast<float>(std::numeric_limits<Unsigned>::max());
  for (uint64_t i = 0; i < count; ++i, data += 4 * sizeof(Unsigned)) {
    Unsigned in[4];
    std::memcpy(in, data, sizeof in);
    const int y = in[0], co = static_cast<Signed>(in[1]), cg = static_cast<Signed>(in[2]);
    const int one = (1 << std::bit_width(in[3])) - 1;
    const int alpha = in[3] & (one >> 1);
    const int rgba[4] = {y + co - cg, y + cg, y - co - cg, alpha << 1 | (alpha & 1)};
    Unsigned out[4];
    for (int c = 0; c < 4; ++c) {
      const float value = one > 0 ? std::round(static_cast<float>(rgba[c]) * (largest / static_cast<float>(one))) : 0;
      out[c] = static_cast<Unsigned>(std::clamp(value, 0.0f, largest));
    }
    std::memcpy(data, out, sizeof out);
  }
}

constexpr int outOfMemory = 1;  // beside the library's 0 (good), -1, -2 and -3

void decode(CompressedView& v) {
  try {
    v.decoded.resize(v.bytes());
  } catch (const std::bad_alloc&) {
    v.status = outOfMemory;
    return;
  }
  uint8_t* to = v.decoded.data();
  const uint8_t* from = v.encoded.data();
  const size_t size = v.encoded.size();
  if (v.mode == Mode::triangles) {
    v.status = meshopt_decodeIndexBuffer(to, v.count, v.stride, from, size);
  } else if (v.mode == Mode::indices) {
    v.status = meshopt_decodeIndexSequence(to, v.count, v.stride, from, size);
  } else {
    v.status = meshopt_decodeVertexBuffer(to, v.count, v.stride, from, size);
  }
  if (v.status != 0) return;
  if (v.filter == Filter::octahedral) meshopt_decodeFilterOct(to, v.count, v.stride);
  if (v.filter == Filter::quaternion) meshopt_decodeFilterQuat(to, v.count, v.stride);
  if (v.filter == Filter::exponential) meshopt_decodeFilterExp(to, v.count, v.stride);
  if (v.filter == Filter::color)
    v.stride == 4 ? decodeColors<uint8_t>(to, v.count) : decodeColors<uint16_t>(to, v.count);
}

std::string problemOf(const CompressedView& v) {
  const std::string mode(modes[static_cast<size_t>(v.mode)].name);
  const std::string elements = std::to_string(v.count) + " elements";
  if (v.status == outOfMemory) return "there is not enough memory for its " + elements;
  constexpr uint8_t vertexVersion1 = 0xa1;
  if (v.status == -1 && v.mode == Mode::attributes && !v.encoded.empty() && v.encoded[0] == vertexVersion1)
    return "its data is of version 1 of the vertex codec, which the meshoptimizer library in use cannot read";
  if (v.status == -1) return "its data does not begin as the mode " + mode + " asks for";
  if (v.status == -2) return "its data ends before " + elements + " are decoded";
  if (v.status == -3) return "its data has not the length that " + elements + " take";
  return "its data cannot be decoded";
}

Result<std::vector<CompressedView>> readExtensions(const Document& doc) {
  const auto views = section(doc, "bufferViews");
  if (!views) return tl::unexpected(views.error());
  std::vector<CompressedView> found;
  for (size_t i = 0; i < doc.gltf.bufferViews.size() && i < views->size(); ++i) {
    const int buffer = doc.gltf.bufferViews[i].buffer;
    const std::string place = pointer("/bufferViews", i);
    if (auto ok = checkIndex(doc, buffer, doc.buffers.size(), place + "/buffer", "buffer"); !ok) {
      return tl::unexpected(ok.error());
    }
    const Json* extension = nullptr;
    for (size_t name = 0; name < std::size(extensionNames) && extension == nullptr; ++name) {
      extension = extensionOf((*views)[i], extensionNames[name]);
      if (extension == nullptr) continue;
      auto view = readExtension(doc, *extension, name, i);
      if (!view) return tl::unexpected(view.error());
      found.push_back(std::move(*view));
    }
    if (extension == nullptr && doc.isFallback[static_cast<size_t>(buffer)]) {
      return doc.error(place + "/buffer",
                       "buffer " + std::to_string(buffer) + " is a fallback, which only compressed views may use",
                       meshoptRemedy);
    }
  }
  return found;
}

}  // namespace

Result<void> decodeMeshopt(Document& doc) {
  bool used = std::find(doc.isFallback.begin(), doc.isFallback.end(), true) != doc.isFallback.end();
  for (const auto& view : doc.gltf.bufferViews)
    for (const char* name : extensionNames) used = used || view.extensions.count(name) > 0;
  if (!used) return {};
  auto views = readExtensions(doc);
  if (!views) return tl::unexpected(views.error());
  for (const CompressedView& v : *views) {
    if (v.bytes() > doc.limits.totalBytes - std::min(doc.bytesRead, doc.limits.totalBytes)) {
      return doc.error(v.place,
                       "with its " + std::to_string(v.bytes()) + " bytes the model has more than the limit of " +
                           std::to_string(doc.limits.totalBytes),
                       "use a smaller model");
    }
    doc.bytesRead += v.bytes();
  }
  parallelFor(views->size(), [&](size_t i) { decode((*views)[i]); });
  for (CompressedView& v : *views) {
    if (v.status != 0) return doc.error(v.place, problemOf(v), meshoptRemedy);
    auto& view = doc.gltf.bufferViews[v.view];
    view.buffer = static_cast<int>(doc.buffers.size());
    view.byteOffset = 0;
    doc.embedded.push_back(std::move(v.decoded));
    doc.buffers.push_back(doc.embedded.back());
  }
  return {};
}

}  // namespace facet::io
