#include "io/gltf_edited.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/text.hpp"
#include "io/gltf_document.hpp"
#include "io/image_formats.hpp"
#include "io/json_section.hpp"
#include "io/safe_files.hpp"
#include "io/sources.hpp"
#include "io/uri.hpp"
#include "scene/edited.hpp"
#include "scene/glb_container.hpp"
#include "scene/nodes.hpp"
#include "scene/properties.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

using Ordered = nlohmann::ordered_json;
using Pointer = Ordered::json_pointer;
using Bytes = std::vector<uint8_t>;

// ---- The text
// ---------------------------------------------------------------------------------------------------------

void useExtension(Ordered& gltf, const std::string& name) {
  Ordered& used = gltf["extensionsUsed"];
  if (std::ranges::find(used, Ordered(name)) == used.end()) used.push_back(name);
}

void useExtensionsOf(Ordered& gltf, const std::string& pointer) {
  constexpr std::string_view head = "/extensions/";
  for (size_t at = pointer.find(head); at != std::string::npos; at = pointer.find(head, at + 1)) {
    const size_t begin = at + head.size();
    useExtension(gltf, pointer.substr(begin, pointer.find('/', begin) - begin));
  }
}

Ordered numbers(const std::vector<double>& values) {
  if (values.size() == 1) return values[0];
  return values;
}

// translation, rotation and scale in a matrix' place.
void takeApart(Ordered& node, const scene::Node& from) {
  if (!node.contains("matrix")) return;
  scene::Node parts = from;
  scene::decompose(parts);
  node.erase("matrix");
  node["translation"] = {parts.translation.x, parts.translation.y, parts.translation.z};
  node["rotation"] = {parts.rotation.x, parts.rotation.y, parts.rotation.z, parts.rotation.w};
  node["scale"] = {parts.scale.x, parts.scale.y, parts.scale.z};
}

// All weights of a node, of which one may be set alone.
void setWeights(Ordered& node, const scene::Model& model, const scene::AnimationChannel& channel,
                const std::vector<double>& values) {
  const scene::Node& from = model.nodes[static_cast<size_t>(channel.object)];
  const size_t count = scene::morphTargetCount(model, from.mesh);
  const std::vector<float>& own =
      from.weights.empty() ? model.meshes[static_cast<size_t>(from.mesh)].weights : from.weights;
  Ordered& weights = node["weights"];
  if (!weights.is_array()) weights = Ordered::array();
  for (size_t i = weights.size(); i < count; ++i) weights.push_back(i < own.size() ? own[i] : 0.0f);
  const size_t first = channel.element < 0 ? 0 : static_cast<size_t>(channel.element);
  for (size_t i = 0; i < values.size() && first + i < count; ++i) weights[first + i] = values[i];
}

// Of a texture that the material has not: there is nothing to set.
bool lacksTexture(const Ordered& gltf, const std::string& pointer) {
  constexpr std::string_view tail = "Texture/";
  const size_t at = pointer.find(tail);
  return at != std::string::npos && !gltf.contains(Pointer(pointer.substr(0, at + tail.size() - 1)));
}

void erase(Ordered& gltf, const std::string& pointer) {
  const Pointer at(pointer);
  if (gltf.contains(at)) gltf[at.parent_pointer()].erase(at.back());
}

void apply(Ordered& gltf, const scene::Model& model, const scene::ResolvedEdit& resolved,
           const std::vector<double>& values) {
  using Kind = scene::ResolvedEdit::Kind;
  using scene::AnimatedProperty;
  const std::string& pointer = resolved.pointer;
  if (resolved.kind == Kind::noTexture) return erase(gltf, pointer);
  if (lacksTexture(gltf, pointer)) return;
  if (resolved.kind == Kind::alphaMode) {
    constexpr const char* words[] = {"OPAQUE", "MASK", "BLEND"};
    gltf[Pointer(pointer)] = words[static_cast<size_t>(values[0])];
    return;
  }
  if (resolved.kind == Kind::doubleSided) {
    gltf[Pointer(pointer)] = values[0] != 0;
    return;
  }
  const AnimatedProperty property = resolved.channel.property;
  if (property == AnimatedProperty::weights) {
    Ordered& node = gltf[Pointer("/nodes/" + std::to_string(resolved.channel.object))];
    return setWeights(node, model, resolved.channel, values);
  }
  if (property == AnimatedProperty::translation || property == AnimatedProperty::rotation ||
      property == AnimatedProperty::scale)
    takeApart(gltf["nodes"][static_cast<size_t>(resolved.channel.object)],
              model.nodes[static_cast<size_t>(resolved.channel.object)]);
  useExtensionsOf(gltf, pointer);
  gltf[Pointer(pointer)] = property == AnimatedProperty::visible ? Ordered(values[0] != 0) : numbers(values);
}

void addRoot(Ordered& gltf, const glm::dmat4& worldFromModel) {
  Ordered matrix = Ordered::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) matrix.push_back(worldFromModel[c][r]);
  for (Ordered& scene : gltf["scenes"]) {
    if (!scene.contains("nodes") || scene["nodes"].empty()) continue;
    gltf["nodes"].push_back({{"name", "placement"}, {"matrix", matrix}, {"children", scene["nodes"]}});
    scene["nodes"] = {gltf["nodes"].size() - 1};
  }
}

void keepOnly(Ordered& gltf, const scene::Model& model, const std::vector<int>& only) {
  if (only.empty()) return;
  scene::Pose pose;
  pose.only = only;
  std::vector<bool> wanted(model.nodes.size(), false);
  for (int scene = 0; scene < static_cast<int>(model.scenes.size()); ++scene) {
    const scene::NodeTransforms transforms = scene::worldTransforms(model, scene, pose);
    for (size_t n = 0; n < wanted.size(); ++n) wanted[n] = wanted[n] || transforms.wanted[n];
  }
  for (size_t n = 0; n < wanted.size(); ++n)
    if (!wanted[n])
      for (const char* key : {"mesh", "skin", "weights"}) gltf["nodes"][n].erase(key);
}

// ---- The bytes
// --------------------------------------------------------------------------------------------------------

size_t append(Bytes& binary, std::span<const uint8_t> bytes) {
  binary.resize((binary.size() + 7) / 8 * 8);  // of accessors the widest needs four
  const size_t at = binary.size();
  binary.insert(binary.end(), bytes.begin(), bytes.end());
  return at;
}

// All buffers in one; those that stand in for compressed ones stay as they are, behind it.
Bytes joinBuffers(Ordered& gltf, const Document& doc) {
  Bytes binary;
  Ordered buffers = {{{"byteLength", 0}}};
  std::vector<size_t> index(doc.buffers.size(), 0), offset(doc.buffers.size(), 0);
  for (size_t i = 0; i < doc.buffers.size(); ++i) {
    if (!doc.isFallback[i]) {
      offset[i] = append(binary, doc.buffers[i]);
      continue;
    }
    index[i] = buffers.size();
    Ordered fallback = gltf["buffers"][i];
    fallback.erase("uri");
    buffers.push_back(std::move(fallback));
  }
  const auto move = [&](Ordered& view) {
    if (!view.is_object() || !view.contains("buffer") || !view["buffer"].is_number_unsigned()) return;
    const auto from = view["buffer"].get<size_t>();
    if (from >= index.size()) return;
    view["buffer"] = index[from];
    if (!doc.isFallback[from]) view["byteOffset"] = view.value("byteOffset", size_t{0}) + offset[from];
  };
  if (gltf.contains("bufferViews"))
    for (Ordered& view : gltf["bufferViews"]) {
      move(view);
      if (view.contains("extensions"))
        for (Ordered& extension : view["extensions"]) move(extension);
    }
  gltf["buffers"] = std::move(buffers);
  return binary;
}

// Images that have names of files, or lie in the text, into the buffer.
void embedImages(Ordered& gltf, const Document& doc, const scene::Model& model, Bytes& binary, Notes& notes) {
  if (!gltf.contains("images")) return;
  for (size_t i = 0; i < gltf["images"].size() && i < model.images.size(); ++i) {
    Ordered& image = gltf["images"][i];
    if (!image.contains("uri")) continue;
    const scene::Image& read = model.images[i];
    FileBytes file;
    std::span<const uint8_t> bytes = read.encoded;
    if (!read.file.empty())
      if (Result<FileBytes> there = readRegularFile(read.file, doc.limits.fileBytes)) {
        file = std::move(*there);
        bytes = file.span();
      }
    const std::string type = mediaType(bytes);
    if (type.empty()) {
      notes.push_back({Note::Severity::warning, pointer("/images", i),
                       "is not there to be taken along: the new file names it as the old one did"});
      continue;
    }
    const size_t at = append(binary, bytes);
    gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes.size()}});
    image.erase("uri");
    image["mimeType"] = type;
    image["bufferView"] = gltf["bufferViews"].size() - 1;
  }
}

// Profiles of lights, likewise (EXT_lights_ies).
void embedProfiles(Ordered& gltf, Document& doc, Bytes& binary, Notes& notes) {
  const Pointer list("/extensions/EXT_lights_ies/lights");
  if (!gltf.contains(list) || !gltf[list].is_array()) return;
  for (size_t i = 0; i < gltf[list].size(); ++i) {
    Ordered& light = gltf[list][i];
    if (!light.is_object() || !light.contains("uri") || !light["uri"].is_string()) continue;
    const std::string place = pointer("/extensions/EXT_lights_ies/lights", i);
    const auto bytes = bytesOfUri(doc, light["uri"].get<std::string>(), place + "/uri");
    if (!bytes) {
      notes.push_back(
          {Note::Severity::warning, place, "is not there to be taken along: the new file names it as the old one did"});
      continue;
    }
    const size_t at = append(binary, *bytes);
    gltf["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", at}, {"byteLength", bytes->size()}});
    light.erase("uri");
    light["mimeType"] = "application/x-ies-lm-63";
    light["bufferView"] = gltf["bufferViews"].size() - 1;
  }
}

Result<Bytes> write(Document& doc, const scene::Model& model, const Changes& changes, Notes& notes) {
  Ordered gltf = Ordered::parse(doc.json.begin(), doc.json.end(), nullptr, false);
  if (!gltf.is_object()) return doc.error("", "the JSON text is faulty");
  for (const scene::Edit& edit : changes.edits) {
    const Result<std::vector<scene::ResolvedEdit>> resolved = scene::resolveEdit(model, edit);
    if (!resolved) return tl::unexpected(resolved.error());
    for (const scene::ResolvedEdit& one : *resolved) apply(gltf, model, one, edit.values);
  }
  keepOnly(gltf, model, changes.only);
  if (changes.worldFromModel) addRoot(gltf, *changes.worldFromModel);
  Bytes binary = joinBuffers(gltf, doc);
  embedImages(gltf, doc, model, binary, notes);
  embedProfiles(gltf, doc, binary, notes);
  if (binary.empty() && gltf["buffers"].size() == 1)
    gltf.erase("buffers");
  else
    gltf["buffers"][0]["byteLength"] = std::max<size_t>(binary.size(), 1);
  std::string text = gltf.dump();
  if (text.size() + binary.size() > 0xFFFFFF00u)
    return doc.error("", "with all its files it is larger than 4 GiB, which one file cannot be", "use a smaller model");
  return scene::glbContainer(std::move(text), binary);
}

}  // namespace

Result<Bytes> editedGlb(const std::string& source, const std::function<Result<Changes>(const scene::Model&)>& changesIn,
                        Notes& notes, const Limits& limits) {
  const Result<ModelBytes> read = readModelBytes(source, limits);
  if (!read) return tl::unexpected(read.error());
  const Result<LoadedModel> loaded = loadGltfBytes(read->bytes(), read->name, read->folder, limits);
  if (!loaded) return tl::unexpected(loaded.error());
  const Result<Changes> changes = changesIn(loaded->model);
  if (!changes) return tl::unexpected(changes.error());
  return withBuffers(read->bytes(), read->name, read->folder, limits,
                     [&](Document& doc) { return write(doc, loaded->model, *changes, notes); });
}

}  // namespace facet::io
