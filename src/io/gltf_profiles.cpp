// EXT_lights_ies: lights of nodes that shine by IES files. A file that cannot be read costs its lights, not the model.

#include <algorithm>
#include <map>

#include "io/accessors.hpp"
#include "io/ies.hpp"
#include "io/json_section.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

constexpr const char* extensionName = "EXT_lights_ies";
constexpr size_t mostNumbers = size_t{1} << 23;  // of all profiles: what shaders read by an index in a float

struct ProfileReader {
  Document& doc;
  Json lights;
  std::map<int, int> known = {};  // of the file's list: index in Model::lightProfiles, -1: cannot be read
  size_t numbers = 0;
};

Result<std::span<const uint8_t>> profileBytes(Document& doc, const Json& from, const std::string& place) {
  if (const std::string uri = stringAt(from, "uri"); !uri.empty()) return bytesOfUri(doc, uri, place + "/uri");
  if (!from.is_object() || !from.contains("bufferView"))
    return doc.error(place, "has neither a uri nor a bufferView", "name an IES file");
  const auto view =
      readIndex(doc, from["bufferView"], doc.gltf.bufferViews.size(), place + "/bufferView", "buffer view");
  if (!view) return tl::unexpected(view.error());
  return viewBytes(doc, *view);
}

// What messages call it: the file's name, where it has one.
std::string profileName(const Json& from, const std::string& place) {
  const std::string name = stringAt(from, "name"), uri = stringAt(from, "uri");
  if (!name.empty()) return name;
  return uri.empty() || uri.starts_with("data:") ? place : uri.substr(uri.rfind('/') + 1);
}

Result<int> readProfile(ProfileReader& reader, int index) {
  const std::string place = pointer("/extensions/EXT_lights_ies/lights", static_cast<size_t>(index));
  const Json& from = reader.lights[static_cast<size_t>(index)];
  const auto bytes = profileBytes(reader.doc, from, place);
  if (!bytes) return tl::unexpected(bytes.error());
  auto profile = readIes(*bytes, profileName(from, place), place, reader.doc.notes);
  if (!profile) {
    const Error& error = profile.error();
    const std::string where =
        (error.file == place ? "" : error.file + ": ") + (error.place.empty() ? "" : error.place + ": ");
    return reader.doc.error(place, where + error.problem, error.remedy);
  }
  reader.numbers += profile->candela.size();
  if (reader.numbers > mostNumbers) return reader.doc.error(place, "all profiles have more intensities than are read");
  reader.doc.model.lightProfiles.push_back(std::move(*profile));
  return static_cast<int>(reader.doc.model.lightProfiles.size()) - 1;
}

// A senseless number costs the light its value.
float factor(Document& doc, const tinygltf::Value& value, const std::string& place, double most) {
  const double number = value.IsNumber() ? value.GetNumberAsDouble() : -1;
  if (number >= 0 && number <= most) return static_cast<float>(number);
  doc.warning(place, "is out of range: 1 is used");
  return 1;
}

Result<void> readProfiledLight(ProfileReader& reader, size_t node) {
  Document& doc = reader.doc;
  const auto found = doc.gltf.nodes[node].extensions.find(extensionName);
  if (found == doc.gltf.nodes[node].extensions.end()) return {};
  const std::string place = pointer("/nodes", node) + "/extensions/EXT_lights_ies";
  const tinygltf::Value& index = memberValue(found->second, "light");
  const int light = index.IsInt() ? index.GetNumberAsInt() : -1;
  if (auto ok = checkIndex(doc, light, reader.lights.size(), place + "/light", "light profile"); !ok) return ok;
  const auto [known, fresh] = reader.known.emplace(light, -1);
  if (fresh) {
    const Result<int> read = readProfile(reader, light);
    if (!read) return tl::unexpected(read.error());
    known->second = *read;
  }
  if (known->second < 0) return {};  // told before
  scene::Light out;
  out.name = doc.model.nodes[node].name;
  out.profile = known->second;
  const tinygltf::Value &multiplier = memberValue(found->second, "multiplier"),
                        &color = memberValue(found->second, "color");
  if (multiplier.Type() != tinygltf::NULL_TYPE) out.intensity = factor(doc, multiplier, place + "/multiplier", 3e38);
  if (color.IsArray() && color.ArrayLen() == 3) {
    for (int c = 0; c < 3; ++c)
      out.color[c] = factor(doc, color.Get(c), pointer(place + "/color", static_cast<size_t>(c)), 1);
  } else if (color.Type() != tinygltf::NULL_TYPE) {
    doc.warning(place + "/color", "does not have three numbers: white is used");
  }
  doc.model.nodes[node].profiledLight = static_cast<int>(doc.model.lights.size());
  doc.model.lights.push_back(std::move(out));
  return {};
}

}  // namespace

Result<void> readProfiledLights(Document& doc) {
  const auto uses = [](const tinygltf::Node& node) { return node.extensions.contains(extensionName); };
  if (std::ranges::none_of(doc.gltf.nodes, uses)) return {};
  const Json extension = rootExtension(doc, extensionName);
  ProfileReader reader{.doc = doc, .lights = Json::array()};
  if (extension.is_object() && extension.contains("lights") && extension["lights"].is_array())
    reader.lights = extension["lights"];
  for (size_t i = 0; i < doc.gltf.nodes.size(); ++i)
    if (auto ok = readProfiledLight(reader, i); !ok) doc.lost(ok.error(), "the light is left out");
  return {};
}

}  // namespace facet::io
