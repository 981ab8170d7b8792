#pragma once

// What the checks share while a file is looked at. Unlike the reader's Document it keeps what is wrong: each check
// takes what is well-formed and leaves the rest to the one that has told of it.

#include <cstdint>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/gltf.hpp"
#include "io/gltf_views.hpp"
#include "io/safe_files.hpp"
#include "io/validate/findings.hpp"

namespace facet::io::validate {

using Json = nlohmann::json;

// What an accessor or a buffer view is for; one thing alone.
enum class Use : uint8_t { none, vertices, indices, matrices, times, values, image, other };

struct Buffer {
  std::span<const uint8_t> bytes;  // byteLength of them; empty where they can't be had
};

struct View {
  int buffer = -1;
  uint64_t offset = 0, length = 0, stride = 0;  // stride 0: none given
  bool wellFormed = false, compressed = false;  // compressed: by meshopt, so that its bytes are not what is meant
  Use use = Use::none;
  int vertexAccessor = -1;  // that first read it without a stride
};

struct Accessor {
  bool wellFormed = false;  // componentType, count and type are valid
  bool readable = false;    // all its elements lie in bytes that are there, or are zeros
  int componentType = 0, components = 0;
  std::string type;
  uint64_t count = 0, offset = 0, componentLength = 0, elementLength = 0, stride = 0;
  int view = -1;
  bool normalized = false, hasBounds = false;
  Use use = Use::none;
  const uint8_t* data = nullptr;  // null: zeros
  struct Sparse {
    uint64_t count = 0;
    int indexType = 0;
    const uint8_t *indices = nullptr, *values = nullptr;
  } sparse;
};

struct Asset {
  std::string name;
  std::filesystem::path folder;  // canonical; empty: no files may be named
  Limits limits;
  std::span<const uint8_t> bytes;  // of the file
  bool isGlb = false, hasBinary = false;
  std::span<const uint8_t> binary;
  Json json;
  std::set<std::string> extensionsUsed, extensionsSeen;

  std::vector<Buffer> buffers;
  std::vector<View> views;
  DecodedViews decoded;  // where there are compressed views that can be read
  std::vector<Accessor> accessors;
  std::map<std::string, std::pair<int, int>> imageSizes;         // by place: width, height
  std::vector<FileBytes> files;                                  // storage
  std::vector<std::vector<uint8_t>> embedded;                    // storage
  std::map<std::string, std::vector<bool>> used;                 // by collection
  std::map<std::pair<std::string, int>, std::string> firstUser;  // by collection and index: the place that names it
  std::set<std::string> checked;              // pairs of an accessor and a check: data are read once for each
  uint64_t elementsLeft = uint64_t{1} << 30;  // to read; some seconds
  Report report;

  void add(Code code, std::string place, std::string text) {
    if (report.findings.size() < mostFindings)
      report.findings.push_back({.code = code, .place = std::move(place), .text = std::move(text)});
    else
      ++report.leftOut;
  }
};

// -- JSON; nothing throws where a type is another one --

const Json& member(const Json& object, std::string_view key);  // null where there is none, or no object
// A whole number however it is written (2, 2.0).
std::optional<int64_t> whole(const Json& value);
std::optional<int64_t> wholeAt(const Json& object, std::string_view key);
std::optional<double> numberAt(const Json& object, std::string_view key);
std::string textAt(const Json& object, std::string_view key);
const Json& extension(const Json& object, std::string_view name);  // object.extensions[name]

// The root's array "nodes", or one further down, "extensions/KHR_lights_punctual/lights"; an empty one where there is
// none.
const Json& collection(const Asset& asset, std::string_view path);
// Its element; null where there is none.
const Json& element(const Asset& asset, std::string_view path, int index);
// object[key] where it is an index into the collection, else -1.
int indexAt(const Asset& asset, const Json& object, std::string_view key, std::string_view path);

void markUsed(Asset& asset, const std::string& path, int index);

inline std::string at(std::string_view place, size_t index) { return std::string(place) + "/" + std::to_string(index); }
// With the key escaped as JSON pointers have it (RFC 6901).
std::string at(std::string_view place, std::string_view key);

std::string numberText(double value);

}  // namespace facet::io::validate
