#include "scene/changes.hpp"

#include <catch2/catch.hpp>

using namespace facet::scene;

namespace {

using Lines = std::vector<std::string>;

Model example() {
  Model model;
  model.scenes = {{.name = "all", .nodes = {0, 1}}};
  Primitive p;
  p.positions = {{0, 0, 0}, {2, 0, 0}, {0, 1, 0}};
  p.bounds = {{0, 0, 0}, {2, 1, 0}};
  p.material = 0;
  model.meshes = {{.name = "leaf", .primitives = {p}}};
  Node leaf, lamp;
  leaf.name = "branch", leaf.mesh = 0, lamp.name = "lamp", lamp.light = 0;
  model.nodes = {leaf, lamp};
  Material brass;
  brass.name = "brass", brass.perceptualRoughnessFactor = 0.3f;
  model.materials = {brass};
  Image image;
  image.name = "scratches";
  model.images = {image};
  model.textures = {Texture{}};
  model.textures[0].image = 0;
  Light light;
  light.name = "sun", light.intensity = 3;
  model.lights = {light};
  model.cameras = {{.name = "door", .fovY = 0.5}};
  model.variants = {"day"};
  model.extensionsUsed = {"KHR_lights_punctual"};
  return model;
}

}  // namespace

TEST_CASE("Changes: a model does not differ from itself, nor by how a placement is written") {
  CHECK(changesBetween(example(), example()).empty());
  Model as = example();
  as.nodes[0].matrix = glm::dmat4(1);
  CHECK(changesBetween(example(), as).empty());
}

TEST_CASE("Changes: each is a line that names what, from what, to what") {
  const auto changed = [](void (*change)(Model&)) {
    Model after = example();
    change(after);
    return changesBetween(example(), after);
  };
  CHECK(changed([](Model& m) { m.materials[0].perceptualRoughnessFactor = 0.5f; }) ==
        Lines{"material 'brass': roughnessFactor 0.3 -> 0.5"});
  CHECK(changed([](Model& m) {
          m.materials[0].baseColorFactor = {1, 0.5f, 0, 1};
        }) == Lines{"material 'brass': baseColorFactor 1, 1, 1, 1 -> 1, 0.5, 0, 1"});
  CHECK(changed([](Model& m) { m.materials[0].baseColor.texture = 0, m.materials[0].doubleSided = true; }) ==
        Lines{"material 'brass': baseColorTexture none -> 'scratches'", "material 'brass': doubleSided no -> yes"});
  CHECK(changed([](Model& m) { m.materials[0].alphaMode = AlphaMode::blend; }) ==
        Lines{"material 'brass': alphaMode OPAQUE -> BLEND"});
  CHECK(changed([](Model& m) { m.materials[0].name = "gold"; }) ==
        Lines{"material 'brass': is gone", "material 'gold': is new"});
  CHECK(changed([](Model& m) { m.nodes[0].scale = glm::dvec3(100); }) ==
        Lines{"size: 2 x 1 x 0 m -> 200 x 100 x 0 m", "node 'branch': is placed otherwise"});
  CHECK(changed([](Model& m) { m.nodes[1].name = "branch"; }) ==
        Lines{"node 'lamp': is gone"});  // the other is not unique
  CHECK(changed([](Model& m) { m.nodes[1].visible = false; }) == Lines{"node 'lamp': visible yes -> no"});
  CHECK(changed([](Model& m) { m.lights[0].intensity = 4.5f; }) == Lines{"light 'sun': intensity 3 -> 4.5"});
  CHECK(changed([](Model& m) { m.cameras[0].fovY = 0.25; }) == Lines{"camera 'door': yfov 0.5 -> 0.25"});
  CHECK(changed([](Model& m) { m.cameras[0].perspective = false; }) ==
        Lines{"camera 'door': projection perspective -> orthographic"});
  CHECK(changed([](Model& m) { m.variants.push_back("night"); }) ==
        Lines{"variants: 1 -> 2", "variant 'night': is new"});
  CHECK(changed([](Model& m) { m.extensionsUsed = {"KHR_materials_sheen"}; }) ==
        Lines{"extension KHR_lights_punctual: is gone", "extension KHR_materials_sheen: is new"});
  CHECK(changed([](Model& m) {
          m.meshes[0].primitives[0].positions.push_back({1, 1, 0});
          m.meshes[0].primitives[0].indices = {0, 1, 2, 1, 3, 2};
        }) == Lines{"vertices: 3 -> 4", "triangles: 1 -> 2", "mesh 'leaf': vertices 3 -> 4",
                    "mesh 'leaf': triangles 1 -> 2"});
  CHECK(changed([](Model& m) { m.meshes.push_back(m.meshes[0]), m.meshes[1].name = "thorn"; }) ==
        Lines{"vertices: 3 -> 6", "triangles: 1 -> 2", "meshes: 1 -> 2", "mesh 'thorn': is new"});
  CHECK(changed([](Model& m) { m.scenes[0].nodes.clear(); }) == Lines{"size: 2 x 1 x 0 m -> nothing"});
}
