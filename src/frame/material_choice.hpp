#pragma once

#include <glm/glm.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "scene/edit.hpp"

namespace facet::scene {
struct Material;
}

namespace facet::frame {

// One material for everything, in place of the file's. What has no normals, because its own material is unlit, stays
// unlit.
struct MaterialChoice {
  bool on = false;
  glm::vec3 baseColor = glm::vec3(0.8f);  // linear Rec. 709, [0, 1]
  float metallic = 0;
  float perceptualRoughness = 0.4f;
  float ior = 1.5f;    // of the dielectric, [1, 3]
  std::string preset;  // metal or dielectric (optics/presets.hpp); empty: none
  scene::Edits edits;  // of what extensions add, by names that a material has: "/clearcoatFactor"

  bool operator==(const MaterialChoice&) const = default;
};

// A metal sets the base colour to its F at normal incidence and metallic to 1, a dielectric the index of refraction and
// metallic to 0. Roughness, and a dielectric's colour, are not the substance's: they stay. Empty: all stays.
void choosePreset(MaterialChoice& choice, std::string_view name);

// Switches it on, with these values of what extensions add. Errors, which name neither file nor place: a material has
// no such property.
Result<void> chooseLayers(MaterialChoice& choice, scene::Edits edits);

// Layers that extensions add to a material, as the command line calls them, in the order of scene::Effect: bit i of
// Look::without is of word i.
std::vector<std::string_view> layerWords();

// What everything is made of where the choice is on.
scene::Material overridingMaterial(const MaterialChoice& choice);

}  // namespace facet::frame
