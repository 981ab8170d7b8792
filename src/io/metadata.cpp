#include "io/metadata.hpp"

#include <nlohmann/json.hpp>

#include "io/glb.hpp"
#include "io/json_scan.hpp"
#include "io/sources.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::ordered_json;

std::string textOf(const Json& value) {
  std::string text = value.dump(2, ' ', false, Json::error_handler_t::replace);
  if (text.size() <= longestMetadata) return text;
  size_t end = longestMetadata;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;  // within a letter
  const size_t left = text.size() - end;
  text.resize(end);
  return text + "\n... and " + std::to_string(left) + " bytes more";
}

}  // namespace

Result<std::vector<MetadataEntry>> readMetadata(std::span<const uint8_t> bytes, const std::string& name,
                                                const Limits& limits) {
  const auto inFile = [&](Error error) {
    error.file = name;
    return error;
  };
  std::string_view json(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (isGlb(bytes)) {
    const Result<GlbParts> parts = splitGlb(bytes);
    if (!parts) return tl::unexpected(inFile(parts.error()));
    json = parts->json;
  }
  const Result<JsonOutline> outline = scanJson(json, limits.jsonDepth);
  if (!outline) return tl::unexpected(inFile(outline.error()));
  const auto member = [&](const char* key) {
    const JsonMember* found = outline->find(key);
    if (found == nullptr) return Json();
    const std::string_view text = json.substr(found->begin, found->end - found->begin);
    Json parsed = Json::parse(text.begin(), text.end(), nullptr, false);
    return parsed.is_discarded() ? Json() : parsed;
  };
  std::vector<MetadataEntry> entries;
  if (const Json asset = member("asset"); asset.is_object()) entries.push_back({"/asset", "asset", textOf(asset)});
  for (const char* key :
       {"scenes", "nodes", "meshes", "materials", "textures", "images", "samplers", "animations", "skins", "cameras"}) {
    const Json objects = member(key);
    if (!objects.is_array()) continue;
    for (size_t i = 0; i < objects.size(); ++i)
      if (objects[i].is_object() && objects[i].contains("extras"))
        entries.push_back({"/" + std::string(key) + "/" + std::to_string(i), "extras", textOf(objects[i]["extras"])});
  }
  if (outline->find("extras") != nullptr) entries.push_back({"", "extras", textOf(member("extras"))});
  return entries;
}

Result<std::vector<MetadataEntry>> readMetadata(const std::string& source, const Limits& limits) {
  const Result<ModelBytes> read = readModelBytes(source, limits);
  if (!read) return tl::unexpected(read.error());
  return readMetadata(read->bytes(), read->name, limits);
}

}  // namespace facet::io
