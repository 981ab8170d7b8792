#include "scene/builtin_scenes.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "base/angle.hpp"
#include "scene/builtin_environments.hpp"
#include "scene/shapes.hpp"

using facet::pi;
using namespace facet::scene;

namespace {

uint32_t word(const std::vector<uint8_t>& bytes, size_t at) {
  uint32_t value = 0;
  REQUIRE(at + 4 <= bytes.size());
  std::memcpy(&value, bytes.data() + at, 4);
  return value;
}

// Checks the container and returns the JSON.
nlohmann::json parse(const std::vector<uint8_t>& bytes) {
  CHECK(word(bytes, 0) == 0x46546C67);
  CHECK(word(bytes, 4) == 2);
  CHECK(word(bytes, 8) == bytes.size());
  const size_t length = word(bytes, 12);
  CHECK(length % 4 == 0);
  CHECK(word(bytes, 16) == 0x4E4F534A);
  CHECK(word(bytes, 24 + length) == 0x004E4942);
  const auto json = nlohmann::json::parse(bytes.begin() + 20, bytes.begin() + 20 + long(length));
  CHECK(json["buffers"][0]["byteLength"] == word(bytes, 20 + length));
  CHECK(28 + length + word(bytes, 20 + length) == bytes.size());
  return json;
}

// Every index in range, every accessor inside its view, every view inside the buffer.
void checkReferences(const nlohmann::json& gltf) {
  for (const auto& view : gltf["bufferViews"]) {
    CHECK(view["byteOffset"].get<size_t>() % 4 == 0);
    CHECK(view["byteOffset"].get<size_t>() + view["byteLength"].get<size_t>() <=
          gltf["buffers"][0]["byteLength"].get<size_t>());
  }
  const std::map<std::string, size_t> components = {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}};
  for (const auto& accessor : gltf["accessors"]) {
    const size_t size = accessor["componentType"] == 5123 ? 2 : 4;
    const auto& view = gltf["bufferViews"].at(accessor["bufferView"].get<size_t>());
    CHECK(accessor["count"].get<size_t>() * components.at(accessor["type"]) * size == view["byteLength"]);
  }
  for (const auto& mesh : gltf["meshes"])
    for (const auto& primitive : mesh["primitives"]) {
      CHECK(primitive["material"].get<size_t>() < gltf["materials"].size());
      const auto vertices = gltf["accessors"].at(primitive["attributes"]["POSITION"].get<size_t>())["count"];
      for (const auto& attribute : primitive["attributes"])
        CHECK(gltf["accessors"].at(attribute.get<size_t>())["count"] == vertices);
    }
  CHECK(gltf["scenes"][0]["nodes"].size() == gltf["nodes"].size());
}

// Smooth normals are those of the surface, triangles wind counter-clockwise around them, none is empty.
void checkShape(const Shape& shape, double largestAngle) {
  CHECK(shape.normals.size() == shape.positions.size());
  CHECK(shape.texCoords.size() == shape.positions.size());
  REQUIRE(shape.indices.size() % 3 == 0);
  double worst = 1;
  for (size_t i = 0; i < shape.indices.size(); i += 3) {
    const auto at = [&](size_t k) { return glm::dvec3(shape.positions.at(shape.indices[i + k])); };
    const glm::dvec3 n = glm::cross(at(1) - at(0), at(2) - at(0));
    REQUIRE(glm::length(n) > 1e-9);
    for (size_t k = 0; k < 3; ++k)
      worst = std::min(worst, glm::dot(glm::normalize(n), glm::dvec3(shape.normals[shape.indices[i + k]])));
  }
  CHECK(std::acos(worst) * 180 / pi < largestAngle);
  for (const glm::vec3& n : shape.normals) REQUIRE(glm::length(n) == Approx(1));
}

}  // namespace

TEST_CASE("Shapes: exact normals, outside is counter-clockwise, no empty triangle") {
  const Shape sphere = sphereShape(32, 64);
  checkShape(sphere, 6);
  CHECK(sphere.positions.size() == 33 * 65);
  CHECK(sphere.indices.size() == 3 * 64 * (2 * 32 - 2));
  for (size_t i = 0; i < sphere.positions.size(); ++i) REQUIRE(sphere.positions[i] == sphere.normals[i]);
  // Volume of the polyhedron by the divergence theorem: a little below 4/3 pi.
  double volume = 0;
  for (size_t i = 0; i < sphere.indices.size(); i += 3)
    volume += glm::dot(glm::dvec3(sphere.positions[sphere.indices[i]]),
                       glm::cross(glm::dvec3(sphere.positions[sphere.indices[i + 1]]),
                                  glm::dvec3(sphere.positions[sphere.indices[i + 2]]))) /
              6;
  CHECK(volume == Approx(4.0 / 3 * pi).epsilon(0.005));
  CHECK(volume < 4.0 / 3 * pi);

  checkShape(torusKnotShape(0.29, 420, 48), 8);
  const Shape disc = discShape(2, 0.1, 20, 64);
  checkShape(disc, 8);
  for (const glm::vec3& p : disc.positions) REQUIRE(std::hypot(p.x, p.z) < 2.0001f);
}

TEST_CASE("builtin:spheres is a 7 x 7 chart under four lights") {
  const nlohmann::json gltf = parse(builtinScene("builtin:spheres").value());
  checkReferences(gltf);
  CHECK(gltf["materials"].size() == 49);
  CHECK(gltf["nodes"].size() == 53);
  CHECK(gltf["extensions"]["KHR_lights_punctual"]["lights"].size() == 4);
  CHECK(gltf["extensionsUsed"] == nlohmann::json({"KHR_lights_punctual"}));
  std::set<int> positions;
  for (const auto& mesh : gltf["meshes"]) positions.insert(mesh["primitives"][0]["attributes"]["POSITION"].get<int>());
  CHECK(positions.size() == 1);  // one sphere for all

  // Roughness grows with x, metallic with y.
  for (const auto& node : gltf["nodes"]) {
    if (!node.contains("mesh")) continue;
    const auto& mesh = gltf["meshes"][node["mesh"].get<size_t>()];
    const auto& pbr = gltf["materials"][mesh["primitives"][0]["material"].get<size_t>()]["pbrMetallicRoughness"];
    CHECK(pbr["roughnessFactor"].get<double>() == Approx((node["translation"][0].get<double>() + 3) / 6));
    CHECK(pbr["metallicFactor"].get<double>() == Approx((node["translation"][1].get<double>() + 3) / 6));
  }
}

TEST_CASE("builtin:furnace is white, without lights") {
  const nlohmann::json gltf = parse(builtinScene("furnace").value());
  checkReferences(gltf);
  CHECK(gltf["nodes"].size() == 22);
  CHECK_FALSE(gltf.contains("extensionsUsed"));
  int metals = 0;
  for (const auto& material : gltf["materials"]) {
    CHECK(material["pbrMetallicRoughness"]["baseColorFactor"] == nlohmann::json({1.0, 1.0, 1.0, 1.0}));
    metals += material["pbrMetallicRoughness"]["metallicFactor"] == 1.0;
  }
  CHECK(metals == 11);
  CHECK(findBuiltinScene("furnace")->environment == "builtin:white");
}

TEST_CASE("builtin:poster: nothing below the ground, occlusion in the ground's colours") {
  const std::vector<uint8_t> bytes = builtinScene("poster").value();
  const nlohmann::json gltf = parse(bytes);
  checkReferences(gltf);
  CHECK(gltf["nodes"].size() == 11);
  const auto& ground = gltf["meshes"].back()["primitives"][0];
  const auto& accessor = gltf["accessors"][ground["attributes"]["COLOR_0"].get<size_t>()];
  const size_t start =
      28 + word(bytes, 12) + gltf["bufferViews"][accessor["bufferView"].get<size_t>()]["byteOffset"].get<size_t>();
  float darkest = 1, brightest = 0;
  for (size_t i = 0; i < accessor["count"].get<size_t>(); ++i) {
    float r = 0;
    std::memcpy(&r, bytes.data() + start + 16 * i, 4);
    darkest = std::min(darkest, r), brightest = std::max(brightest, r);
  }
  CHECK(darkest >= 0);
  CHECK(darkest < 0.05f);  // where a ball touches
  CHECK(brightest > 0.9f);
  CHECK(brightest <= 1);
}

TEST_CASE("builtin:crowd and builtin:palette are as large as they say") {
  const auto crowd = parse(builtinScene("crowd").value());
  CHECK(crowd["meshes"].size() == 1);
  std::set<int> reached;
  std::set<std::array<double, 3>> places;
  for (const int root : crowd["scenes"][0]["nodes"]) {
    const auto at = crowd["nodes"][size_t(root)]["translation"].get<std::array<double, 3>>();
    for (const int child : crowd["nodes"][size_t(root)]["children"]) {
      reached.insert(child);
      const auto offset = crowd["nodes"][size_t(child)]["translation"].get<std::array<double, 3>>();
      places.insert({at[0] + offset[0], at[1] + offset[1], at[2] + offset[2]});
    }
  }
  CHECK(reached.size() == 100'000);
  CHECK(places.size() == 100'000);  // nowhere two at the same place
  const auto palette = parse(builtinScene("palette").value());
  CHECK(palette["materials"].size() == 1000);
  CHECK(palette["meshes"].size() == 1000);
  std::set<std::string> colors;
  for (const auto& material : palette["materials"])
    colors.insert(material["pbrMetallicRoughness"]["baseColorFactor"].dump());
  CHECK(colors.size() == 1000);
}

TEST_CASE("builtin:marbles: 100 draws, 260,000 triangles, four textures each") {
  const auto gltf = parse(builtinScene("marbles").value());
  CHECK(gltf["meshes"].size() == 100);
  CHECK(gltf["materials"].size() == 100);
  CHECK(gltf["images"].size() == 32);
  std::set<std::string> sets;
  for (const auto& material : gltf["materials"]) {
    const auto& lobes = material["pbrMetallicRoughness"];
    const std::set<int> textures = {lobes["baseColorTexture"]["index"], lobes["metallicRoughnessTexture"]["index"],
                                    material["normalTexture"]["index"], material["emissiveTexture"]["index"]};
    CHECK(textures.size() == 4);
    sets.insert(nlohmann::json(textures).dump());
  }
  CHECK(sets.size() == 8);
  const auto& indices = gltf["accessors"][gltf["meshes"][0]["primitives"][0]["indices"].get<size_t>()];
  CHECK(indices["count"] == 3 * 2600);
  // The fifth lies within the fourth.
  const auto &shell = gltf["nodes"][3], &core = gltf["nodes"][4];
  CHECK(shell["translation"] == core["translation"]);
  CHECK(core["scale"][1].get<double>() == Approx(0.7 * shell["scale"][1].get<double>()));
}

TEST_CASE("Built-in scenes are listed with an environment that exists and a camera, unknown names are refused") {
  for (const BuiltinScene& scene : builtinScenes()) {
    CHECK(builtinScene(scene.name).has_value());
    CHECK((scene.environment == "none" || builtinEnvironment(scene.environment).has_value()));
    CHECK(scene.camera.radius > 0);
    CHECK_FALSE(scene.description.empty());
    CHECK(builtinScene(scene.name).value() == builtinScene(scene.name).value());  // the same bytes each time
  }
  CHECK(findBuiltinScene("builtin:poster") == findBuiltinScene("poster"));
  CHECK(findBuiltinScene("nonsense") == nullptr);
  const auto unknown = builtinScene("builtin:cube");
  REQUIRE_FALSE(unknown);
  CHECK(facet::describe(unknown.error()).find("choose one of poster, spheres, tutorial, furnace") != std::string::npos);
}

TEST_CASE("builtin:ndf and builtin:metals name their models") {
  const nlohmann::json ndf = parse(builtinScene("ndf").value());
  CHECK(ndf["materials"].size() == 18);
  CHECK(ndf["nodes"].size() == 19);
  const auto microfacets = [&](size_t material) {
    return ndf["materials"][material]["extensions"]["FACET_materials_models"]["microfacets"].get<std::string>();
  };
  CHECK(microfacets(0) == "ggx");
  CHECK(microfacets(6) == "beckmann");
  CHECK(microfacets(17) == "blinn");
  CHECK(ndf["materials"][17]["pbrMetallicRoughness"]["roughnessFactor"] == Approx(1));
  CHECK(ndf["extensionsUsed"] == nlohmann::json({"FACET_materials_models", "KHR_lights_punctual"}));
  const nlohmann::json metals = parse(builtinScene("metals").value());
  CHECK(metals["materials"].size() == 12);
  CHECK(metals["materials"][0]["extensions"]["FACET_materials_models"]["conductor"] == "gold");
}
