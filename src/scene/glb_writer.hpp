#pragma once

// Writes generated shapes as binary glTF.

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
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
int addPngTexture(GlbWriter& writer, const std::vector<uint8_t>& png);  // its image too
int addNode(GlbWriter& writer, nlohmann::json node);                    // also a root of the scene
int addPointLight(GlbWriter& writer, const std::string& name, const glm::dvec3& position, double candela);

void useExtension(GlbWriter& writer, const std::string& name);  // in extensionsUsed, once

std::vector<uint8_t> glb(const GlbWriter& writer);

}  // namespace facet::scene
