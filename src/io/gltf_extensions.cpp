#include <algorithm>

#include "io/gltf_document.hpp"
#include "io/uri.hpp"
#include "scene/material_properties.hpp"
#include "scene/usage.hpp"

namespace facet::io {

namespace {

// Everything that is read, but the extensions that a material's properties and textures name.
constexpr std::string_view supportedExtensions[] = {
    "KHR_lights_punctual",                  // gltf_lights.cpp
    "KHR_texture_transform",                // gltf_textures.cpp
    "KHR_materials_unlit",                  // gltf_materials.cpp
    "KHR_materials_pbrSpecularGlossiness",  // gltf_materials.cpp
    "FACET_materials_models",               // gltf_materials.cpp
    "KHR_materials_variants",               // gltf_variants.cpp
    "KHR_mesh_quantization",                // accessors.cpp: all component types are read anyway
    "KHR_draco_mesh_compression",           // gltf_draco.cpp
    "EXT_mesh_gpu_instancing",              // gltf_instancing.cpp
    "KHR_node_visibility",                  // gltf_nodes.cpp
    "KHR_animation_pointer",                // gltf_animation_targets.cpp
    "EXT_meshopt_compression",              // gltf_meshopt.cpp
    "KHR_meshopt_compression",              // gltf_meshopt.cpp
    "KHR_xmp_json_ld",                      // gltf_xmp.cpp
    "EXT_texture_webp",                     // gltf_textures.cpp, image.cpp
    "KHR_texture_basisu",                   // gltf_textures.cpp, ktx2/
    "EXT_texture_avif",                     // gltf_textures.cpp, image_avif.cpp
    "KHR_accessor_float64",                 // accessors.cpp: read wherever floats are
    "MSFT_lod",                             // gltf_nodes.cpp
    "EXT_lights_image_based",               // gltf_nodes.cpp, gltf_environment.cpp
    "EXT_lights_ies",                       // gltf_profiles.cpp
};

// What is lost without these are looks, sounds and motion: the rest can still be shown.
constexpr std::string_view onlyLooks[] = {
    "KHR_materials_", "EXT_materials_",    "KHR_texture_", "EXT_texture_",  "MSFT_texture_",
    "KHR_lights_",    "EXT_lights_",       "KHR_xmp",      "KHR_animation", "KHR_audio",
    "KHR_physics",    "KHR_interactivity", "KHR_node_",
};

// The points themselves are there, unless another extension compresses them.
bool concernsOnlyLooks(std::string_view name) {
  return name == "KHR_gaussian_splatting" ||
         std::ranges::any_of(onlyLooks, [&](std::string_view prefix) { return name.starts_with(prefix); });
}

bool supported(std::string_view name) {
  const std::string head = "extensions/" + std::string(name) + "/";
  const auto names = [&](std::string_view path) { return path.starts_with(head); };
  return std::ranges::find(supportedExtensions, name) != std::end(supportedExtensions) ||
         std::ranges::any_of(scene::materialProperties(), names, &scene::MaterialProperty::path) ||
         std::ranges::any_of(scene::textureSlots, [&](scene::TextureSlot slot) { return names(scene::path(slot)); });
}

}  // namespace

Result<void> checkExtensions(Document& doc) {
  for (size_t i = 0; i < doc.model.extensionsRequired.size(); ++i) {
    const std::string& name = doc.model.extensionsRequired[i];
    if (supported(name)) continue;
    const std::string place = pointer("/extensionsRequired", i);
    const std::string problem = "the model requires the extension " + inQuotes(name) + ", which is not supported";
    if (!concernsOnlyLooks(name)) return doc.error(place, problem, "export the model without it");
    doc.warning(place, problem + ": shown without; export the model without it");
  }
  const auto& required = doc.model.extensionsRequired;
  for (size_t i = 0; i < doc.model.extensionsUsed.size(); ++i) {
    const std::string& name = doc.model.extensionsUsed[i];
    const bool told = supported(name) || std::ranges::find(required, name) != required.end();
    if (!told) doc.info(pointer("/extensionsUsed", i), name + " is not supported yet: shown without");
  }
  return {};
}

}  // namespace facet::io
