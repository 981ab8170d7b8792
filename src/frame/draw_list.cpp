#include "frame/draw_list.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <map>
#include <tuple>

#include "frame/light_profiles.hpp"
#include "frame/mask_levels.hpp"
#include "frame/material_choice.hpp"
#include "ibl/layers.hpp"
#include "ibl/taps.hpp"
#include "optics/microfacet.hpp"
#include "optics/normal_spread.hpp"
#include "scene/deformation.hpp"

namespace facet::frame {

namespace {

using scene::AlphaMode;

layout::LightUniforms lightUniforms(const scene::Light& light, const scene::PlacedLight& placed,
                                    const glm::dvec3& origin) {
  layout::LightUniforms out{};
  const float type = light.type == scene::LightType::directional ? 0.0f
                     : light.type == scene::LightType::point     ? 1.0f
                                                                 : 2.0f;
  out.position = glm::vec4(glm::vec3(placed.position - origin), type);
  out.direction = glm::vec4(glm::vec3(placed.direction),
                            std::isfinite(light.range) && light.range > 0 ? 1 / (light.range * light.range) : 0.0f);
  out.color = glm::vec4(light.color * light.intensity, 0);
  const float cosOuter = std::cos(light.outerConeAngle);
  const float scale = 1 / std::max(0.001f, std::cos(light.innerConeAngle) - cosOuter);
  out.cone = glm::vec4(scale, -cosOuter * scale, 0, 0);
  return out;
}

void addSceneLights(DrawList& list, const scene::Model& model, const scene::FlatScene& flat, const scene::Pose& pose) {
  ProfileWriter profiles(list);
  for (const scene::PlacedLight& placed : flat.lights) {
    const scene::Light& light = pose.lights.of(model.lights, placed.light);
    list.lights.push_back(lightUniforms(light, placed, list.origin));
    list.profiles.push_back(light.profile < 0 ? nullptr : &model.lightProfiles[static_cast<size_t>(light.profile)]);
    if (list.profiles.back()) profiles.give(list.lights.back(), *list.profiles.back(), placed);
  }
}

// Four points on a ring above and before the scene, which together light its centre with about 3 lux each.
void addDemoLights(DrawList& list) {
  const double radius = std::max(list.bounds.radius(), 1e-30);
  const double distance = 3 * radius;
  for (int i = 0; i < 4; ++i) {
    const double angle = glm::radians(45.0 + 90.0 * i);
    const glm::dvec3 position = distance * glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 1.2));
    layout::LightUniforms light{};
    light.position = glm::vec4(glm::vec3(position), 1);
    light.direction = glm::vec4(0, 0, -1, 0);
    light.color = glm::vec4(glm::vec3(static_cast<float>(3 * distance * distance)), 0);
    light.cone = glm::vec4(0);
    list.lights.push_back(light);
  }
}

layout::Instance instanceUniforms(const scene::Instance& instance, const glm::dvec3& origin) {
  layout::Instance out{};
  glm::dmat4 world = instance.worldFromNode;
  world[3] -= glm::dvec4(origin, 0);
  const glm::dmat3 normals = scene::normalTransform(instance.worldFromNode);
  out.worldFromLocal = glm::mat4(world);
  for (int column = 0; column < 3; ++column) out.normalFromLocal[column] = glm::vec4(glm::vec3(normals[column]), 0);
  out.normalFromLocal[0].w = instance.mirrored ? -1.0f : 1.0f;
  return out;
}

layout::Joint jointUniforms(const glm::dmat4& worldFromMesh, const glm::dvec3& origin) {
  glm::dmat4 world = worldFromMesh;
  world[3] -= glm::dvec4(origin, 0);
  const glm::mat4 rows(glm::transpose(world));
  return {{rows[0], rows[1], rows[2]}};
}

// Where each skin's matrices begin; -1: not used.
std::vector<int> addJoints(DrawList& list, const scene::FlatScene& flat) {
  std::vector<int> first;
  for (const std::vector<glm::dmat4>& joints : flat.joints) {
    first.push_back(joints.empty() ? -1 : static_cast<int>(list.joints.size()));
    for (const glm::dmat4& joint : joints) list.joints.push_back(jointUniforms(joint, list.origin));
  }
  return first;
}

int materialIndex(const scene::Primitive& primitive, const DrawList& list, const DrawOptions& options) {
  const int defaultMaterial = static_cast<int>(list.materials.size()) - 1;
  if (options.material.on) return 0;
  const auto variant = static_cast<size_t>(options.variant);
  if (options.variant >= 0 && variant < primitive.variantMaterials.size() && primitive.variantMaterials[variant] >= 0)
    return primitive.variantMaterials[variant];
  return primitive.material >= 0 ? primitive.material : defaultMaterial;
}

// What is drawn of one mesh by one call: same handedness, all with a skin or all without.
struct Placed {
  const scene::Instance* instance = nullptr;
  std::vector<float> weights;         // of morph targets; empty: the mesh has none
  std::vector<scene::Bounds> bounds;  // world; by primitive
};

bool anyWeight(const std::vector<Placed>& placed) {
  return std::ranges::any_of(
      placed, [](const Placed& p) { return std::ranges::any_of(p.weights, [](float w) { return w != 0; }); });
}

void addInstance(DrawList& list, const Placed& placed, const std::vector<int>& firstJoints) {
  layout::Instance uniforms = instanceUniforms(*placed.instance, list.origin);
  if (placed.instance->skin >= 0)
    uniforms.deformation.x = static_cast<uint32_t>(firstJoints[static_cast<size_t>(placed.instance->skin)]);
  uniforms.deformation.y = static_cast<uint32_t>(list.morphWeights.size());
  for (size_t target = 0; target < placed.weights.size(); ++target)
    if (placed.weights[target] != 0)
      list.morphWeights.push_back({static_cast<uint32_t>(target), placed.weights[target]});
  uniforms.deformation.z = static_cast<uint32_t>(list.morphWeights.size()) - uniforms.deformation.y;
  uniforms.deformation.w = static_cast<uint32_t>(placed.instance->node);
  list.instances.push_back(uniforms);
  list.instanceNodes.push_back(placed.instance->node);
}

// Nodes that share a mesh become one draw per primitive.
void addInstances(DrawList& list, const scene::Mesh& mesh, const std::vector<Placed>& placed,
                  const std::vector<int>& firstJoints, const DrawOptions& options) {
  const auto first = static_cast<uint32_t>(list.instances.size());
  for (const Placed& p : placed) addInstance(list, p, firstJoints);
  const shading::Deformation deformation{placed.front().instance->skin >= 0, options.moving || anyWeight(placed)};
  for (size_t i = 0; i < mesh.primitives.size(); ++i) {
    const scene::Primitive& primitive = mesh.primitives[i];
    if (primitive.positions.empty()) continue;
    Draw draw;
    draw.primitive = &primitive;
    draw.material = materialIndex(primitive, list, options);
    const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
    draw.key = shading::variantKey({material, primitive, list.features, deformation});
    draw.mirrored = placed.front().instance->mirrored;
    draw.doubleSided = material.doubleSided;
    draw.firstInstance = first;
    draw.firstBounds = static_cast<uint32_t>(list.instanceBounds.size());
    draw.instanceCount = static_cast<uint32_t>(placed.size());
    for (const Placed& p : placed) list.instanceBounds.push_back(p.bounds[i]);
    if (shading::usesFeature(draw.key, shading::Feature::transmission)) {
      list.transmitting.push_back(draw);
      continue;
    }
    if (material.alphaMode != AlphaMode::blend || !shading::showsLight(list.features.channel)) {
      list.opaque.push_back(draw);
      continue;
    }
    draw.instanceCount = 1;
    for (size_t instance = 0; instance < placed.size(); ++instance, ++draw.firstInstance, ++draw.firstBounds)
      list.blended.push_back(draw);
  }
}

Placed place(const scene::Model& model, const scene::FlatScene& flat, const scene::Instance& instance,
             const scene::Pose& pose, scene::MorphedBounds& morphed) {
  Placed placed{&instance, {}, {}};
  const scene::Mesh& mesh = model.meshes[static_cast<size_t>(instance.mesh)];
  placed.weights = scene::morphWeights(mesh, pose.nodes.of(model.nodes, instance.node));
  std::span<const glm::dmat4> joints;
  if (instance.skin >= 0) joints = flat.joints[static_cast<size_t>(instance.skin)];
  for (const scene::Primitive& primitive : mesh.primitives)
    placed.bounds.push_back(scene::deformedBounds(primitive, placed.weights, joints, instance.worldFromNode, morphed));
  return placed;
}

void addMaterials(DrawList& list, const scene::Model& model, const DrawOptions& options, const scene::Pose& pose) {
  if (options.material.on) {
    list.materials = {overridingMaterial(options.material)};
  } else {
    list.materials = model.materials;
    for (const auto& [index, material] : pose.materials.changed) list.materials[static_cast<size_t>(index)] = material;
  }
  for (scene::Material& material : list.materials)
    for (const scene::Effect effect : scene::effects)
      if (options.without & scene::bitOf(effect)) scene::leaveOut(material, effect);
  list.materials.emplace_back();
  const bool showsAlpha = shading::isChannel(options.features.channel, shading::Channel::alpha);
  for (size_t i = 0; i < list.materials.size(); ++i)
    list.maskThresholds.push_back(showsAlpha ? 0 : maskThreshold(model, list.materials[i], static_cast<int>(i)));
}

void sortByProgram(DrawList& list) {
  for (std::vector<Draw>* draws : {&list.opaque, &list.transmitting})
    std::ranges::stable_sort(*draws, {}, [](const Draw& d) { return std::tuple(d.key, d.material, d.firstBounds); });
}

constexpr auto sheenLayerRoughness = static_cast<float>(ibl::layers[layout::sheenLayer].perceptualRoughness);

struct RoughnessRange {
  float lowest = 1, highest = 0;
  void add(float from, float to) { lowest = std::min(lowest, from), highest = std::max(highest, to); }
};

// Of a material's lobes that look LD up. A texture's texels lie within [0, 1] and scale their factor.
void addLobes(RoughnessRange& range, const scene::Material& material, const shading::VariantKey& key) {
  const bool textured = shading::usesFeature(key, shading::Feature::metallicRoughnessTexture);
  RoughnessRange lobes;
  if (material.specularGlossiness) {
    lobes.add(1 - material.glossinessFactor, textured ? 1 : 1 - material.glossinessFactor);
  } else {
    lobes.add(textured ? 0 : material.perceptualRoughnessFactor, material.perceptualRoughnessFactor);
  }
  // A long lobe is a sum of round ones that are at least as wide as it is across its grain.
  if (shading::usesFeature(key, shading::Feature::anisotropy)) lobes.highest = 1;
  if (shading::usesFeature(key, shading::Feature::clearcoat)) {
    const float coat = material.clearcoatRoughnessFactor;
    lobes.add(shading::usesFeature(key, shading::Feature::clearcoatRoughnessTexture) ? 0 : coat, coat);
  }
  if (shading::usesFeature(key, shading::Feature::spreadNormals))
    lobes.highest = static_cast<float>(optics::largestRoughnessOverPixel(static_cast<double>(lobes.highest)));
  range.add(lobes.lowest, lobes.highest);
  if (shading::usesFeature(key, shading::Feature::sheen)) range.add(sheenLayerRoughness, sheenLayerRoughness);
}

}  // namespace

layout::LightUniforms sunUniforms(const scene::Sun& sun) {
  layout::LightUniforms out{};
  out.position = glm::vec4(0, 0, 0, 3);
  out.direction = glm::vec4(glm::vec3(-sun.direction), 0);
  out.color = glm::vec4(glm::vec3(sun.irradiance), 0);
  // A narrower lobe of F = 1 would exceed half range at its peak, D(0) / 4 times the irradiance: the frame would cut
  // it.
  constexpr double largestPeak = 32768;
  const double most = std::max({sun.irradiance.x, sun.irradiance.y, sun.irradiance.z});
  const double leastAlpha = std::sqrt(most / (4 * optics::pi * largestPeak));
  out.cone = glm::vec4(static_cast<float>(sun.angularRadius), static_cast<float>(2 * leastAlpha), 0, 0);
  return out;
}

ibl::Needs DrawList::needs(bool environmentVisible, float backgroundBlur) const {
  ibl::Needs needs;
  RoughnessRange range;
  int taps = 0;
  needs.background = environmentVisible && ibl::showsMap(backgroundBlur);
  if (environmentVisible) needs.backgroundBlur = backgroundBlur;
  for (const std::vector<Draw>* draws : classes())
    for (const Draw& draw : *draws) {
      const bool imageLight = shading::usesFeature(draw.key, shading::Feature::environment) && !features.paths;
      if (shading::isMeasured(draw.key)) {
        needs.samples |= imageLight;
        continue;
      }
      needs.irradiance |= imageLight;
      (draw.key.imageLightSamples == 0 ? needs.layers : needs.samples) |= imageLight;
      if (imageLight && draw.key.imageLightSamples == 0)
        addLobes(range, materials[static_cast<size_t>(draw.material)], draw.key);
      taps = std::max(taps, shading::imageLightTaps(draw.key));
      needs.dfg |= shading::readsDfgTable(draw.key);
      needs.sheen |= shading::usesFeature(draw.key, shading::Feature::sheen);
    }
  if (features.paths || features.difference || ground) {
    needs.texels = features.environment;
    needs.background |= features.environment;
    if (features.paths) taps = 0;
  }
  needs.taps = taps > 0;
  if (needs.taps) {
    const ibl::TapRoughness reached =
        ibl::tapRoughness(taps, std::max(range.lowest, 0.0f), std::min(range.highest, 1.0f));
    range.add(reached.lowest, reached.highest);
  }
  if (needs.layers) {
    needs.lowestRoughness = std::clamp(range.lowest, 0.0f, 1.0f);
    needs.highestRoughness = std::clamp(range.highest, 0.0f, 1.0f);
  }
  return needs;
}

DrawList buildDrawList(const scene::Model& model, int scene, const DrawOptions& options, const scene::Pose& pose) {
  DrawList list;
  const scene::FlatScene flat = scene::flatten(model, scene, pose);
  // Instances of one call: mesh, handedness, with or without a skin.
  std::map<std::tuple<int, bool, bool>, std::vector<Placed>> groups;
  scene::MorphedBounds morphed;
  for (const scene::Instance& instance : flat.instances) {
    Placed placed = place(model, flat, instance, pose, morphed);
    for (const scene::Bounds& bounds : placed.bounds)
      if (!bounds.empty()) list.bounds.add(bounds.min), list.bounds.add(bounds.max);
    groups[{instance.mesh, instance.mirrored, instance.skin >= 0}].push_back(std::move(placed));
  }
  list.origin = list.bounds.empty() ? glm::dvec3(0) : list.bounds.center();
  for (const scene::PlacedCamera& placed : flat.cameras)
    list.cameras.push_back({placed, pose.cameras.of(model.cameras, placed.camera)});
  list.overflowed = flat.overflowed;
  addMaterials(list, model, options, pose);
  if (options.sceneLights) addSceneLights(list, model, flat, pose);
  if (options.demoLights) addDemoLights(list);
  if (options.sun && options.features.environment) list.lights.push_back(sunUniforms(*options.sun));
  list.features = options.features;
  list.features.punctualLights = !list.lights.empty();
  list.features.lightProfiles = !list.profileNumbers.empty();
  list.compared = options.compared;
  list.ground = options.ground && tracedSizes.holds(list.bounds) && !list.bounds.empty();
  const std::vector<int> firstJoints = addJoints(list, flat);
  for (const auto& [key, placed] : groups)
    addInstances(list, model.meshes[static_cast<size_t>(std::get<0>(key))], placed, firstJoints, options);
  sortByProgram(list);
  setTracing(list, options);
  return list;
}

DrawList partOf(const DrawList& list, const std::function<bool(int node, const scene::Primitive&)>& wanted,
                int channel) {
  DrawList part;
  part.origin = list.origin;
  part.materials = list.materials, part.maskThresholds = list.maskThresholds;
  part.features = list.features;
  part.features.channel = channel;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws) {
      const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
      const shading::Deformation deformation{shading::usesFeature(draw.key, shading::Feature::skin),
                                             shading::usesFeature(draw.key, shading::Feature::morphTargets)};
      for (uint32_t i = 0; i < draw.instanceCount; ++i) {
        if (!wanted(list.instanceNodes[draw.firstInstance + i], *draw.primitive)) continue;
        Draw one = draw;
        one.firstInstance += i;
        one.instanceCount = 1;
        one.firstBounds = static_cast<uint32_t>(part.instanceBounds.size());
        one.key = shading::variantKey({material, *draw.primitive, part.features, deformation});
        const scene::Bounds& bounds = list.instanceBounds[draw.firstBounds + i];
        part.instanceBounds.push_back(bounds);
        if (!bounds.empty()) part.bounds.add(bounds.min), part.bounds.add(bounds.max);
        part.opaque.push_back(one);
      }
    }
  sortByProgram(part);
  return part;
}

scene::Bounds boundsOf(const DrawList& list, const std::function<bool(int node)>& wanted) {
  scene::Bounds all;
  for (const std::vector<Draw>* draws : list.classes())
    for (const Draw& draw : *draws)
      for (uint32_t i = 0; i < draw.instanceCount; ++i) {
        const scene::Bounds& box = list.instanceBounds[draw.firstBounds + i];
        if (!box.empty() && wanted(list.instanceNodes[draw.firstInstance + i])) all.add(box.min), all.add(box.max);
      }
  return all;
}

void setFeatures(DrawList& list, shading::FrameFeatures features) {
  assert(features.channel == list.features.channel);
  features.punctualLights = list.features.punctualLights;
  features.lightProfiles = list.features.lightProfiles;
  list.features = features;
  for (std::vector<Draw>* draws : {&list.opaque, &list.transmitting, &list.blended})
    for (Draw& draw : *draws) {
      const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
      const shading::Deformation deformation{shading::usesFeature(draw.key, shading::Feature::skin),
                                             shading::usesFeature(draw.key, shading::Feature::morphTargets)};
      draw.key = shading::variantKey({material, *draw.primitive, list.features, deformation});
    }
  sortByProgram(list);
}

}  // namespace facet::frame
