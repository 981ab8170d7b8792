// Buffers and images: the two sections whose bytes lie outside the JSON. They are read here and taken out of the text
// that tinygltf gets, so that it never sees a file name, never copies a buffer and never decodes an image.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/accessors.hpp"
#include "io/json_section.hpp"
#include "io/uri.hpp"

namespace facet::io {

using Json = nlohmann::json;

Result<Json> section(const Document& doc, std::string_view key) {
  const JsonMember* member = doc.outline.find(key);
  if (member == nullptr) return Json::array();
  const std::string_view text = doc.json.substr(member->begin, member->end - member->begin);
  Json value = Json::parse(text.begin(), text.end(), nullptr, false);
  const std::string place = "/" + std::string(key);
  if (value.is_discarded()) return doc.error(place, "is not valid JSON");
  if (!value.is_array()) return doc.error(place, "is not an array");
  for (size_t i = 0; i < value.size(); ++i) {
    if (!value[i].is_object()) return doc.error(pointer(place, i), "is not an object");
  }
  return value;
}

const Json* extensionOf(const Json& object, const char* name) {
  const auto extensions = object.find("extensions");
  if (extensions == object.end() || !extensions->is_object()) return nullptr;
  const auto found = extensions->find(name);
  return found != extensions->end() && found->is_object() ? &*found : nullptr;
}

std::string stringAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Result<int> readIndex(const Document& doc, const Json& value, size_t count, const std::string& place,
                      const char* what) {
  if (!value.is_number_integer()) return doc.error(place, "is not a whole number");
  const bool fits = value.is_number_unsigned() && value.get<uint64_t>() < std::min<uint64_t>(count, INT32_MAX);
  if (fits) return value.get<int>();
  return doc.error(place, what + (" " + value.dump()) + " does not exist; there are " + std::to_string(count));
}

namespace {

// Null where the key is missing or holds something else than a string.
const std::string* textAt(const Json& object, const char* key) {
  const auto found = object.find(key);
  return found != object.end() && found->is_string() ? &found->get_ref<const std::string&>() : nullptr;
}

Result<std::filesystem::path> resolve(Document& doc, const std::string& uri, const std::string& place) {
  auto path = resolveBelow(doc.folder, uri, doc.limits.allowOutside);
  std::error_code code;
  if (uri.find('\\') != std::string::npos && !(path && std::filesystem::exists(*path, code))) {
    std::string slashes = uri;
    std::ranges::replace(slashes, '\\', '/');
    const auto other = resolveBelow(doc.folder, slashes, doc.limits.allowOutside);
    if (other && std::filesystem::exists(*other, code)) {
      doc.info(place, "its backslashes are taken for slashes");
      return other;
    }
  }
  if (path) return path;
  auto failed = doc.error(place, path.error().problem, path.error().remedy);
  failed.value().about = path.error().about;
  return failed;
}

Result<std::span<const uint8_t>> fileBuffer(Document& doc, const std::string& uri, const std::string& place) {
  const auto path = resolve(doc, uri, place);
  if (!path) return tl::unexpected(path.error());
  const uint64_t left = doc.limits.totalBytes - std::min(doc.bytesRead, doc.limits.totalBytes);
  auto bytes = readRegularFile(*path, std::min(doc.limits.fileBytes, left));
  if (!bytes) {
    return doc.error(place, "the file " + inQuotes(uri) + ": " + bytes.error().problem,
                     bytes.error().problem == "no such file" ? "put the file beside the model" : bytes.error().remedy);
  }
  doc.bytesRead += bytes->size;
  doc.files.push_back(std::move(*bytes));
  return doc.files.back().span();
}

Result<std::span<const uint8_t>> bufferBytes(Document& doc, const Json& buffer, size_t index,
                                             const std::string& place) {
  const std::string* uri = textAt(buffer, "uri");
  if (uri == nullptr) {
    if (index == 0 && doc.hasBinary) return doc.binary;
    return doc.error(place, "has no uri", "embed the buffer or name its file");
  }
  return bytesOfUri(doc, *uri, place + "/uri");
}

// A stand-in for what EXT or KHR_meshopt_compression hold compressed: marked as such, or, where the file requires the
// extension, without any data.
bool isFallback(const Document& doc, const Json& buffer, size_t index) {
  const auto& required = doc.model.extensionsRequired;
  for (const char* name : {"EXT_meshopt_compression", "KHR_meshopt_compression"}) {
    const Json* meshopt = extensionOf(buffer, name);
    if (meshopt && meshopt->value("fallback", Json()) == true) return true;
    const bool hasData = buffer.contains("uri") || (index == 0 && doc.hasBinary);
    if (!hasData && std::find(required.begin(), required.end(), name) != required.end()) return true;
  }
  return false;
}

// Whether a buffer view names it, itself or by an extension.
bool viewUses(const Document& doc, size_t buffer) {
  const auto names = [&](const Json& object) {
    const auto found = object.is_object() ? object.find("buffer") : object.end();
    return object.is_object() && found != object.end() && *found == buffer;
  };
  const auto views = section(doc, "bufferViews");
  return !views || std::ranges::any_of(*views, [&](const Json& view) {
    const auto extensions = view.find("extensions");
    return names(view) || (extensions != view.end() && std::ranges::any_of(*extensions, names));
  });
}

Result<void> readBuffer(Document& doc, const Json& buffer, size_t index) {
  const std::string place = pointer("/buffers", index);
  const auto length = buffer.find("byteLength");
  if (length == buffer.end() || !length->is_number_unsigned()) {
    return doc.error(place + "/byteLength", "is not a positive whole number");
  }
  const auto bytes = length->get<uint64_t>();
  if (bytes == 0) return doc.error(place + "/byteLength", "the buffer has a length of zero");
  doc.isFallback.push_back(isFallback(doc, buffer, index));
  if (doc.isFallback.back()) {  // for readers that do not know the extension: not read, often not there
    doc.buffers.emplace_back();
    return {};
  }
  const auto span = bufferBytes(doc, buffer, index, place);
  if (!span && !viewUses(doc, index)) {
    doc.info(span.error().place, span.error().problem + ": nothing uses the buffer");
    doc.buffers.emplace_back();
    return {};
  }
  if (!span) return tl::unexpected(span.error());
  if (span->size() < bytes) {
    return doc.error(place, "should have " + std::to_string(bytes) + " bytes and has " + std::to_string(span->size()),
                     "copy or download the model again");
  }
  doc.buffers.push_back(span->first(bytes));
  return {};
}

std::string lastPart(const std::string& uri) {
  const std::string path = percentDecode(uri);
  return path.substr(path.rfind('/') + 1);
}

void imageFromView(const Document& doc, const Json& image, scene::Image& result) {
  const auto view = image.find("bufferView");
  if (view == image.end() || !view->is_number_integer()) {
    result.problem = "it has neither a file nor data";
    return;
  }
  const auto index = view->get<int64_t>();
  const auto count = static_cast<int64_t>(doc.gltf.bufferViews.size());
  if (index < 0 || index >= count) {
    result.problem = "buffer view " + std::to_string(index) + " does not exist; there are " + std::to_string(count);
    return;
  }
  const auto bytes = viewBytes(doc, static_cast<int>(index));
  result.encoded.assign(bytes.begin(), bytes.end());
}

void imageFromUri(Document& doc, const std::string& uri, const std::string& place, scene::Image& result) {
  if (isDataUri(uri)) {
    auto bytes = decodeDataUri(uri);
    if (bytes) {
      result.encoded = std::move(*bytes);
    } else {
      result.problem = "its data: URI is malformed";
    }
    return;
  }
  const auto path = resolve(doc, uri, place + "/uri");
  std::error_code code;
  if (!path) {
    result.problem = path.error().problem;
    result.outside = path.error().about == Setting::allowOutside;
  } else if (!std::filesystem::exists(*path, code)) {
    result.problem = "the file " + inQuotes(uri) + " does not exist";
  } else if (!std::filesystem::is_regular_file(*path, code)) {
    result.problem = inQuotes(uri) + " is not a regular file";
  } else {
    result.file = *path;
  }
}

}  // namespace

Result<std::span<const uint8_t>> bytesOfUri(Document& doc, const std::string& uri, const std::string& place) {
  if (!isDataUri(uri)) return fileBuffer(doc, uri, place);
  auto bytes = decodeDataUri(uri);
  if (!bytes) return doc.error(place, "the data: URI is malformed");
  doc.bytesRead += bytes->size();
  doc.embedded.push_back(std::move(*bytes));
  return std::span<const uint8_t>(doc.embedded.back());
}

Json rootExtension(const Document& doc, const char* name) {
  const JsonMember* member = doc.outline.find("extensions");
  if (member == nullptr) return nullptr;
  const Json all = Json::parse(doc.json.substr(member->begin, member->end - member->begin), nullptr, false);
  return all.is_object() && all.contains(name) ? all[name] : Json(nullptr);
}

Result<void> readBuffers(Document& doc) {
  const auto buffers = section(doc, "buffers");
  if (!buffers) return tl::unexpected(buffers.error());
  for (size_t i = 0; i < buffers->size(); ++i) {
    if (auto ok = readBuffer(doc, (*buffers)[i], i); !ok) return ok;
  }
  return {};
}

Result<void> readImages(Document& doc) {
  const auto images = section(doc, "images");
  if (!images) return tl::unexpected(images.error());
  for (size_t i = 0; i < images->size(); ++i) {
    const Json& image = (*images)[i];
    const std::string place = pointer("/images", i);
    const std::string *name = textAt(image, "name"), *uri = textAt(image, "uri");
    scene::Image result;
    result.name = name && !name->empty() ? *name : uri && !isDataUri(*uri) ? lastPart(*uri) : place.substr(1);
    uri ? imageFromUri(doc, *uri, place, result) : imageFromView(doc, image, result);
    if ((!name || name->empty()) && !result.file.empty()) result.name = result.file.filename().string();
    doc.model.images.push_back(std::move(result));
  }
  return {};
}

}  // namespace facet::io
