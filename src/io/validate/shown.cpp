// Where what a finding is about can be seen: up the references to a node, through a material where there is one.

#include <charconv>

#include "io/validate/checks.hpp"

namespace facet::io::validate {

namespace {

struct Object {
  std::string path;  // of its collection: "nodes", "extensions/KHR_lights_punctual/lights"
  int index = -1;
};

// "/meshes/3/primitives/0" is in meshes, 3.
Object objectOf(std::string_view place) {
  Object out;
  while (place.starts_with('/')) {
    place.remove_prefix(1);
    const std::string_view part = place.substr(0, place.find('/'));
    place.remove_prefix(part.size());
    const auto end = std::from_chars(part.data(), part.data() + part.size(), out.index);
    if (end.ec == std::errc() && end.ptr == part.data() + part.size() && !part.empty()) return out;
    out.path += (out.path.empty() ? "" : "/") + std::string(part);
  }
  return {};
}

// The node that a channel of the animation moves: the one of the place, else the first one.
int movedNode(const Asset& asset, const Object& animation, const std::string& place) {
  const Json& channels = member(element(asset, "animations", animation.index), "channels");
  if (!channels.is_array()) return -1;
  const std::string head = at("/animations", static_cast<size_t>(animation.index));
  for (const char* key : {"channels", "samplers"}) {
    const std::string list = head + "/" + key;
    if (!place.starts_with(list)) continue;
    const Object part = objectOf(place.substr(head.size()));
    for (size_t i = 0; i < channels.size(); ++i) {
      const bool same =
          key[0] == 'c' ? static_cast<int>(i) == part.index : wholeAt(channels[i], "sampler") == part.index;
      if (same) return indexAt(asset, member(channels[i], "target"), "node", "nodes");
    }
  }
  return -1;
}

}  // namespace

void findShown(Asset& asset) {
  constexpr int furthest = 8;  // accessor, mesh, node: real ones are three or four steps away
  for (Finding& finding : asset.report.findings) {
    std::string place = finding.place;
    for (int step = 0; step < furthest && finding.node < 0; ++step) {
      const Object object = objectOf(place);
      if (element(asset, object.path, object.index).is_null()) break;
      if (object.path == "nodes") finding.node = object.index;
      if (object.path == "materials" && finding.material < 0) finding.material = object.index;
      if (object.path == "animations") finding.node = movedNode(asset, object, place);
      const auto user = asset.firstUser.find({object.path, object.index});
      if (object.path == "animations" || user == asset.firstUser.end()) break;
      place = user->second;
    }
  }
}

}  // namespace facet::io::validate
