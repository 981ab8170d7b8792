#include <algorithm>

#include "io/gltf_document.hpp"
#include "io/uri.hpp"

namespace facet::io {

namespace {

// Everything that is read; each name is listed here once.
constexpr std::string_view supportedExtensions[] = {
    "KHR_lights_punctual",                  // gltf_lights.cpp
    "KHR_texture_transform",                // gltf_materials.cpp
    "KHR_materials_unlit",                  // gltf_materials.cpp
    "KHR_materials_pbrSpecularGlossiness",  // gltf_materials.cpp
    "KHR_materials_emissive_strength",      // gltf_materials.cpp
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
    "EXT_texture_webp",                     // gltf_materials.cpp, image.cpp
};

// Where a required extension can be had without.
struct Remedy {
  std::string_view extension, remedy;
};
constexpr Remedy remedies[] = {
    {"KHR_texture_basisu",
     "export the model with PNG, JPEG or WebP textures: KTX2 needs a Basis Universal transcoder, which facet lacks"},
};

bool supported(std::string_view name) {
  return std::find(std::begin(supportedExtensions), std::end(supportedExtensions), name) !=
         std::end(supportedExtensions);
}

std::string remedyFor(std::string_view name) {
  for (const auto& entry : remedies) {
    if (entry.extension == name) return std::string(entry.remedy);
  }
  return "export the model without it";
}

}  // namespace

Result<void> checkExtensions(Document& doc) {
  for (size_t i = 0; i < doc.model.extensionsRequired.size(); ++i) {
    const std::string& name = doc.model.extensionsRequired[i];
    if (supported(name)) continue;
    return doc.error(pointer("/extensionsRequired", i),
                     "the model requires the extension " + inQuotes(name) + ", which is not supported",
                     remedyFor(name));
  }
  for (size_t i = 0; i < doc.model.extensionsUsed.size(); ++i) {
    const std::string& name = doc.model.extensionsUsed[i];
    if (!supported(name)) doc.info(pointer("/extensionsUsed", i), name + " is not supported yet: shown without");
  }
  return {};
}

}  // namespace facet::io
