#include "io/gltf_edited.hpp"

#include <catch2/catch.hpp>

#include "io/sources.hpp"
#include "io/validate/validate.hpp"
#include "scene/edited.hpp"
#include "scene/material_properties.hpp"
#include "scene/nodes.hpp"
#include "support/gltf_load.hpp"

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

namespace {

// Two textured materials in two buffers, an image beside the file, one in the text; nodes with and without a matrix.
std::string things(const TemporaryFolder& folder) {
  GltfBuilder b = triangle();
  const std::vector<uint8_t> white = pngBytes(1, 1, 3, 8, std::vector<uint8_t>(3, 255));
  folder.write("white.png", white);
  b.json["images"] = {{{"uri", "white.png"}}, {{"uri", dataUri(white, "image/png")}}};
  b.json["textures"] = {{{"source", 0}}, {{"source", 1}}};
  const std::vector<float> uv(6, 0.5f);
  attributes(b)["TEXCOORD_0"] = b.add(uv, floatType, "VEC2");
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}, {{"POSITION", 0}}};
  for (int i = 0; i < 2; ++i)
    b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", i}}}}},
                           {"normalTexture", {{"index", 0}}},
                           {"extras", {{"kept", i}}}});
  b.append("nodes", {{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 3, 0, 0, 0, 0, 4, 0, 5, 6, 7, 1}}});
  b.json["scenes"][0]["nodes"] = {0, 1};
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "spot"}, {"spot", Json::object()}}};
  b.json["extensionsUsed"] = {"KHR_lights_punctual"};
  return folder.write("things.gltf", b.text()).string();
}

io::LoadedModel written(const std::string& source, const io::Changes& changes, const TemporaryFolder& folder,
                        const std::string& name = "out.glb") {
  Notes notes;
  const auto same = [&](const scene::Model&) { return Result<io::Changes>(changes); };
  const Result<std::vector<uint8_t>> glb = io::editedGlb(source, same, notes);
  INFO((glb ? "" : describe(glb.error())));
  REQUIRE(glb);
  CHECK(notes.empty());
  Result<io::LoadedModel> loaded = io::loadGltf(folder.write(name, *glb));
  INFO((loaded ? "" : describe(loaded.error())));
  REQUIRE(loaded);
  return std::move(*loaded);
}

scene::Edits edits(const std::string& text) { return *scene::parseEdits(text); }

}  // namespace

TEST_CASE("A file that is written anew is the same model", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  const io::LoadedModel before = *io::loadGltf(source), after = written(source, {}, folder);
  CHECK(after.model.meshes[0].primitives[0].positions == before.model.meshes[0].primitives[0].positions);
  CHECK(after.model.nodes[1].matrix == before.model.nodes[1].matrix);
  REQUIRE(after.model.images.size() == 2);
  // Both images within, byte by byte.
  CHECK(after.model.images[0].encoded == before.model.images[1].encoded);
  CHECK(after.model.images[1].encoded == before.model.images[1].encoded);
  // What nobody knows here stays.
  const std::string file = folder.file("out.glb");
  std::string text(std::filesystem::file_size(file), '\0');
  FILE* in = std::fopen(file.c_str(), "rb");
  REQUIRE(std::fread(text.data(), 1, text.size(), in) == text.size());
  std::fclose(in);
  CHECK(text.find(R"("extras":{"kept":1})") != std::string::npos);
}

TEST_CASE("What is changed is what the written file holds, of every number of a material", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  io::Changes changes;
  for (const scene::MaterialProperty& property : scene::materialProperties())
    if (std::string(property.path).find("Texture/") == std::string::npos)
      changes.edits.push_back({"/materials/1/" + std::string(property.path),
                               std::vector<double>(static_cast<size_t>(scene::componentCount(property)), 0.375)});
  const io::LoadedModel after = written(source, changes, folder);
  scene::Material got = after.model.materials[1];
  for (const scene::MaterialProperty& property : scene::materialProperties()) {
    if (std::string(property.path).find("Texture/") != std::string::npos) continue;
    INFO(property.path);
    for (const float component : scene::components(got, property)) CHECK(component == scene::inRange(property, 0.375));
  }
  CHECK(after.model.materials[0].perceptualRoughnessFactor == 1);
  // Its extensions are named.
  CHECK(after.model.extensionsUsed.size() > 8);
}

TEST_CASE("Nodes, lights and the rest of a material in the written file", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  const io::Changes changes{
      edits("/nodes/1/translation=1,2,3;/nodes/0/rotation=0,0,1,1;/nodes/0/visible=false;/nodes/0/weights/1=0.5;"
            "/lights/0/intensity=9;/materials/0/alphaMode=mask;/materials/0/doubleSided=true;"
            "/materials/0/baseColorTexture=none;/materials/0/normalTexture/scale=0.5;"
            "/materials/0/occlusionTexture/strength=0.5"),
      {},
      {}};
  const io::LoadedModel before = *io::loadGltf(source), after = written(source, changes, folder);
  scene::Pose pose;
  REQUIRE(scene::applyEdits(pose, before.model, changes.edits));
  for (int n = 0; n < 2; ++n) {
    INFO("node " << n);
    const glm::dmat4 wanted = scene::localTransform(pose.nodes.of(before.model.nodes, n)),
                     got = scene::localTransform(after.model.nodes[static_cast<size_t>(n)]);
    for (int c = 0; c < 4; ++c) CHECK(glm::distance(wanted[c], got[c]) < 1e-6);
  }
  CHECK_FALSE(after.model.nodes[0].visible);
  CHECK(after.model.nodes[0].weights == std::vector{0.0f, 0.5f});
  CHECK(after.model.lights[0].intensity == 9);
  const scene::Material& material = after.model.materials[0];
  CHECK(material.alphaMode == scene::AlphaMode::mask);
  CHECK(material.doubleSided);
  CHECK_FALSE(material.baseColor);
  CHECK(material.normalScale == 0.5f);
  CHECK_FALSE(material.occlusion);  // there is none that a strength could be of
}

TEST_CASE("A model that is moved, or of which a part is kept, in the written file", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  io::Changes changes;
  changes.worldFromModel = glm::dmat4(3);
  (*changes.worldFromModel)[3] = {1, 2, 3, 1};
  changes.only = {1};
  const io::LoadedModel after = written(source, changes, folder);
  const scene::FlatScene flat = scene::flatten(after.model, 0);
  REQUIRE(flat.instances.size() == 1);
  CHECK(flat.instances[0].node == 1);
  CHECK(flat.instances[0].worldFromNode[3] == glm::dvec4(16, 20, 24, 1));
  CHECK(flat.instances[0].worldFromNode[1] == glm::dvec4(0, 9, 0, 0));
}

TEST_CASE("What is written has nothing wrong that the file had not", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  const glm::dmat4 twice(glm::dmat3(2));
  (void)written(source, {edits("/materials/*/clearcoatFactor=1;/nodes/1/scale=1,1,2"), twice, {0}}, folder);
  const auto errors = [](const std::string& file) {
    const Result<io::validate::Report> report = io::validateModel(file);
    REQUIRE(report);
    return report->count(io::validate::Severity::error);
  };
  CHECK(errors(folder.file("out.glb")) == errors(source));
}

TEST_CASE("An image that is missing keeps its name, with a word", "[io][edits]") {
  const TemporaryFolder folder;
  const std::string source = things(folder);
  std::filesystem::remove(folder.file("white.png"));
  Notes notes;
  const auto none = [](const scene::Model&) { return Result<io::Changes>(io::Changes{}); };
  REQUIRE(io::editedGlb(source, none, notes));
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].place == "/images/0");
}
