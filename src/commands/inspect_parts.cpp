#include "commands/inspect_parts.hpp"

#include <algorithm>
#include <ostream>

namespace facet::commands {

namespace {

using json = nlohmann::ordered_json;

std::string nameOr(const std::string& name, const char* kind, size_t index) {
  return name.empty() ? std::string(kind) + " " + std::to_string(index) : name;
}

// Seconds, of the last key that a channel reads.
double durationOf(const scene::Animation& animation) {
  float last = 0;
  for (const scene::AnimationChannel& channel : animation.channels) {
    const auto& times = animation.samplers[static_cast<size_t>(channel.sampler)].times;
    if (!times.empty()) last = std::max(last, times.back());
  }
  return static_cast<double>(last);
}

json describeAnimations(const scene::Model& model) {
  json out = json::array();
  for (size_t i = 0; i < model.animations.size(); ++i) {
    const scene::Animation& animation = model.animations[i];
    out.push_back({{"name", nameOr(animation.name, "animation", i)},
                   {"seconds", durationOf(animation)},
                   {"channels", animation.channels.size()}});
  }
  return out;
}

json describeSkins(const scene::Model& model) {
  json out = json::array();
  for (size_t i = 0; i < model.skins.size(); ++i)
    out.push_back({{"name", nameOr(model.skins[i].name, "skin", i)}, {"joints", model.skins[i].joints.size()}});
  return out;
}

json describeMorphTargets(const scene::Model& model) {
  json out = json::array();
  for (size_t i = 0; i < model.meshes.size(); ++i) {
    const scene::Mesh& mesh = model.meshes[i];
    size_t targets = 0;
    for (const scene::Primitive& p : mesh.primitives) targets = std::max(targets, p.targets.size());
    if (targets == 0) continue;
    json entry = {{"mesh", nameOr(mesh.name, "mesh", i)}, {"targets", targets}};
    if (!mesh.targetNames.empty()) entry["names"] = mesh.targetNames;
    out.push_back(entry);
  }
  return out;
}

json describeInstancing(const scene::Model& model) {
  json out = json::array();
  for (size_t i = 0; i < model.nodes.size(); ++i)
    if (!model.nodes[i].instances.empty())
      out.push_back({{"node", nameOr(model.nodes[i].name, "node", i)}, {"instances", model.nodes[i].instances.size()}});
  return out;
}

json describeXmp(const scene::Metadata& xmp) {
  json out = json::array();
  for (size_t i = 0; i < xmp.packets.size(); ++i) {
    json objects = json::array();
    for (const scene::Metadata::Reference& reference : xmp.references)
      if (reference.packet == static_cast<int>(i)) objects.push_back(reference.object);
    out.push_back({{"about", objects}, {"packet", json::parse(xmp.packets[i], nullptr, false)}});
  }
  return out;
}

// "eyes, mouth"
std::string joined(const json& texts) {
  std::string all;
  for (const json& text : texts) all += (all.empty() ? "" : ", ") + text.get<std::string>();
  return all;
}

template <class Line>
void printList(const json& list, const char* title, std::ostream& out, Line&& line) {
  if (list.empty()) return;
  out << "\n" << title << "\n";
  for (const json& entry : list) {
    out << "  ";
    line(entry);
    out << "\n";
  }
}

}  // namespace

void describeParts(const scene::Model& model, json& out) {
  out["animations"] = describeAnimations(model);
  out["skins"] = describeSkins(model);
  out["morphTargets"] = describeMorphTargets(model);
  out["instancing"] = describeInstancing(model);
  out["variants"] = model.variants;
  out["xmp"] = describeXmp(model.xmp);
}

void printParts(const json& described, std::ostream& out) {
  const auto text = [](const json& entry, const char* key) { return entry[key].get<std::string>(); };
  printList(described["animations"], "Animations", out, [&](const json& entry) {
    out << text(entry, "name") << ": " << entry["seconds"].get<double>() << " s, " << entry["channels"] << " channels";
  });
  printList(described["skins"], "Skins", out,
            [&](const json& entry) { out << text(entry, "name") << ": " << entry["joints"] << " joints"; });
  printList(described["morphTargets"], "Morph targets", out, [&](const json& entry) {
    out << text(entry, "mesh") << ": " << entry["targets"];
    if (entry.contains("names")) out << " (" << joined(entry["names"]) << ")";
  });
  printList(described["instancing"], "Instancing", out,
            [&](const json& entry) { out << text(entry, "node") << ": " << entry["instances"] << " instances"; });
  printList(described["variants"], "Material variants", out,
            [&](const json& entry) { out << entry.get<std::string>(); });
  printList(described["xmp"], "XMP metadata", out, [&](const json& entry) {
    const std::string about = joined(entry["about"]);
    out << (about.empty() ? "nothing" : about) << ": "
        << entry["packet"].dump(-1, ' ', false, json::error_handler_t::replace);
  });
}

}  // namespace facet::commands
