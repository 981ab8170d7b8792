#include "frame/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace facet::frame {

namespace {

using scene::AlphaMode;

layout::LightUniforms lightUniforms(const scene::Light& light, const scene::PlacedLight& placed,
                                    const glm::dvec3& origin) {
  layout::LightUniforms out;
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

// Four points on a ring above and before the scene, which together light its centre with about 3 lux each.
void addDemoLights(DrawList& list) {
  const double radius = std::max(list.bounds.radius(), 1e-30);
  const double distance = 3 * radius;
  for (int i = 0; i < 4; ++i) {
    const double angle = glm::radians(45.0 + 90.0 * i);
    const glm::dvec3 position = distance * glm::normalize(glm::dvec3(std::cos(angle), std::sin(angle), 1.2));
    layout::LightUniforms light;
    light.position = glm::vec4(glm::vec3(position), 1);
    light.direction = glm::vec4(0, 0, -1, 0);
    light.color = glm::vec4(glm::vec3(static_cast<float>(3 * distance * distance)), 0);
    light.cone = glm::vec4(0);
    list.lights.push_back(light);
  }
}

layout::Instance instanceUniforms(const scene::Instance& instance, const glm::dvec3& origin) {
  glm::dmat4 world = instance.worldFromNode;
  world[3] -= glm::dvec4(origin, 0);
  const glm::dmat3 normals = scene::normalTransform(instance.worldFromNode);
  layout::Instance out;
  out.worldFromLocal = glm::mat4(world);
  for (int column = 0; column < 3; ++column) out.normalFromLocal[column] = glm::vec4(glm::vec3(normals[column]), 0);
  out.normalFromLocal[0].w = instance.mirrored ? -1.0f : 1.0f;
  return out;
}

glm::dvec3 primitiveCenter(const scene::Primitive& primitive, const scene::Instance& instance,
                           const glm::dvec3& origin) {
  if (primitive.bounds.empty()) return glm::dvec3(instance.worldFromNode[3]) - origin;
  return glm::dvec3(instance.worldFromNode * glm::dvec4(primitive.bounds.center(), 1)) - origin;
}

int materialIndex(const scene::Primitive& primitive, const DrawList& list, const DrawOptions& options) {
  const int defaultMaterial = static_cast<int>(list.materials.size()) - 1;
  if (options.material) return 0;
  const auto variant = static_cast<size_t>(options.variant);
  if (options.variant >= 0 && variant < primitive.variantMaterials.size() && primitive.variantMaterials[variant] >= 0)
    return primitive.variantMaterials[variant];
  return primitive.material >= 0 ? primitive.material : defaultMaterial;
}

// Nodes that share a mesh become one draw per primitive (and handedness).
void addInstances(DrawList& list, const scene::Mesh& mesh, const std::vector<const scene::Instance*>& placed,
                  const DrawOptions& options) {
  const auto first = static_cast<uint32_t>(list.instances.size());
  for (const scene::Instance* instance : placed) list.instances.push_back(instanceUniforms(*instance, list.origin));
  for (const scene::Primitive& primitive : mesh.primitives) {
    if (primitive.positions.empty()) continue;
    Draw draw;
    draw.primitive = &primitive;
    draw.material = materialIndex(primitive, list, options);
    const scene::Material& material = list.materials[static_cast<size_t>(draw.material)];
    draw.key = shading::variantKey({material, primitive, list.features});
    draw.mirrored = placed.front()->mirrored;
    draw.doubleSided = material.doubleSided;
    draw.firstInstance = first;
    draw.instanceCount = static_cast<uint32_t>(placed.size());
    if (material.alphaMode != AlphaMode::blend || list.features.channel != 0) {
      list.opaque.push_back(draw);
      continue;
    }
    draw.instanceCount = 1;
    for (const scene::Instance* instance : placed) {
      draw.center = glm::vec3(primitiveCenter(primitive, *instance, list.origin));
      list.blended.push_back(draw);
      ++draw.firstInstance;
    }
  }
}

}  // namespace

ibl::Needs DrawList::needs(bool environmentVisible) const {
  ibl::Needs needs;
  needs.background = environmentVisible;
  for (const std::vector<Draw>* draws : {&opaque, &blended})
    for (const Draw& draw : *draws) {
      const bool imageLight = shading::usesFeature(draw.key, "HAS_ENVIRONMENT");
      needs.irradiance |= imageLight;
      (draw.key.imageLightSamples == 0 ? needs.layers : needs.cube) |= imageLight;
      needs.dfg |= imageLight || shading::usesFeature(draw.key, "HAS_PUNCTUAL_LIGHTS");
    }
  return needs;
}

DrawList buildDrawList(const scene::Model& model, int scene, const DrawOptions& options) {
  DrawList list;
  const scene::FlatScene flat = scene::flatten(model, scene);
  list.bounds = scene::sceneBounds(model, flat);
  list.origin = list.bounds.empty() ? glm::dvec3(0) : list.bounds.center();
  list.cameras = flat.cameras;
  list.overflowed = flat.overflowed;
  if (options.material)
    list.materials = {*options.material};
  else
    list.materials = model.materials;
  list.materials.emplace_back();
  if (options.sceneLights)
    for (const scene::PlacedLight& light : flat.lights)
      list.lights.push_back(lightUniforms(model.lights[static_cast<size_t>(light.light)], light, list.origin));
  if (options.demoLights) addDemoLights(list);
  list.features = options.features;
  list.features.punctualLights = !list.lights.empty();

  std::map<std::pair<int, bool>, std::vector<const scene::Instance*>> placed;
  for (const scene::Instance& instance : flat.instances)
    placed[{instance.mesh, instance.mirrored}].push_back(&instance);
  for (const auto& [key, instances] : placed)
    addInstances(list, model.meshes[static_cast<size_t>(key.first)], instances, options);
  std::ranges::stable_sort(list.opaque, {}, [](const Draw& d) { return std::tuple(d.key, d.material); });
  return list;
}

}  // namespace facet::frame
