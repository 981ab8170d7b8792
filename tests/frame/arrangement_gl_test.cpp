// What is changed of a model without its file: the picture is that of a file in which it is so.

#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "frame/choose.hpp"
#include "scene/nodes.hpp"
#include "support/picture.hpp"

using namespace facet;
using namespace facet::test;

namespace {

// A rough ball and a quad behind it, two nodes.
GltfBuilder ballAndWall() {
  GltfBuilder b = emptyScene();
  b.append("materials", material({0.8, 0.5, 0.2, 1}, 0, 0.6));
  b.append("materials", material({0.2, 0.4, 0.8, 1}, 0, 0.9));
  addMeshNode(b, addSphere(b, 0.5, 12, 24), 0, {{"name", "ball"}});
  addMeshNode(b, addQuad(b, {-1, -1}, {1, 1}), 1, {{"name", "wall"}, {"translation", {0, 0, -1}}});
  return b;
}

frame::PictureSettings settingsOf() {
  frame::PictureSettings settings;
  settings.frame.width = 48, settings.frame.height = 40;
  settings.sources.environment = "builtin:studio";
  settings.viewpoint.orbit = frame::Orbit{20, 80, 4};
  settings.viewpoint.target = glm::dvec3(0);
  settings.quality.samples = 1;
  settings.quality.visibility = frame::Visibility::none;
  return settings;
}

double largestDifference(const frame::Picture& a, const frame::Picture& b) {
  REQUIRE(a.radiance.pixels.size() == b.radiance.pixels.size());
  double most = 0;
  for (size_t i = 0; i < a.radiance.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c)
      most = std::max(most, static_cast<double>(std::abs(a.radiance.pixels[i][c] - b.radiance.pixels[i][c])));
  return most;
}

}  // namespace

TEST_CASE("An edited model is drawn as the file in which it is so", "[gl][edits]") {
  const struct {
    const char* edit;
    void (*bake)(nlohmann::json& gltf);
  } rows[] = {
      {"/materials/0/roughnessFactor=0.2",
       [](nlohmann::json& gltf) { gltf["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"] = 0.2; }},
      {"/materials/*/metallicFactor=1",
       [](nlohmann::json& gltf) {
         for (nlohmann::json& m : gltf["materials"]) m["pbrMetallicRoughness"]["metallicFactor"] = 1;
       }},
      {"/materials/0/clearcoatFactor=1",
       [](nlohmann::json& gltf) {
         gltf["materials"][0]["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] = 1;
       }},
      {"/materials/0/transmissionFactor=0.8",
       [](nlohmann::json& gltf) {
         gltf["materials"][0]["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 0.8;
       }},
      {"/materials/0/alphaMode=blend;/materials/0/baseColorFactor=0.8,0.5,0.2,0.5",
       [](nlohmann::json& gltf) {
         gltf["materials"][0]["alphaMode"] = "BLEND";
         gltf["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {0.8, 0.5, 0.2, 0.5};
       }},
      {"/nodes/wall/translation=0.2,0,-0.5",
       [](nlohmann::json& gltf) {
         gltf["nodes"][1]["translation"] = {0.2, 0, -0.5};
       }},
      {"/nodes/ball/visible=false", [](nlohmann::json& gltf) { gltf["scenes"][0]["nodes"] = {1}; }},
  };
  Studio studio;
  const io::LoadedModel plain = loadBuilt(ballAndWall());
  const frame::Picture unchanged = studio.render(plain, settingsOf());
  for (const auto& row : rows) {
    INFO(row.edit);
    frame::PictureSettings settings = settingsOf();
    settings.placement.arrangement.edits = *scene::parseEdits(row.edit);
    const frame::Picture edited = studio.render(plain, settings);
    GltfBuilder baked = ballAndWall();
    row.bake(baked.json);
    const frame::Picture wanted = studio.render(loadBuilt(baked), settingsOf());
    CHECK(largestDifference(edited, wanted) == 0);
    CHECK(largestDifference(edited, unchanged) > 0.01);
  }
}

TEST_CASE("One material's further layers are drawn as a file's", "[gl][edits]") {
  Studio studio;
  frame::PictureSettings settings = settingsOf();
  settings.look.material.on = true;
  settings.look.material.edits =
      *scene::parseEdits("clearcoatFactor=1;sheenColorFactor=0,0,1;sheenRoughnessFactor=0.4");
  GltfBuilder baked = ballAndWall();
  for (nlohmann::json& m : baked.json["materials"]) {
    m = material({0.8, 0.8, 0.8, 1}, 0, 0.4);
    m["extensions"]["KHR_materials_clearcoat"]["clearcoatFactor"] = 1;
    m["extensions"]["KHR_materials_sheen"] = {{"sheenColorFactor", {0, 0, 1}}, {"sheenRoughnessFactor", 0.4}};
  }
  const frame::Picture edited = studio.render(loadBuilt(ballAndWall()), settings);
  CHECK(largestDifference(edited, studio.render(loadBuilt(baked), settingsOf())) == 0);
}

TEST_CASE("A model is turned, scaled and moved as a node above it would", "[gl][edits]") {
  Studio studio;
  frame::PictureSettings settings = settingsOf();
  frame::Arrangement& arrangement = settings.placement.arrangement;
  arrangement.up = frame::UpAxis::z;
  arrangement.rotationDeg = {0, 40, 10};
  arrangement.position = {0.1, 0.2, 0.3};
  arrangement.scale = 0.7;
  GltfBuilder baked = ballAndWall();
  const glm::dmat4 world = frame::worldFromModel(arrangement);
  nlohmann::json matrix = nlohmann::json::array();
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) matrix.push_back(world[c][r]);
  const int root = baked.append("nodes", {{"matrix", matrix}, {"children", {0, 1}}});
  baked.json["scenes"][0]["nodes"] = {root};
  const frame::Picture got = studio.render(loadBuilt(ballAndWall()), settings);
  CHECK(largestDifference(got, studio.render(loadBuilt(baked), settingsOf())) < 1e-5);
  CHECK(largestDifference(got, studio.render(loadBuilt(ballAndWall()), settingsOf())) > 0.01);
}

TEST_CASE("The axis that is up, and the order of turns", "[edits]") {
  const auto moved = [](const frame::Arrangement& of, const glm::dvec3& p) {
    return glm::dvec3(frame::worldFromModel(of) * glm::dvec4(p, 1));
  };
  frame::Arrangement z, x, turned;
  z.up = frame::UpAxis::z, x.up = frame::UpAxis::x;
  CHECK(glm::distance(moved(z, {1, 2, 3}), glm::dvec3(1, 3, -2)) < 1e-12);
  CHECK(glm::distance(moved(x, {1, 2, 3}), glm::dvec3(-2, 1, 3)) < 1e-12);
  // About X first: Y goes to Z, which then goes to X about Y.
  turned.rotationDeg = {90, 90, 0};
  turned.scale = 2, turned.position = {10, 0, 0};
  CHECK(glm::distance(moved(turned, {0, 1, 0}), glm::dvec3(12, 0, 0)) < 1e-12);
}

TEST_CASE("A part that is shown alone is framed and drawn alone", "[gl][edits]") {
  Studio studio;
  frame::PictureSettings settings = settingsOf();
  settings.placement.arrangement.only = {"ball"};
  GltfBuilder baked = ballAndWall();
  baked.json["scenes"][0]["nodes"] = {0};
  CHECK(largestDifference(studio.render(loadBuilt(ballAndWall()), settings),
                          studio.render(loadBuilt(baked), settingsOf())) == 0);
}
