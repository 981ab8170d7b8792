#include "commands/inspect_parts.hpp"

#include <algorithm>
#include <charconv>
#include <nlohmann/json.hpp>
#include <ostream>

#include "frame/measured_gpu.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::commands {

namespace {

using Json = nlohmann::ordered_json;

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

Json describeAnimations(const scene::Model& model) {
  Json out = Json::array();
  for (size_t i = 0; i < model.animations.size(); ++i) {
    const scene::Animation& animation = model.animations[i];
    out.push_back({{"name", nameOr(animation.name, "animation", i)},
                   {"seconds", durationOf(animation)},
                   {"channels", animation.channels.size()}});
  }
  return out;
}

Json describeSkins(const scene::Model& model) {
  Json out = Json::array();
  for (size_t i = 0; i < model.skins.size(); ++i)
    out.push_back({{"name", nameOr(model.skins[i].name, "skin", i)}, {"joints", model.skins[i].joints.size()}});
  return out;
}

Json describeMorphTargets(const scene::Model& model) {
  Json out = Json::array();
  for (size_t i = 0; i < model.meshes.size(); ++i) {
    const scene::Mesh& mesh = model.meshes[i];
    size_t targets = 0;
    for (const scene::Primitive& p : mesh.primitives) targets = std::max(targets, p.targets.size());
    if (targets == 0) continue;
    Json entry = {{"mesh", nameOr(mesh.name, "mesh", i)}, {"targets", targets}};
    if (!mesh.targetNames.empty()) entry["names"] = mesh.targetNames;
    out.push_back(entry);
  }
  return out;
}

Json describeProfiles(const scene::Model& model) {
  constexpr const char* types[] = {"C", "A", "B"};
  Json out = Json::array();
  for (const optics::LightProfile& p : model.lightProfiles)
    out.push_back({{"name", p.name},
                   {"photometry", types[static_cast<size_t>(p.photometry)]},
                   {"directions", p.candela.size()},
                   {"lumens", optics::lumens(p)},
                   {"mostCandela", p.mostCandela}});
  return out;
}

Json describeInstancing(const scene::Model& model) {
  Json out = Json::array();
  for (size_t i = 0; i < model.nodes.size(); ++i)
    if (!model.nodes[i].instances.empty())
      out.push_back({{"node", nameOr(model.nodes[i].name, "node", i)}, {"instances", model.nodes[i].instances.size()}});
  return out;
}

Json describeXmp(const scene::Metadata& xmp) {
  Json out = Json::array();
  for (size_t i = 0; i < xmp.packets.size(); ++i) {
    Json objects = Json::array();
    for (const scene::Metadata::Reference& reference : xmp.references)
      if (reference.packet == static_cast<int>(i)) objects.push_back(reference.object);
    out.push_back({{"about", objects}, {"packet", Json::parse(xmp.packets[i], nullptr, false)}});
  }
  return out;
}

// 0.1 for 0.1f.
double shortestDouble(float value) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  double result = 0;
  std::from_chars(text, end, result);
  return result;
}

Json valuesOf(scene::Material& material, const scene::MaterialProperty& property) {
  const auto values = components(material, property);
  if (values.size() == 1) return shortestDouble(values[0]);
  Json list = Json::array();
  for (const float value : values) list.push_back(shortestDouble(value));
  return list;
}

// Can be seen of an extension, "KHR_materials_" left out.
bool isSeen(const scene::Material& material, std::string_view extension) {
  if (extension == "emissive_strength") return material.emissiveFactor != glm::vec3(0);
  if (extension == "ior" || extension == "specular") return has(material, scene::Effect::dielectricSpecular);
  return std::ranges::any_of(scene::effects, [&](scene::Effect effect) {
    std::string name = scene::name(effect);
    std::ranges::replace(name, ' ', '_');
    return name == extension && has(material, effect);
  });
}

// "eyes, mouth"
std::string joined(const Json& texts) {
  std::string all;
  for (const Json& text : texts) all += (all.empty() ? "" : ", ") + text.get<std::string>();
  return all;
}

template <class Line>
void printList(const Json& list, const char* title, std::ostream& out, Line&& line) {
  if (list.empty()) return;
  out << "\n" << title << "\n";
  for (const Json& entry : list) {
    out << "  ";
    line(entry);
    out << "\n";
  }
}

}  // namespace

Json describeEffects(const scene::Material& material) {
  Json out;
  if (material.unlit) return out;
  scene::Material given = material, usual;
  constexpr std::string_view common = "extensions/KHR_materials_";
  std::string head;  // of the extension at hand; its properties lie together
  for (const scene::MaterialProperty& first : scene::materialProperties()) {
    const std::string_view path = first.path;
    if (!path.starts_with(common) || (!head.empty() && path.starts_with(head))) continue;
    const std::string_view extension = path.substr(common.size(), path.find('/', common.size()) - common.size());
    head = std::string(common) + std::string(extension) + "/";
    if (!isSeen(material, extension)) continue;
    Json found;
    for (const scene::MaterialProperty& property : scene::materialProperties())
      if (std::string_view(property.path).starts_with(head) &&
          !std::ranges::equal(components(given, property), components(usual, property)))
        found[property.path + head.size()] = valuesOf(given, property);
    for (const scene::TextureSlot slot : scene::textureSlots)
      if (scene::path(slot).starts_with(head) && textureRef(material, slot))
        found[scene::name(slot)] = textureRef(material, slot).texture;
    if (!found.is_null()) out[std::string(extension)] = found;
  }
  return out;
}

void describeParts(const scene::Model& model, Json& out) {
  out["animations"] = describeAnimations(model);
  out["skins"] = describeSkins(model);
  out["morphTargets"] = describeMorphTargets(model);
  out["instancing"] = describeInstancing(model);
  out["lightProfiles"] = describeProfiles(model);
  out["variants"] = model.variants;
  out["xmp"] = describeXmp(model.xmp);
}

void printParts(const Json& described, std::ostream& out) {
  const auto text = [](const Json& entry, const char* key) { return entry[key].get<std::string>(); };
  printList(described["animations"], "Animations", out, [&](const Json& entry) {
    out << text(entry, "name") << ": " << entry["seconds"].get<double>() << " s, " << entry["channels"] << " channels";
  });
  printList(described["skins"], "Skins", out,
            [&](const Json& entry) { out << text(entry, "name") << ": " << entry["joints"] << " joints"; });
  printList(described["morphTargets"], "Morph targets", out, [&](const Json& entry) {
    out << text(entry, "mesh") << ": " << entry["targets"];
    if (entry.contains("names")) out << " (" << joined(entry["names"]) << ")";
  });
  printList(described["instancing"], "Instancing", out,
            [&](const Json& entry) { out << text(entry, "node") << ": " << entry["instances"] << " instances"; });
  printList(described["lightProfiles"], "Light profiles", out, [&](const Json& entry) {
    out << text(entry, "name") << ": photometry of type " << text(entry, "photometry") << ", " << entry["directions"]
        << " directions, " << entry["lumens"].get<double>() << " lm, up to " << entry["mostCandela"].get<double>()
        << " cd";
  });
  printList(described["variants"], "Material variants", out,
            [&](const Json& entry) { out << entry.get<std::string>(); });
  printList(described["xmp"], "XMP metadata", out, [&](const Json& entry) {
    const std::string about = joined(entry["about"]);
    out << (about.empty() ? "nothing" : about) << ": "
        << entry["packet"].dump(-1, ' ', false, Json::error_handler_t::replace);
  });
}

Json describeMeasured(const optics::MeasuredBrdf& brdf, const std::string& source) {
  const bool merl = brdf.kind == optics::MeasuredKind::merl;
  return {{"name", brdf.name},
          {"source", source},
          {"kind", merl ? "MERL, isotropic" : "UTIA, anisotropic"},
          {"cells", brdf.values.size()},
          {"missingCells", brdf.counts.missing()},
          {"filledCells", brdf.guess.holes()},
          {"guessedShare", brdf.guess.energy},
          {"bytesOnGpu", frame::measuredBytes(brdf)}};
}

void printMeasured(const Json& described, std::ostream& out) {
  const std::string name = described["name"], source = described["source"], kind = described["kind"];
  out << "  measured BRDF in the place of all lit materials: " << name << " (" << kind << ") from " << source << ", "
      << described["cells"] << " cells, " << described["missingCells"] << " of them missing, "
      << described["filledCells"] << " of those above the horizon and filled, "
      << described["bytesOnGpu"].get<size_t>() / 1024 << " KiB on the GPU\n";
}

}  // namespace facet::commands
