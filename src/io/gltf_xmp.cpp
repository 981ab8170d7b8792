// KHR_xmp_json_ld: kept as text. Nothing in a picture depends on it, so that faults are warnings.

#include <nlohmann/json.hpp>

#include "io/json_section.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

constexpr const char* xmpExtension = "KHR_xmp_json_ld";

void addReference(Document& doc, const Json& object, const std::string& place) {
  const Json* extension = extensionOf(object, xmpExtension);
  if (extension == nullptr) return;
  const std::string at = place + "/extensions/" + xmpExtension + "/packet";
  const auto packet = extension->find("packet");
  if (packet == extension->end() || !packet->is_number_unsigned()) {
    doc.warning(at, "is not a whole number: ignored");
    return;
  }
  const size_t count = doc.model.xmp.packets.size();
  const auto index = packet->get<uint64_t>();
  if (index >= count) {
    doc.warning(
        at, "packet " + std::to_string(index) + " does not exist; there are " + std::to_string(count) + ": ignored");
    return;
  }
  doc.model.xmp.references.push_back({place, static_cast<int>(index)});
}

// The root's member of this name in the order of its keys; null where there is none.
template <class J>
J memberOf(const Document& doc, std::string_view key) {
  const JsonMember* found = doc.outline.find(key);
  if (found == nullptr) return nullptr;
  const std::string_view text = doc.json.substr(found->begin, found->end - found->begin);
  return J::parse(text.begin(), text.end(), nullptr, false);
}

void readPackets(Document& doc) {
  const auto extensions = memberOf<nlohmann::ordered_json>(doc, "extensions");
  const auto extension = extensions.find(xmpExtension);
  const auto packets = extension->is_object() ? extension->find("packets") : extension->end();
  const std::string place = std::string("/extensions/") + xmpExtension + "/packets";
  if (packets == extension->end() || !packets->is_array()) {
    doc.warning(place, "is not a list of packets: ignored");
    return;
  }
  for (const auto& packet : *packets)
    doc.model.xmp.packets.push_back(packet.dump(-1, ' ', false, Json::error_handler_t::replace));
}

}  // namespace

Result<void> readXmp(Document& doc) {
  if (doc.gltf.extensions.count(xmpExtension) == 0) return {};
  readPackets(doc);
  addReference(doc, memberOf<Json>(doc, "asset"), "/asset");
  for (const char* key : {"scenes", "nodes", "meshes", "materials", "images", "animations"}) {
    const auto objects = section(doc, key);
    if (!objects) return tl::unexpected(objects.error());
    for (size_t i = 0; i < objects->size(); ++i) addReference(doc, (*objects)[i], pointer(std::string("/") + key, i));
  }
  return {};
}

}  // namespace facet::io
