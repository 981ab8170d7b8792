#pragma once

// What tests of path-traced pictures are made of.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <vector>

#include "frame/settings.hpp"
#include "support/gltf_builder.hpp"
#include "support/picture.hpp"

namespace facet::test {

inline frame::PictureSettings tracedSettings(int width, int height, int samples,
                                             const char* environment = "builtin:white") {
  frame::PictureSettings settings = bareSettings(width, height);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  settings.quality.transport = frame::Transport::paths;
  settings.quality.samples = samples;
  settings.quality.bounces = 64;
  return settings;
}

// Of the pixels that are covered.
inline glm::dvec3 meanOf(const io::RadianceImage& image) {
  glm::dvec3 sum(0);
  double count = 0;
  for (const glm::vec4& p : image.pixels)
    if (p.w >= 1) sum += glm::dvec3(p), ++count;
  REQUIRE(count > 0);
  return sum / count;
}

// Vertices of a box with outward normals, or with normals to its inside.
inline nlohmann::json addBox(GltfBuilder& builder, const glm::vec3& half, bool inward) {
  std::vector<float> positions, normals;
  std::vector<uint32_t> indices;
  for (int axis = 0; axis < 3; ++axis)
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 n(0), a(0), b(0);
      n[axis] = side, a[(axis + 1) % 3] = 1, b[(axis + 2) % 3] = side;
      if (inward) b = -b;
      const auto first = static_cast<uint32_t>(positions.size() / 3);
      for (const glm::vec2 corner : {glm::vec2(-1, -1), glm::vec2(1, -1), glm::vec2(1, 1), glm::vec2(-1, 1)}) {
        const glm::vec3 p = half * (n + corner.x * a + corner.y * b);
        const glm::vec3 normal = inward ? -n : n;
        positions.insert(positions.end(), {p.x, p.y, p.z});
        normals.insert(normals.end(), {normal.x, normal.y, normal.z});
      }
      for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) indices.push_back(first + i);
    }
  const int position = builder.add(positions, floatType, "VEC3");
  const int normal = builder.add(normals, floatType, "VEC3");
  return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
          {"indices", builder.add(indices, uintType, "SCALAR")}};
}

inline void addPointLight(scene::Model& model, float intensity, const glm::dvec3& place) {
  scene::Light light;
  light.intensity = intensity;
  model.lights.push_back(light);
  scene::Node node;
  node.light = static_cast<int>(model.lights.size()) - 1, node.translation = place;
  model.nodes.push_back(node);
  model.scenes[0].nodes.push_back(static_cast<int>(model.nodes.size()) - 1);
}

// A white Lambertian surface of that albedo: an interface that reflects nothing.
inline void lambert(scene::Material& m, float albedo) {
  m.baseColorFactor = glm::vec4(glm::vec3(albedo), 1);
  m.metallicFactor = 0, m.perceptualRoughnessFactor = 1, m.specularWeight = 0;
}

// Shows that colour whatever lights it, and lets through what its alpha says.
inline nlohmann::json glowing(const glm::vec4& color, const nlohmann::json& extra = nlohmann::json::object()) {
  nlohmann::json m = material({0, 0, 0, color.w});
  m["emissiveFactor"] = {color.x, color.y, color.z};
  m.update(extra);
  return m;
}

}  // namespace facet::test
