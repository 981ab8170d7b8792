#include "scene/edited.hpp"

#include <algorithm>
#include <cmath>

#include "base/nearest.hpp"
#include "base/text.hpp"
#include "base/whole_number.hpp"
#include "scene/animation.hpp"
#include "scene/properties.hpp"
#include "scene/usage.hpp"

namespace facet::scene {

namespace {

constexpr std::string_view shortLights = "/lights/";

// ---- Which objects
// ---------------------------------------------------------------------------------------------------

// "~1" is a slash, "~0" a tilde (RFC 6901).
std::string unescaped(std::string_view token) {
  std::string text;
  for (size_t i = 0; i < token.size(); ++i) {
    const bool escape = token[i] == '~' && i + 1 < token.size() && (token[i + 1] == '0' || token[i + 1] == '1');
    text += escape ? (token[i + 1] == '0' ? '~' : '/') : token[i];
    if (escape) ++i;
  }
  return text;
}

tl::unexpected<Error> noSuch(const Model& model, const std::string& pointer, std::string problem,
                             std::string remedy = {}) {
  return fail(model.name, {}, "nothing is set by " + inQuotes(pointer) + ": " + std::move(problem), std::move(remedy),
              Setting::edits);
}

Result<std::vector<int>> objectsOf(const Model& model, Owner owner, std::string_view token, const std::string& whole) {
  const size_t count = objectCount(model, owner);
  std::vector<int> objects;
  const std::optional<int> index = wholeNumber(token);
  const std::string name = unescaped(token);
  if (index && *index >= 0 && static_cast<size_t>(*index) < count) return std::vector{*index};
  for (int i = 0; i < static_cast<int>(count); ++i)
    if (token == "*" || objectName(model, owner, i) == name) objects.push_back(i);
  if (!objects.empty()) return objects;
  std::string_view list = listPath(owner);
  list = list.substr(0, list.size() - 1);
  const std::string kind(list.substr(list.rfind('/') + 1));
  if (count == 0) return noSuch(model, whole, "the file has no " + kind, "leave it out");
  std::vector<std::string_view> names;
  for (int i = 0; i < static_cast<int>(count) && names.size() < 20; ++i)
    if (!objectName(model, owner, i).empty()) names.push_back(objectName(model, owner, i));
  const std::string indices = "an index from 0 to " + std::to_string(count - 1);
  return noSuch(model, whole, "of " + kind + " there is no " + inQuotes(name),
                names.empty() ? "give " + indices : "give " + indices + ", or a name: " + suggestion(name, names));
}

struct Wanted {
  Owner owner;
  std::vector<int> objects;
  std::string path;
};

Result<Wanted> wanted(const Model& model, const std::string& pointer) {
  const std::string_view whole = pointer;
  for (int i = 0; i < ownerCount; ++i) {
    const auto owner = static_cast<Owner>(i);
    std::string_view list = listPath(owner);
    if (owner == Owner::light && whole.starts_with(shortLights)) list = shortLights;
    if (!whole.starts_with(list)) continue;
    const std::string_view rest = whole.substr(list.size()), token = rest.substr(0, rest.find('/'));
    if (token.size() == rest.size()) return noSuch(model, pointer, "it names no property of the object");
    Result<std::vector<int>> objects = objectsOf(model, owner, token, pointer);
    if (!objects) return tl::unexpected(objects.error());
    return Wanted{owner, std::move(*objects), std::string(rest.substr(token.size() + 1))};
  }
  return noSuch(model, pointer, "it begins with no list of objects",
                "begin with /materials/, /nodes/, /meshes/, /lights/ or /cameras/");
}

// ---- Which property
// --------------------------------------------------------------------------------------------------

bool isTexturePath(std::string_view path) {
  return std::ranges::any_of(textureSlots, [&](TextureSlot slot) { return scene::path(slot) == path; });
}

// All that can be set of an object.
std::vector<std::string> settablePaths(const Model& model, Owner owner, int object) {
  std::vector<std::string> paths = propertyPaths(model, owner, object);
  if (owner != Owner::material) return paths;
  paths.emplace_back("alphaMode");
  paths.emplace_back("doubleSided");
  for (const TextureSlot slot : textureSlots) paths.emplace_back(scene::path(slot));
  return paths;
}

// The path whose end is given.
Result<std::string> wholePath(const Model& model, const Wanted& of, int object, const std::string& pointer) {
  if (of.path.starts_with("weights/")) return of.path;
  const std::vector<std::string> paths = settablePaths(model, of.owner, object);
  if (std::ranges::find(paths, of.path) != paths.end()) return of.path;
  std::vector<std::string> found;
  for (const std::string& path : paths)
    if (path.ends_with("/" + of.path)) found.push_back(path);
  if (found.size() == 1) return found[0];
  if (found.size() > 1)
    return noSuch(model, pointer, inQuotes(of.path) + " is the end of several",
                  "give one whole, such as " + found[0] + " or " + found[1]);
  std::vector<std::string_view> ends;  // those of textures' transforms are all alike
  for (const std::string& path : paths) {
    const std::string_view end = std::string_view(path).substr(path.rfind('/') + 1);
    if (std::ranges::find(ends, end) == ends.end()) ends.push_back(end);
  }
  return noSuch(model, pointer, "there is no " + inQuotes(of.path), suggestion(of.path, ends));
}

Result<void> checkCount(const Model& model, const Edit& edit, size_t wantedCount) {
  if (edit.values.size() == wantedCount) return {};
  return noSuch(model, edit.pointer,
                "it has " + std::to_string(wantedCount) + (wantedCount == 1 ? " number, not " : " numbers, not ") +
                    std::to_string(edit.values.size()),
                wantedCount == 1 ? "give one" : "give " + std::to_string(wantedCount) + " with commas between");
}

std::string pointerTo(Owner owner, int object, const std::string& path) {
  return std::string(listPath(owner)) + std::to_string(object) + "/" + path;
}

Result<ResolvedEdit> resolveProperty(const Model& model, const Edit& edit, const PropertyPlace& place) {
  const size_t targets =
      place.owner == Owner::node ? morphTargetCount(model, model.nodes[static_cast<size_t>(place.object)].mesh) : 0;
  const std::optional<PropertyTarget> found = propertyAt(model, place, targets);
  if (!found) return noSuch(model, edit.pointer, "there is no " + inQuotes(place.path));
  const bool allWeights = found->channel.property == AnimatedProperty::weights && found->channel.element < 0;
  if (allWeights && targets == 0) return noSuch(model, edit.pointer, "the node has no morph targets");
  const size_t count = allWeights ? targets : static_cast<size_t>(found->components);
  if (const Result<void> same = checkCount(model, edit, count); !same) return tl::unexpected(same.error());
  ResolvedEdit out;
  out.channel = found->channel;
  return out;
}

Result<ResolvedEdit> resolveOther(const Model& model, const Edit& edit, int material, const std::string& path) {
  ResolvedEdit out;
  out.channel.object = material;
  if (isTexturePath(path)) {
    if (!edit.values.empty())
      return noSuch(model, edit.pointer, "a texture can only be left out", "give none, or a number of its own");
    out.kind = ResolvedEdit::Kind::noTexture;
    out.channel.slot = *std::ranges::find_if(textureSlots, [&](TextureSlot slot) { return scene::path(slot) == path; });
    return out;
  }
  out.kind = path == "alphaMode" ? ResolvedEdit::Kind::alphaMode : ResolvedEdit::Kind::doubleSided;
  if (const Result<void> one = checkCount(model, edit, 1); !one) return tl::unexpected(one.error());
  const double most = path == "alphaMode" ? 2 : 1;
  if (edit.values[0] != 0 && edit.values[0] != 1 && edit.values[0] != most)
    return noSuch(model, edit.pointer, number(edit.values[0]) + " is no value of it",
                  path == "alphaMode" ? "give opaque, mask or blend" : "give true or false");
  return out;
}

// The nodes that draw a mesh with the mesh's own weights.
Result<std::vector<ResolvedEdit>> resolveMesh(const Model& model, const Edit& edit, int mesh) {
  const size_t targets = morphTargetCount(model, mesh);
  if (targets == 0) return noSuch(model, edit.pointer, "the mesh has no morph targets");
  if (const Result<void> same = checkCount(model, edit, targets); !same) return tl::unexpected(same.error());
  std::vector<ResolvedEdit> all;
  for (int n = 0; n < static_cast<int>(model.nodes.size()); ++n) {
    const Node& node = model.nodes[static_cast<size_t>(n)];
    if (node.mesh != mesh || !node.weights.empty()) continue;
    ResolvedEdit one;
    one.channel.property = AnimatedProperty::weights;
    one.channel.object = n;
    all.push_back(one);
  }
  return all;
}

// The identity where it has no length.
void normalize(std::vector<double>& quaternion) {
  double length = 0;
  for (const double q : quaternion) length = std::hypot(length, q);
  for (double& q : quaternion) q = length > 0 ? q / length : 0;
  if (!(length > 0)) quaternion.back() = 1;
}

void apply(Pose& pose, const Model& model, const ResolvedEdit& resolved, const Edit& edit) {
  using Kind = ResolvedEdit::Kind;
  const int object = resolved.channel.object;
  if (resolved.kind == Kind::property) {
    std::vector<double> values = edit.values;
    if (resolved.channel.property == AnimatedProperty::rotation) normalize(values);
    setProperty(pose, model, resolved.channel, values);
    return;
  }
  Material& material = pose.materials.edit(model.materials, object);
  if (resolved.kind == Kind::alphaMode) material.alphaMode = static_cast<AlphaMode>(edit.values[0]);
  if (resolved.kind == Kind::doubleSided) material.doubleSided = edit.values[0] != 0;
  if (resolved.kind == Kind::noTexture) textureRef(material, resolved.channel.slot).texture = -1;
}

}  // namespace

Result<std::vector<ResolvedEdit>> resolveEdit(const Model& model, const Edit& edit) {
  const Result<Wanted> of = wanted(model, edit.pointer);
  if (!of) return tl::unexpected(of.error());
  std::vector<ResolvedEdit> all;
  for (const int object : of->objects) {
    const Result<std::string> path = wholePath(model, *of, object, edit.pointer);
    if (!path) return tl::unexpected(path.error());
    const std::string pointer = pointerTo(of->owner, object, *path);
    if (of->owner == Owner::mesh) {
      Result<std::vector<ResolvedEdit>> users = resolveMesh(model, edit, object);
      if (!users) return tl::unexpected(users.error());
      for (ResolvedEdit& one : *users) one.pointer = pointer, all.push_back(std::move(one));
      continue;
    }
    const bool other =
        of->owner == Owner::material && (*path == "alphaMode" || *path == "doubleSided" || isTexturePath(*path));
    Result<ResolvedEdit> one =
        other ? resolveOther(model, edit, object, *path) : resolveProperty(model, edit, {of->owner, object, *path});
    if (!one) return tl::unexpected(one.error());
    one->pointer = pointer;
    all.push_back(std::move(*one));
  }
  return all;
}

Result<void> applyEdits(Pose& pose, const Model& model, const Edits& edits) {
  for (const Edit& edit : edits) {
    const Result<std::vector<ResolvedEdit>> resolved = resolveEdit(model, edit);
    if (!resolved) return tl::unexpected(resolved.error());
    for (const ResolvedEdit& one : *resolved) apply(pose, model, one, edit);
  }
  if (!edits.empty()) reconcile(pose);
  return {};
}

Result<Material> edited(Material material, const Edits& edits) {
  Model model;
  model.materials.push_back(std::move(material));
  Pose pose;
  for (const Edit& edit : edits)
    if (Result<void> r = applyEdits(pose, model, {{"/materials/0" + edit.pointer, edit.values}}); !r)
      return tl::unexpected(r.error());
  return pose.materials.of(model.materials, 0);
}

bool showsMore(const Model& model, const Pose& pose) {
  for (const auto& [index, now] : pose.materials.changed) {
    const Material& before = model.materials[static_cast<size_t>(index)];
    if (has(now, Effect::anisotropy) && !has(before, Effect::anisotropy)) return true;
    for (const TextureSlot slot : textureSlots)
      if (usesTexture(now, slot) && !usesTexture(before, slot)) return true;
  }
  return false;
}

}  // namespace facet::scene
