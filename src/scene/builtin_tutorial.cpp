#include "scene/builtin_tutorial.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "scene/glb_writer.hpp"
#include "scene/shapes.hpp"

namespace facet::scene {

namespace {

constexpr int side = 7;
constexpr double textFlux = 23.47, codeFlux = 300;

// KHR_lights_punctual has no channel above 1.
void addLight(GlbWriter& w, const std::string& name, const glm::dvec3& at, const glm::dvec3& flux) {
  const int light = addPointLight(w, name, at, flux.r);
  w.gltf["extensions"]["KHR_lights_punctual"]["lights"][size_t(light)]["color"] = {1.0, flux.g / flux.r,
                                                                                   flux.b / flux.r};
}

}  // namespace

std::vector<uint8_t> tutorial() {
  const double unit = std::sqrt(textFlux / codeFlux);  // the tutorial's
  const glm::dvec3 albedo(0.5, 0, 0);
  GlbWriter w = startGlb();
  const nlohmann::json sphere = addShape(w, sphereShape(64, 64));
  for (int row = 0; row < side; ++row)
    for (int column = 0; column < side; ++column) {
      const double metallic = double(row) / side, perceptualRoughness = std::max(double(column) / side, 0.05);
      char name[64];
      std::snprintf(name, sizeof name, "metallic %.2f, roughness %.2f", metallic, perceptualRoughness);
      const glm::dvec3 f0 = glm::mix(glm::dvec3(0.04), albedo, metallic), color = f0 / 0.04;
      const int material = addMaterial(w, name, (1 - metallic) * albedo, 0, perceptualRoughness);
      nlohmann::json& m = w.gltf["materials"][size_t(material)];
      m["emissiveFactor"] = {0.03 * albedo.r, 0.03 * albedo.g, 0.03 * albedo.b};
      m["extensions"]["KHR_materials_specular"]["specularColorFactor"] = {color.r, color.g, color.b};
      m["extensions"]["FACET_materials_models"]["masking"] = "remapped";
      nlohmann::json node = nodeAt(name, 2.5 * unit * glm::dvec3(column - side / 2, row - side / 2, 0),
                                   addMesh(w, name, sphere, material));
      node["scale"] = {unit, unit, unit};
      addNode(w, std::move(node));
    }
  useExtension(w, "KHR_materials_specular");
  useExtension(w, "FACET_materials_models");
  for (const glm::dvec2 corner : {glm::dvec2(-10, 10), {10, 10}, {-10, -10}, {10, -10}}) {
    char name[64];
    std::snprintf(name, sizeof name, "light at x %.0f, y %.0f", corner.x, corner.y);
    addLight(w, name, unit * glm::dvec3(corner, 10), {23.47, 21.31, 20.79});
  }
  return glb(w);
}

}  // namespace facet::scene
