#include "io/gltf_materials.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/json_section.hpp"
#include "io/uri.hpp"
#include "optics/models.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

using Json = nlohmann::json;

void readAlphaMode(Document& doc, const tinygltf::Material& from, const std::string& place, scene::Material& material) {
  if (from.alphaMode == "MASK") {
    material.alphaMode = scene::AlphaMode::mask;
  } else if (from.alphaMode == "BLEND") {
    material.alphaMode = scene::AlphaMode::blend;
  } else if (from.alphaMode != "OPAQUE") {
    doc.warning(place + "/alphaMode", inQuotes(from.alphaMode) + " is not an alpha mode: shown opaque");
  }
}

// "KHR_materials_ior" of "extensions/KHR_materials_ior/ior"; empty for the core's.
std::string_view extensionIn(std::string_view path) {
  constexpr std::string_view head = "extensions/";
  if (!path.starts_with(head)) return {};
  path.remove_prefix(head.size());
  return path.substr(0, path.find('/'));
}

// Unlit and specular-glossiness materials exclude the extensions of metallic-roughness.
bool excluded(const scene::Material& material, std::string_view extension) {
  if (extension.empty() || extension == "KHR_materials_emissive_strength") return false;
  return material.unlit || material.specularGlossiness;
}

Result<void> readProperties(Document& doc, const Json& from, const std::string& place, scene::Material& material) {
  std::string_view told;
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    const std::string_view extension = extensionIn(property.path);
    if (excluded(material, extension)) {
      if (extension == told || !extensionOf(from, std::string(extension).c_str())) continue;
      doc.info(
          place + "/extensions/" + std::string(extension),
          std::string("has no effect on ") + (material.unlit ? "an unlit" : "a specular-glossiness") + " material");
      told = extension;
      continue;
    }
    const auto inRange = [&](double value) { return scene::inRange(property, value); };
    if (auto ok = readNumbers(doc, from, property.path, place, components(material, property), inRange); !ok) return ok;
  }
  for (const scene::TextureSlot slot : scene::textureSlots) {
    if (excluded(material, extensionIn(scene::path(slot)))) continue;
    if (auto ok = readTextureRef(doc, from, scene::path(slot), place, textureRef(material, slot)); !ok) return ok;
  }
  return {};
}

// KHR_materials_pbrSpecularGlossiness: takes the place of the core's metallic-roughness where a file has both.
Result<void> readSpecularGlossiness(Document& doc, const Json& extension, const std::string& place,
                                    scene::Material& material) {
  material.baseColorFactor = glm::vec4(1);
  const struct {
    const char* key;
    std::span<float> to;
  } factors[] = {{"diffuseFactor", {&material.baseColorFactor.x, 4}},
                 {"specularFactor", {&material.specularFactor.x, 3}},
                 {"glossinessFactor", {&material.glossinessFactor, 1}}};
  const auto toUnit = [](double value) { return static_cast<float>(std::clamp(value, 0.0, 1.0)); };
  for (const auto& factor : factors)
    if (auto ok = readNumbers(doc, extension, factor.key, place, factor.to, toUnit); !ok) return ok;
  if (auto ok = readTextureRef(doc, extension, "diffuseTexture", place, material.baseColor); !ok) return ok;
  return readTextureRef(doc, extension, "specularGlossinessTexture", place, material.metallicRoughness);
}

// FACET_materials_models: what our built-in scenes say beyond glTF.
Result<void> readModels(Document& doc, const Json& extension, const std::string& place, scene::Material& material) {
  using scene::Microfacets;
  constexpr std::pair<std::string_view, Microfacets> names[] = {{"", Microfacets::any},
                                                                {"ggx", Microfacets::ggx},
                                                                {"beckmann", Microfacets::beckmann},
                                                                {"blinn", Microfacets::blinn}};
  const std::string wanted = stringAt(extension, "microfacets");
  const auto found =
      std::ranges::find(names, std::string_view(wanted), &std::pair<std::string_view, Microfacets>::first);
  if (found == std::end(names)) return doc.error(place + "/microfacets", "is not ggx, beckmann or blinn");
  material.microfacets = found->second;
  material.masking = stringAt(extension, "masking");
  if (!material.masking.empty() && !rowOfWord(optics::maskings, material.masking))
    return doc.error(place + "/masking", "is not smith, approximate, v-cavity or remapped");
  material.conductor = stringAt(extension, "conductor");
  return {};
}

// Of extensions that add to others which are missing.
void noteMissingParts(Document& doc, const Json& from, const std::string& place, const scene::Material& material) {
  const auto has = [&](const char* name) { return extensionOf(from, name) != nullptr; };
  const bool transmission = has("KHR_materials_transmission");
  if (material.thicknessFactor != 0 && !transmission && !has("KHR_materials_diffuse_transmission"))
    doc.info(place + "/extensions/KHR_materials_volume",
             "has no effect without KHR_materials_transmission or KHR_materials_diffuse_transmission");
  if (material.dispersion != 0 && (!transmission || !has("KHR_materials_volume")))
    doc.info(place + "/extensions/KHR_materials_dispersion",
             "has no effect without KHR_materials_transmission and KHR_materials_volume");
}

Result<void> readMaterial(Document& doc, const Json& json, const std::string& place, const tinygltf::Material& from) {
  scene::Material material;
  material.name = from.name;
  material.doubleSided = from.doubleSided;
  readAlphaMode(doc, from, place, material);
  const Json* glossiness = extensionOf(json, "KHR_materials_pbrSpecularGlossiness");
  material.unlit = extensionOf(json, "KHR_materials_unlit") != nullptr;
  material.specularGlossiness = glossiness != nullptr && !material.unlit;  // unlit says itself what the base colour is
  if (auto ok = readProperties(doc, json, place, material); !ok) return ok;
  if (material.specularGlossiness) {
    const std::string at = place + "/extensions/KHR_materials_pbrSpecularGlossiness";
    if (auto ok = readSpecularGlossiness(doc, *glossiness, at, material); !ok) return ok;
  }
  if (const Json* models = extensionOf(json, "FACET_materials_models"))
    if (auto ok = readModels(doc, *models, place + "/extensions/FACET_materials_models", material); !ok) return ok;
  noteMissingParts(doc, json, place, material);
  doc.model.materials.push_back(std::move(material));
  return {};
}

}  // namespace

Result<void> readMaterials(Document& doc) {
  const auto list = section(doc, "materials");
  if (!list) return tl::unexpected(list.error());
  for (size_t i = 0; i < doc.gltf.materials.size(); ++i)
    if (auto ok = readMaterial(doc, (*list)[i], pointer("/materials", i), doc.gltf.materials[i]); !ok) return ok;
  return {};
}

}  // namespace facet::io
