#include <algorithm>

#include "io/uri.hpp"
#include "io/validate/checks.hpp"
#include "io/validate/resources.hpp"

namespace facet::io::validate {

namespace {

// A stand-in for compressed data, which need not be there.
bool isFallback(const Json& buffer) {
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
    if (member(extension(buffer, name), "fallback") == true) return true;
  return false;
}

std::optional<std::span<const uint8_t>> bytesOf(Asset& asset, const Json& buffer, size_t i, const std::string& place) {
  const Json& uri = member(buffer, "uri");
  if (uri.is_string()) {
    const auto& text = uri.get_ref<const std::string&>();
    if (isDataUri(text)) {
      const std::string type = mediaTypeOf(text);
      if (type != "application/octet-stream" && type != "application/gltf-buffer") {
        asset.add(Code::BUFFER_DATA_URI_MIME_TYPE_INVALID, place + "/uri",
                  "the data: URI is " + inQuotes(type) + ", not application/octet-stream");
      }
    }
    return readUri(asset, text, place + "/uri");
  }
  if (!uri.is_null() || i != 0 || !asset.isGlb) return std::nullopt;
  if (asset.hasBinary) return asset.binary;
  asset.add(Code::BUFFER_MISSING_GLB_DATA, place, "has no uri, and the file has no binary chunk");
  return std::nullopt;
}

}  // namespace

std::string mediaTypeOf(std::string_view uri) {
  uri.remove_prefix(std::min(uri.size(), uri.find(':') + 1));
  std::string type(uri.substr(0, std::min(uri.find(';'), uri.find(','))));
  std::ranges::transform(type, type.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 'a' - 'A') : c; });
  return type.empty() ? "text/plain" : type;
}

std::optional<std::span<const uint8_t>> readUri(Asset& asset, const std::string& uri, const std::string& place) {
  if (isDataUri(uri)) {
    if (asset.isGlb) {
      asset.add(Code::URI_GLB, place, "a .glb has a URI");
      asset.add(Code::DATA_URI_GLB, place, "a .glb holds a data: URI");
    }
    auto bytes = decodeDataUri(uri);
    if (!bytes) {
      asset.add(Code::INVALID_URI, place, "the data: URI is malformed");
      return std::nullopt;
    }
    asset.embedded.push_back(std::move(*bytes));
    return std::span<const uint8_t>(asset.embedded.back());
  }
  if (asset.isGlb) asset.add(Code::URI_GLB, place, "a .glb names a file outside it");
  if (hasScheme(uri) || uri.starts_with('/'))
    asset.add(Code::NON_RELATIVE_URI, place, inQuotes(uri) + " is not relative");
  uint64_t read = 0;
  for (const FileBytes& file : asset.files) read += file.size;
  const auto path = resolveBelow(asset.folder, uri, asset.limits.allowOutside);
  const uint64_t left = asset.limits.totalBytes - std::min(asset.limits.totalBytes, read);
  auto bytes = path ? readRegularFile(*path, std::min(asset.limits.fileBytes, left)) : tl::unexpected(path.error());
  if (!bytes) {
    asset.add(Code::IO_ERROR, place, inQuotes(uri) + ": " + bytes.error().problem);
    return std::nullopt;
  }
  asset.files.push_back(std::move(*bytes));
  return asset.files.back().span();
}

void readBuffers(Asset& asset) {
  const Json& list = collection(asset, "buffers");
  asset.buffers.resize(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string place = at("/buffers", i);
    const auto bytes = bytesOf(asset, list[i], i, place);
    const auto length = wholeAt(list[i], "byteLength");
    if (!bytes || isFallback(list[i]) || !length || *length < 1) continue;
    const auto wanted = static_cast<uint64_t>(*length);
    if (bytes->size() < wanted) {
      asset.add(
          Code::BUFFER_BYTE_LENGTH_MISMATCH, place,
          "has " + std::to_string(bytes->size()) + " bytes of the " + std::to_string(wanted) + " that byteLength says");
    } else {
      const bool isChunk = bytes->data() == asset.binary.data() && asset.hasBinary;
      if (isChunk && bytes->size() - wanted > 3)
        asset.add(
            Code::BUFFER_GLB_CHUNK_TOO_BIG, place,
            "the binary chunk has " + std::to_string(bytes->size() - wanted) + " bytes more than byteLength says");
      asset.buffers[i].bytes = bytes->first(wanted);
    }
  }
}

namespace {

void checkStride(Asset& asset, const Json& view, const View& read, const std::string& place) {
  if (read.stride == 0) return;
  const std::string at = place + "/byteStride";
  if (read.length > 0 && read.stride > read.length)
    asset.add(Code::BUFFER_VIEW_TOO_BIG_BYTE_STRIDE, at,
              std::to_string(read.stride) + " is greater than byteLength " + std::to_string(read.length));
  if (read.stride % 4 != 0)
    asset.add(Code::VALUE_MULTIPLE_OF, at, std::to_string(read.stride) + " is no multiple of 4");
  if (wholeAt(view, "target") == 34963)
    asset.add(Code::BUFFER_VIEW_INVALID_BYTE_STRIDE, at, "the view is for indices, which lie without gaps");
}

}  // namespace

void readViews(Asset& asset) {
  const Json& list = collection(asset, "bufferViews");
  asset.views.resize(list.size());
  for (size_t i = 0; i < list.size(); ++i) {
    const std::string place = at("/bufferViews", i);
    View& view = asset.views[i];
    const auto number = [&](const char* key, int64_t least) {
      const auto value = wholeAt(list[i], key);
      return value && *value >= least ? static_cast<uint64_t>(*value) : 0;
    };
    view.offset = number("byteOffset", 0);
    view.length = number("byteLength", 1);
    view.stride = number("byteStride", 4);
    if (view.stride > 252) view.stride = 0;
    const auto target = wholeAt(list[i], "target");
    if (target == 34962) view.use = Use::vertices;
    if (target == 34963) view.use = Use::indices;
    for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"})
      view.compressed = view.compressed || extension(list[i], name).is_object();
    checkStride(asset, list[i], view, place);
    view.buffer = indexAt(asset, list[i], "buffer", "buffers");
    if (view.buffer < 0 || view.length == 0) continue;
    view.wellFormed = true;
    const auto have = wholeAt(element(asset, "buffers", view.buffer), "byteLength");
    if (!have || *have < 1) continue;
    const auto length = static_cast<uint64_t>(*have);
    if (view.offset >= length)
      asset.add(Code::BUFFER_VIEW_TOO_LONG, place + "/byteOffset",
                "begins at " + std::to_string(view.offset) + " of the buffer's " + std::to_string(length) + " bytes");
    else if (view.length > length - view.offset)
      asset.add(Code::BUFFER_VIEW_TOO_LONG, place + "/byteLength",
                "ends " + std::to_string(view.length - (length - view.offset)) + " bytes behind the buffer's end");
  }
}

void decodeCompressed(Asset& asset) {
  if (std::ranges::none_of(asset.views, &View::compressed)) return;
  auto decoded = decodeViews(asset.bytes, asset.name, asset.folder, asset.limits);
  if (decoded)
    asset.decoded = std::move(*decoded);
  else
    asset.add(Code::FACET_NOT_CHECKED, decoded.error().place,
              "what is compressed can't be read: " + decoded.error().problem);
}

std::span<const uint8_t> bytesOf(const Asset& asset, int view) {
  if (view < 0 || static_cast<size_t>(view) >= asset.views.size()) return {};
  const View& v = asset.views[static_cast<size_t>(view)];
  if (!v.wellFormed) return {};
  if (v.compressed) {
    const auto& decoded = asset.decoded.bytes;
    const bool there =
        static_cast<size_t>(view) < decoded.size() && decoded[static_cast<size_t>(view)].size() == v.length;
    return there ? decoded[static_cast<size_t>(view)] : std::span<const uint8_t>();
  }
  const auto bytes = asset.buffers[static_cast<size_t>(v.buffer)].bytes;
  if (v.offset > bytes.size() || v.length > bytes.size() - v.offset) return {};
  return bytes.subspan(v.offset, v.length);
}

void useView(Asset& asset, int view, Use use, const std::string& place) {
  if (view < 0) return;
  View& v = asset.views[static_cast<size_t>(view)];
  constexpr const char* words[] = {"nothing", "vertices", "indices",  "matrices",
                                   "keys",    "keys",     "an image", "other data"};
  if (v.use == Use::none) {
    v.use = use;
    if (use == Use::vertices || use == Use::indices)
      asset.add(Code::BUFFER_VIEW_TARGET_MISSING, place,
                std::string("buffer view ") + std::to_string(view) + " has no target");
  } else if (v.use != use) {
    asset.add(
        Code::BUFFER_VIEW_TARGET_OVERRIDE, place,
        "buffer view " + std::to_string(view) + " is for " + words[size_t(v.use)] + ", not for " + words[size_t(use)]);
  }
}

}  // namespace facet::io::validate
