#include "frame/material_choice.hpp"

#include "optics/presets.hpp"
#include "scene/edited.hpp"
#include "scene/usage.hpp"

namespace facet::frame {

void choosePreset(MaterialChoice& choice, std::string_view name) {
  choice.preset = name;
  if (const optics::MetalPreset* metal = optics::findMetal(name)) {
    choice.baseColor = metal->f0();
    choice.metallic = 1;
  } else if (const optics::DielectricPreset* dielectric = optics::findDielectric(name)) {
    choice.ior = static_cast<float>(dielectric->ior);
    choice.metallic = 0;
  }
}

Result<void> chooseLayers(MaterialChoice& choice, scene::Edits edits) {
  if (const Result<scene::Material> known = scene::edited({}, edits); !known)
    return fail({}, {}, known.error().problem, known.error().remedy);
  choice.on = true;
  choice.edits = std::move(edits);
  return {};
}

std::vector<std::string_view> layerWords() {
  std::vector<std::string_view> words;
  for (const scene::Effect effect : scene::effects) words.push_back(scene::word(effect));
  return words;
}

scene::Material overridingMaterial(const MaterialChoice& choice) {
  scene::Material material;
  material.baseColorFactor = glm::vec4(choice.baseColor, 1);
  material.metallicFactor = choice.metallic;
  material.perceptualRoughnessFactor = choice.perceptualRoughness;
  material.ior = choice.ior;
  if (optics::findMetal(choice.preset)) material.conductor = choice.preset;
  Result<scene::Material> edited = scene::edited(material, choice.edits);
  return edited ? std::move(*edited) : material;  // whoever makes the choice checks it
}

}  // namespace facet::frame
