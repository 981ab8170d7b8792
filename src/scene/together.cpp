#include "scene/together.hpp"

#include <algorithm>
#include <iterator>

#include "scene/properties.hpp"

namespace facet::scene {

namespace {

// Where the lists of what was added begin, and what its lights and variants are called by now.
struct Shift {
  int nodes = 0, meshes = 0, materials = 0, textures = 0, images = 0, cameras = 0, skins = 0;
  std::vector<int> lights, variants;
};

void shift(int& index, int by) {
  if (index >= 0) index += by;
}

template <class T>
void append(std::vector<T>& to, std::vector<T>& from) {
  to.insert(to.end(), std::make_move_iterator(from.begin()), std::make_move_iterator(from.end()));
}

void shift(Node& node, const Shift& by) {
  shift(node.parent, by.nodes);
  for (int& child : node.children) shift(child, by.nodes);
  shift(node.mesh, by.meshes), shift(node.camera, by.cameras), shift(node.skin, by.skins);
  for (int* light : {&node.light, &node.profiledLight})
    if (*light >= 0) *light = by.lights[static_cast<size_t>(*light)];
}

void shift(Primitive& primitive, const Shift& by, size_t variants) {
  shift(primitive.material, by.materials);
  if (primitive.variantMaterials.empty()) return;
  std::vector<int> materials(variants, -1);
  for (size_t i = 0; i < std::min(primitive.variantMaterials.size(), by.variants.size()); ++i) {
    int& material = materials[static_cast<size_t>(by.variants[i])];
    material = primitive.variantMaterials[i];
    shift(material, by.materials);
  }
  primitive.variantMaterials = std::move(materials);
}

void shift(Material& material, const Shift& by) {
#define TEXTURE_SLOT(name, ...) shift(material.name.texture, by.textures);
#include "texture_slots.inc"
#undef TEXTURE_SLOT
}

void shift(AnimationChannel& channel, const Shift& by) {
  switch (ownerOf(channel.property)) {
    case Owner::node:
      return shift(channel.object, by.nodes);
    case Owner::mesh:
      return shift(channel.object, by.meshes);
    case Owner::material:
      return shift(channel.object, by.materials);
    case Owner::light:
      if (channel.object >= 0) channel.object = by.lights[static_cast<size_t>(channel.object)];
      return;
    case Owner::camera:
      return shift(channel.object, by.cameras);
  }
}

// Lights of the files' lists stay in front of those with profiles.
void addLights(Model& model, Model& added, Shift& by) {
  std::vector<int> own(model.lights.size());
  std::vector<Light> lights;
  by.lights.resize(added.lights.size());
  const auto profiles = static_cast<int>(model.lightProfiles.size());
  for (Light& light : added.lights) shift(light.profile, profiles);
  const auto take = [&](std::vector<Light>& from, std::vector<int>& places, bool profiled) {
    for (size_t i = 0; i < from.size(); ++i)
      if ((from[i].profile >= 0) == profiled) {
        places[i] = static_cast<int>(lights.size());
        lights.push_back(from[i]);
      }
  };
  for (const bool profiled : {false, true}) take(model.lights, own, profiled), take(added.lights, by.lights, profiled);
  Shift same;
  same.lights = own;
  for (Node& node : model.nodes) shift(node, same);
  for (Animation& animation : model.animations)
    for (AnimationChannel& channel : animation.channels) shift(channel, same);
  model.lights = std::move(lights);
  append(model.lightProfiles, added.lightProfiles);
}

void addVariants(Model& model, const Model& added, Shift& by) {
  for (const std::string& name : added.variants) {
    const auto found = std::ranges::find(model.variants, name);
    by.variants.push_back(static_cast<int>(found - model.variants.begin()));
    if (found == model.variants.end()) model.variants.push_back(name);
  }
}

void addAnimations(Model& model, Model& added, const Shift& by) {
  for (Animation& animation : added.animations) {
    for (AnimationChannel& channel : animation.channels) shift(channel, by);
    const auto same = std::ranges::find_if(
        model.animations, [&](const Animation& other) { return !other.name.empty() && other.name == animation.name; });
    if (same == model.animations.end()) {
      model.animations.push_back(std::move(animation));
      continue;
    }
    const auto samplers = static_cast<int>(same->samplers.size());
    for (AnimationChannel& channel : animation.channels) channel.sampler += samplers;
    append(same->samplers, animation.samplers), append(same->channels, animation.channels);
  }
}

// What the added model shows, below a node of its own in each scene.
void addRoots(Model& model, const Model& added, const Shift& by) {
  Node root;
  root.name = added.name;
  const auto at = static_cast<int>(model.nodes.size());
  if (static_cast<size_t>(added.defaultScene) < added.scenes.size())
    root.children = added.scenes[static_cast<size_t>(added.defaultScene)].nodes;
  for (int& child : root.children) {
    child += by.nodes;
    model.nodes[static_cast<size_t>(child)].parent = at;
  }
  model.nodes.push_back(std::move(root));
  for (Scene& scene : model.scenes) scene.nodes.push_back(at);
}

void addNames(std::vector<std::string>& to, const std::vector<std::string>& from) {
  for (const std::string& name : from)
    if (std::ranges::find(to, name) == to.end()) to.push_back(name);
}

}  // namespace

void addModel(Model& model, Model added) {
  const auto count = [](const auto& list) { return static_cast<int>(list.size()); };
  Shift by{count(model.nodes),
           count(model.meshes),
           count(model.materials),
           count(model.textures),
           count(model.images),
           count(model.cameras),
           count(model.skins),
           {},
           {}};
  addLights(model, added, by);
  addVariants(model, added, by);
  for (Node& node : added.nodes) shift(node, by);
  for (Mesh& mesh : added.meshes)
    for (Primitive& primitive : mesh.primitives) shift(primitive, by, model.variants.size());
  for (Material& material : added.materials) shift(material, by);
  for (Texture& texture : added.textures) shift(texture.image, by.images);
  for (Image& image : added.images) shift(image.fallback, by.images);
  for (Skin& skin : added.skins)
    for (int& joint : skin.joints) shift(joint, by.nodes);
  addAnimations(model, added, by);
  append(model.nodes, added.nodes), append(model.meshes, added.meshes), append(model.materials, added.materials);
  append(model.textures, added.textures), append(model.images, added.images), append(model.cameras, added.cameras);
  append(model.skins, added.skins);
  addRoots(model, added, by);
  addNames(model.extensionsUsed, added.extensionsUsed);
  addNames(model.extensionsRequired, added.extensionsRequired);
}

}  // namespace facet::scene
