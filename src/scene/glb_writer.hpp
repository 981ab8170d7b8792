#pragma once

// Writes generated shapes as binary glTF.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "scene/shapes.hpp"

namespace facet::scene {

// Build up `gltf` by hand where no function does it; glb() joins both parts.
struct GlbWriter {
  nlohmann::json gltf;
  std::vector<uint8_t> binary;
};

GlbWriter startGlb();

// A primitive's "attributes" and "indices", to which a material is added; primitives may share one.
nlohmann::json addShape(GlbWriter& writer, const Shape& shape);

// Each returns the new object's index.
int addMaterial(GlbWriter& writer, const std::string& name, const glm::dvec3& baseColor, double metallic,
                double perceptualRoughness);
int addMesh(GlbWriter& writer, const std::string& name, nlohmann::json primitive, int material);
// Several primitives, each with its material.
int addMesh(GlbWriter& writer, const std::string& name, const std::vector<std::pair<nlohmann::json, int>>& parts);
int addMesh(GlbWriter& writer, const std::string& name, const std::vector<std::pair<Shape, int>>& parts);
// KHR_materials_emissive_strength.
void setGlow(GlbWriter& writer, int material, const glm::dvec3& color, double strength);
int addPngTexture(GlbWriter& writer, const std::vector<uint8_t>& png);  // its image too
// mesh -1: none.
nlohmann::json nodeAt(const std::string& name, const glm::dvec3& translation, int mesh = -1);
int addNode(GlbWriter& writer, nlohmann::json node);  // also a root of the scene
int addChild(GlbWriter& writer, int parent, nlohmann::json node);
// Of a node, without a node of its own.
int addLight(GlbWriter& writer, const std::string& name, double candela);
int addPointLight(GlbWriter& writer, const std::string& name, const glm::dvec3& position, double candela);

// What moves: a node's "rotation", "translation", or what a JSON pointer names (KHR_animation_pointer). Keys share
// their times; width: numbers a key.
struct Track {
  int node = -1;
  std::string path;  // a pointer begins with /
  int width = 4;
  std::vector<float> values;
};
// Linear between the keys; one animation for all that move together.
void addAnimation(GlbWriter& writer, const std::string& name, const std::vector<float>& times,
                  const std::vector<Track>& tracks);

void useExtension(GlbWriter& writer, const std::string& name);  // in extensionsUsed, once

std::vector<uint8_t> glb(const GlbWriter& writer);

}  // namespace facet::scene
