#include "fuzz/mutate.hpp"

#include <nlohmann/json.hpp>
#include <string>

#include "io/glb.hpp"
#include "support/gltf_builder.hpp"

namespace facet::fuzz {

namespace {

using Json = nlohmann::ordered_json;
using Random = std::mt19937;

size_t below(Random& random, size_t count) { return count == 0 ? 0 : random() % count; }

// Every value of the document, itself first.
void collect(Json& value, std::vector<Json*>& all, int depth = 0) {
  if (all.size() > 20'000 || depth > 200) return;
  all.push_back(&value);
  if (value.is_structured())
    for (Json& child : value) collect(child, all, depth + 1);
}

const char* const extensionNames[] = {"KHR_materials_clearcoat",
                                      "KHR_materials_sheen",
                                      "KHR_materials_transmission",
                                      "KHR_materials_volume",
                                      "KHR_materials_ior",
                                      "KHR_materials_specular",
                                      "KHR_materials_iridescence",
                                      "KHR_materials_anisotropy",
                                      "KHR_materials_unlit",
                                      "KHR_materials_emissive_strength",
                                      "KHR_materials_dispersion",
                                      "KHR_materials_diffuse_transmission",
                                      "KHR_materials_pbrSpecularGlossiness",
                                      "KHR_materials_variants",
                                      "KHR_texture_transform",
                                      "KHR_texture_basisu",
                                      "EXT_texture_webp",
                                      "KHR_lights_punctual",
                                      "KHR_node_visibility",
                                      "KHR_animation_pointer",
                                      "EXT_mesh_gpu_instancing",
                                      "EXT_meshopt_compression",
                                      "KHR_meshopt_compression",
                                      "KHR_draco_mesh_compression",
                                      "KHR_mesh_quantization",
                                      "KHR_xmp_json_ld",
                                      "EXT_lights_image_based",
                                      "EXT_lights_ies",
                                      "EXT_texture_avif",
                                      "KHR_materials_diffuse_roughness",
                                      "KHR_accessor_float64",
                                      "MSFT_lod",
                                      "KHR_gaussian_splatting",
                                      "FACET_materials_models"};

const char* const keys[] = {"sparse",     "skin",       "mesh",      "children", "matrix",   "weights",    "targets",
                            "normalized", "camera",     "extras",    "indices",  "material", "byteOffset", "count",
                            "uri",        "byteStride", "scene",     "matrix",   "joints",   "sampler",    "extensions",
                            "name",       "index",      "texCoord",  "mode",     "inputs",   "min",        "max",
                            "mimeType",   "source",     "bufferView"};

Json anyValue(Random& random) {
  switch (below(random, 22)) {
    case 0:
      return nullptr;
    case 1:
      return true;
    case 2:
      return Json::object();
    case 3:
      return Json::array();
    case 4:
      return "";
    case 5:
      return std::string(1 + below(random, 300), 'x');
    case 6:
      return -1;
    case 7:
      return 0;
    case 8:
      return 1e308;
    case 9:
      return -1e39;
    case 10:
      return 1e-320;
    case 11:
      return 2147483647;
    case 12:
      return uint64_t{4294967295};
    case 13:
      return uint64_t{18446744073709551615u};
    case 14:
      return int64_t{-9223372036854775807 - 1};
    case 15:
      return 0.5;
    case 16:
      return "data:application/octet-stream;base64,AAAAAAAAAAA=";
    case 17:
      return "/nodes/0/rotation";
    case 18:
      return "../../../etc/passwd";
    case 19:
      return "caf\xc3\xa9\n\x01";
    default:
      return static_cast<int>(below(random, 12));  // likely an index of something
  }
}

std::string anyKey(Random& random) {
  if (below(random, 3) == 0) return extensionNames[below(random, std::size(extensionNames))];
  return keys[below(random, std::size(keys))];
}

void changeNumber(Json& value, Random& random) {
  if (value.is_number_integer()) {
    const auto old = value.get<uint64_t>();  // as bits: all of these wrap around
    const uint64_t other[] = {old + 1, old - 1, 0 - old, old / 2, old << 16, below(random, 8)};
    value = static_cast<int64_t>(other[below(random, std::size(other))]);
    return;
  }
  const double old = value.get<double>();
  const double other[] = {-old, old * 1e30, old * 1e-30, old + 1, 0.0, 1.0, std::floor(old)};
  value = other[below(random, std::size(other))];
}

void change(Json& root, Random& random) {
  std::vector<Json*> all;
  collect(root, all);
  Json& value = *all[below(random, all.size())];
  Json& other = *all[below(random, all.size())];
  switch (below(random, 10)) {
    case 0:
      value = anyValue(random);
      return;
    case 1:  // one of another place
      if (&value != &root) {
        const Json copy = other;
        if (copy.dump(-1, ' ', false, Json::error_handler_t::replace).size() < 20'000) value = copy;
      }
      return;
    case 2:  // taken away
      if (value.is_array() && !value.empty()) value.erase(below(random, value.size()));
      if (value.is_object() && !value.empty())
        value.erase(std::next(value.begin(), static_cast<ptrdiff_t>(below(random, value.size()))));
      return;
    case 3:  // doubled
      if (value.is_array() && !value.empty() && value.size() < 400)
        value.push_back(Json(value[below(random, value.size())]));
      return;
    case 4:  // added
      if (value.is_object()) value[anyKey(random)] = anyValue(random);
      if (value.is_array() && value.size() < 400) value.push_back(anyValue(random));
      return;
    case 5:
      if (value.is_object()) {
        if (!value.contains("extensions") || !value["extensions"].is_object()) value["extensions"] = Json::object();
        Json& extension = value["extensions"][extensionNames[below(random, std::size(extensionNames))]];
        extension = Json::object();
        for (size_t i = below(random, 3); i > 0; --i) extension[anyKey(random)] = anyValue(random);
      }
      return;
    case 6: {  // exchanged
      if (&value == &root || &other == &root) return;
      const Json first = value, second = other;
      value = second;
      if (below(random, 2) == 0) return;  // `other` may have gone with it
      all.clear();
      collect(root, all);
      *all[below(random, all.size())] = first;
      return;
    }
    default:
      for (int tries = 0; tries < 20; ++tries) {
        Json& number = *all[below(random, all.size())];
        if (!number.is_number()) continue;
        changeNumber(number, random);
        return;
      }
  }
}

// A member given twice is no longer an object that a library holds.
void doubleKey(std::string& text, Random& random) {
  const size_t open = text.find('{', below(random, text.size()));
  if (open == std::string::npos) return;
  const size_t colon = text.find("\":", open);
  if (colon == std::string::npos) return;
  const size_t quote = text.rfind('"', colon - 1);
  if (quote == std::string::npos || quote < open) return;
  text.insert(open + 1, text.substr(quote, colon + 2 - quote) + anyValue(random).dump() + ",");
}

void nest(std::string& text, Random& random) {
  const size_t at = text.find(':', below(random, text.size()));
  if (at == std::string::npos) return;
  const size_t depth = 1 + below(random, 600);
  text.insert(at + 1, std::string(depth, '[') + "0" + std::string(depth, ']') + ",\"x\":");
}

// Brackets in strings count, too; a sanitized library's stack ends at a thousand.
bool isDeep(std::string_view text) {
  int depth = 0, most = 0;
  for (const char c : text) {
    depth += (c == '[' || c == '{') - (c == ']' || c == '}');
    most = std::max(most, depth);
  }
  return most > 200;
}

}  // namespace

Bytes mutateJson(std::span<const uint8_t> bytes, std::mt19937& random) {
  std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  std::span<const uint8_t> binary;
  const bool glb = io::isGlb(bytes);
  if (glb) {
    const auto parts = io::splitGlb(bytes);
    if (!parts) return {bytes.begin(), bytes.end()};
    text = parts->json, binary = parts->binary;
  }
  if (isDeep(text)) return {bytes.begin(), bytes.end()};
  Json root = Json::parse(text, nullptr, false);
  if (root.is_discarded()) return {bytes.begin(), bytes.end()};
  for (size_t changes = 1 + below(random, 4); changes > 0; --changes) change(root, random);
  if (isDeep(root.dump(-1, ' ', false, Json::error_handler_t::replace))) return {bytes.begin(), bytes.end()};
  std::string changed = root.dump(-1, ' ', false, Json::error_handler_t::replace);
  if (below(random, 30) == 0) doubleKey(changed, random);
  if (below(random, 60) == 0) nest(changed, random);
  if (glb) return test::glbBytes(changed, binary);
  return {changed.begin(), changed.end()};
}

}  // namespace facet::fuzz
