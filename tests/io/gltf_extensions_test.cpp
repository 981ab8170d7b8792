#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;

}  // namespace

TEST_CASE("A required extension that only concerns looks is left out with a warning", "[io][gltf]") {
  for (const char* name :
       {"KHR_materials_subsurface", "EXT_materials_glow", "KHR_texture_procedurals", "EXT_texture_avif",
        "MSFT_texture_dds", "KHR_lights_area", "EXT_lights_image_based", "KHR_xmp", "KHR_animation_x", "KHR_audio_x",
        "KHR_physics_rigid_bodies", "KHR_interactivity", "KHR_node_hoverability"}) {
    GltfBuilder b = triangle();
    b.json["extensionsUsed"] = b.json["extensionsRequired"] = {name};
    const auto model = loaded(b);
    CHECK(model.model.meshes.size() == 1);
    CHECK(notes(model) == "! /extensionsRequired/0: the model requires the extension \"" + std::string(name) +
                              "\", which is not supported: shown without; export the model without it\n");
  }
  for (const char* name : {"KHR_materials", "KHR_geometry_x", "EXT_mesh_manifold", "ACME_materials_x", ""}) {
    GltfBuilder b = triangle();
    b.json["extensionsRequired"] = {name};
    CHECK(outcome(b.text()) == "m: /extensionsRequired/0: the model requires the extension \"" + std::string(name) +
                                   "\", which is not supported; export the model without it.");
  }
}
