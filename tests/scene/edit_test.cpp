#include "scene/edit.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "scene/edited.hpp"
#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"
#include "scene/usage.hpp"

using namespace facet;
using namespace facet::scene;

namespace {

// Two materials of one name and one of another; a mesh with two targets, drawn twice; a spot and a camera.
Model things() {
  Model model;
  model.name = "things.glb";
  model.materials.resize(3);
  model.materials[0].name = model.materials[2].name = "Gold";
  model.materials[1].name = "a/b~c";
  model.materials[1].baseColor.texture = model.materials[1].normal.texture = 0;
  model.textures.resize(1);
  model.meshes.resize(1);
  model.meshes[0].weights = {0.25f, 0.5f};
  model.meshes[0].primitives.resize(1);
  model.meshes[0].primitives[0].positions.resize(3);
  model.meshes[0].primitives[0].targets.resize(2);
  model.nodes.resize(3);
  model.nodes[0].mesh = model.nodes[1].mesh = 0;
  model.nodes[0].name = "Face";
  model.nodes[1].weights = {1, 1};
  model.nodes[2].matrix = glm::dmat4(2);
  model.lights.resize(1);
  model.lights[0].type = LightType::spot;
  model.cameras.resize(1);
  model.scenes.push_back({"", {0, 1, 2}, -1});
  return model;
}

Edits edits(const std::string& text) {
  const Result<Edits> parsed = parseEdits(text);
  REQUIRE(parsed);
  return *parsed;
}

Pose posed(const Model& model, const std::string& text) {
  Pose pose;
  const Result<void> applied = applyEdits(pose, model, edits(text));
  INFO(text << ": " << (applied ? "" : describe(applied.error())));
  REQUIRE(applied);
  return pose;
}

std::string refusal(const std::string& text) {
  const Result<Edits> parsed = parseEdits(text);
  if (!parsed) return describe(parsed.error());
  Pose pose;
  const Result<void> applied = applyEdits(pose, things(), *parsed);
  return applied ? "applied" : describe(applied.error());
}

}  // namespace

TEST_CASE("Edits are text and back", "[scene][edits]") {
  const std::string text =
      "/materials/0/roughnessFactor=0.2;/materials/1/normalTexture=none;/nodes/2/visible=false;"
      "/materials/0/alphaMode=blend;/nodes/0/translation=0.1,-2,1e-09;/materials/2/doubleSided=true";
  CHECK(writeEdits(edits(text)) == text);
  CHECK(edits(text)[0].values == std::vector{0.2});
  CHECK(edits(text)[1].values.empty());
  CHECK(edits(text)[3].values == std::vector{2.0});
  CHECK(edits("  materials/0/ior=1.4 ; ")[0].pointer == "/materials/0/ior");
}

TEST_CASE("Every number of a material is set by its path, and within its range", "[scene][edits]") {
  const Model model = things();
  for (const MaterialProperty& property : materialProperties()) {
    const auto count = static_cast<size_t>(componentCount(property));
    for (const double value : {0.375, -3.0, 1e9}) {
      Edit edit{"/materials/1/" + std::string(property.path), std::vector<double>(count, value)};
      INFO(edit.pointer << " = " << value);
      Pose pose;
      REQUIRE(applyEdits(pose, model, {edit}));
      Material got = pose.materials.of(model.materials, 1);
      for (const float component : components(got, property)) CHECK(component == inRange(property, value));
    }
  }
}

TEST_CASE("Objects by index, by name, all of them, paths by their end", "[scene][edits]") {
  const Model model = things();
  const auto roughness = [&](const std::string& pointer, int material) {
    return posed(model, pointer + "=0.25").materials.of(model.materials, material).perceptualRoughnessFactor;
  };
  CHECK(roughness("/materials/1/pbrMetallicRoughness/roughnessFactor", 1) == 0.25f);
  CHECK(roughness("/materials/1/roughnessFactor", 0) == 1);
  CHECK(roughness("/materials/Gold/roughnessFactor", 0) == 0.25f);
  CHECK(roughness("/materials/Gold/roughnessFactor", 2) == 0.25f);
  CHECK(roughness("/materials/Gold/roughnessFactor", 1) == 1);
  CHECK(roughness("/materials/a~1b~0c/roughnessFactor", 1) == 0.25f);
  for (int i = 0; i < 3; ++i) CHECK(roughness("materials/*/roughnessFactor", i) == 0.25f);
  CHECK(posed(model, "/lights/0/intensity=7").lights.of(model.lights, 0).intensity == 7);
  CHECK(posed(model, "/extensions/KHR_lights_punctual/lights/0/intensity=7").lights.of(model.lights, 0).intensity == 7);
  CHECK(posed(model, "/cameras/0/yfov=0.5").cameras.of(model.cameras, 0).fovY == 0.5);
}

TEST_CASE("What is no number of a material", "[scene][edits]") {
  const Model model = things();
  CHECK(posed(model, "/materials/0/alphaMode=mask").materials.of(model.materials, 0).alphaMode == AlphaMode::mask);
  CHECK(posed(model, "/materials/0/doubleSided=true").materials.of(model.materials, 0).doubleSided);
  const Material bare = posed(model, "/materials/1/normalTexture=none").materials.of(model.materials, 1);
  CHECK(!bare.normal);
  CHECK(bare.baseColor);
  CHECK(!posed(model, "/materials/1/baseColorTexture=none").materials.of(model.materials, 1).baseColor);
}

TEST_CASE("Nodes, morph targets and lights", "[scene][edits]") {
  const Model model = things();
  const auto node = [&](const std::string& text, int index) { return posed(model, text).nodes.of(model.nodes, index); };
  CHECK(node("/nodes/Face/translation=1,2,3", 0).translation == glm::dvec3(1, 2, 3));
  CHECK_FALSE(node("/nodes/1/visible=false", 1).visible);
  // Of any length, but a rotation.
  const glm::dquat turned = node("/nodes/0/rotation=0,0,3,3", 0).rotation;
  CHECK(turned.z == Approx(std::sqrt(0.5)));
  CHECK(glm::length(turned) == Approx(1));
  CHECK(node("/nodes/0/rotation=0,0,0,0", 0).rotation == glm::dquat(1, 0, 0, 0));
  // A matrix is taken apart first.
  const Node moved = node("/nodes/2/translation=5,0,0", 2);
  CHECK_FALSE(moved.matrix);
  CHECK(moved.scale == glm::dvec3(2));
  // One weight leaves the other; the mesh's are those of nodes that have none of their own.
  CHECK(node("/nodes/0/weights/1=0.75", 0).weights == std::vector{0.25f, 0.75f});
  CHECK(node("/nodes/0/weights=0,1", 0).weights == std::vector{0.0f, 1.0f});
  CHECK(node("/meshes/0/weights=0,1", 0).weights == std::vector{0.0f, 1.0f});
  CHECK(node("/meshes/0/weights=0,0.5", 1).weights == std::vector{1.0f, 1.0f});
  // The inner cone stays below the outer one.
  const Light light =
      posed(model, "/lights/0/innerConeAngle=1;/lights/0/outerConeAngle=0.5").lights.of(model.lights, 0);
  CHECK(light.innerConeAngle < light.outerConeAngle);
}

TEST_CASE("Of two edits of one value the later one holds", "[scene][edits]") {
  const Model model = things();
  const Pose pose = posed(model, "/materials/0/ior=1.2;/materials/*/ior=1.7;/materials/2/ior=1.9");
  CHECK(pose.materials.of(model.materials, 0).ior == 1.7f);
  CHECK(pose.materials.of(model.materials, 2).ior == 1.9f);
}

TEST_CASE("What an edit cannot mean is said", "[scene][edits]") {
  const struct {
    const char *edit, *said;
  } rows[] = {
      {"", "nothing is set"},
      {"roughness", "'roughness' sets nothing; give POINTER=VALUE"},
      {"/materials/0/ior=wide", "'wide' is not a number"},
      {"/materials/0/rougnessFactor=1", "there is no 'rougnessFactor'; perhaps roughnessFactor is meant"},
      {"/materials/Silver/ior=1", "of materials there is no 'Silver'"},
      {"/materials/3/ior=1", "give an index from 0 to 2"},
      {"/animations/0/name=1", "begin with /materials/, /nodes/, /meshes/, /lights/ or /cameras/"},
      {"/materials/0=1", "it names no property"},
      {"/nodes/0/translation=1,2", "it has 3 numbers, not 2"},
      {"/materials/0/ior=1,2", "it has 1 number, not 2"},
      {"/materials/0/alphaMode=7", "give opaque, mask or blend"},
      {"/materials/1/normalTexture=1", "a texture can only be left out"},
      {"/materials/1/scale=1", "is the end of several"},
      {"/nodes/2/weights=1", "the node has no morph targets"},
      {"/nodes/0/weights/2=1", "there is no 'weights/2'"},
      {"/nodes/0/weights=1", "it has 2 numbers, not 1"},
      {"/cameras/0/xmag=1", "there is no 'xmag'"},
      {"/nodes/-1/scale=1,1,1", "of nodes there is no '-1'"},
  };
  for (const auto& row : rows) {
    INFO(row.edit << ": " << refusal(row.edit));
    CHECK(refusal(row.edit).find(row.said) != std::string::npos);
  }
}

TEST_CASE("Edits that show what may not have been read", "[scene][edits]") {
  Model model = things();
  model.materials[1].normalScale = 0;
  const auto more = [&](const std::string& text) { return showsMore(model, posed(model, text)); };
  CHECK(more("/materials/1/normalTexture/scale=0.5"));
  CHECK(more("/materials/1/anisotropyStrength=0.5"));
  CHECK_FALSE(more("/materials/1/roughnessFactor=0.5"));
  CHECK_FALSE(more("/materials/1/baseColorTexture=none"));
  CHECK_FALSE(more("/nodes/0/scale=2,2,2"));
}

TEST_CASE("Nodes that are shown alone", "[scene][edits]") {
  Model model = things();
  model.nodes[1].children = {2}, model.nodes[2].parent = 1, model.nodes[2].mesh = 0;
  model.scenes[0].nodes = {0, 1};
  const auto drawn = [&](std::vector<int> only) {
    Pose pose;
    pose.only = std::move(only);
    std::vector<int> nodes;
    for (const Instance& instance : flatten(model, 0, pose).instances) nodes.push_back(instance.node);
    return nodes;
  };
  CHECK(drawn({}) == std::vector{0, 1, 2});
  CHECK(drawn({1}) == std::vector{1, 2});
  CHECK(drawn({2}) == std::vector{2});
  CHECK(drawn({0, 2}) == std::vector{0, 2});
}
