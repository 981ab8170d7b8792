// EXT_lights_image_based: directions, RGBD, what the file's coefficients say, and when it is chosen.

#include "io/gltf_environment.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "frame/choose.hpp"
#include "frame/settings.hpp"
#include "io/sources.hpp"
#include "support/gltf_load.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using namespace facet::test;

namespace {

using Bytes = std::vector<uint8_t>;
constexpr int size = 8;

Bytes filled(uint8_t r, uint8_t g, uint8_t b) {
  Bytes data;
  for (int i = 0; i < size * size; ++i) data.insert(data.end(), {r, g, b});
  return data;
}

// Faces +X -X +Y -Y +Z -Z.
GltfBuilder withFaces(const std::vector<Bytes>& faces, int channels = 3) {
  GltfBuilder b = triangle();
  nlohmann::json level = nlohmann::json::array();
  for (const Bytes& face : faces)
    level.push_back(b.append("images", {{"uri", dataUri(pngBytes(size, size, channels, 8, face), "image/png")}}));
  const std::vector<std::vector<double>> coefficients(9, {0, 0, 0});
  b.json["extensions"]["EXT_lights_image_based"]["lights"] = {{{"name", "hall"},
                                                               {"specularImages", {level}},
                                                               {"specularImageSize", size},
                                                               {"irradianceCoefficients", coefficients}}};
  b.json["extensionsUsed"] = {"EXT_lights_image_based"};
  b.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 0;
  return b;
}

nlohmann::json& lightOf(GltfBuilder& b) { return b.json["extensions"]["EXT_lights_image_based"]["lights"][0]; }

std::vector<Bytes> colours() {
  return {filled(255, 0, 0),   filled(0, 255, 0),   filled(0, 0, 255),
          filled(255, 255, 0), filled(0, 255, 255), filled(255, 0, 255)};
}

struct Read {
  Result<scene::Environment> environment;
  Notes notes;

  glm::vec3 towards(glm::dvec3 d) const {
    d = glm::normalize(d);
    const double u = std::atan2(d.z, d.x) / (2 * M_PI) + 0.5, v = std::asin(d.y) / M_PI + 0.5;
    const int column = std::min(int(u * environment->width), environment->width - 1);
    const int row = std::min(int((1 - v) * environment->height), environment->height - 1);
    return environment->radiance[size_t(row * environment->width + column)];
  }
};

Read read(const GltfBuilder& b, const std::string& index = "") {
  const TemporaryFolder folder;
  Read out{tl::unexpected(Error{}), {}};
  out.environment = io::loadGltfEnvironment(folder.write("m.glb", b.glb()), index, out.notes);
  return out;
}

std::string problem(const Read& read) { return read.environment ? "read" : read.environment.error().problem; }

}  // namespace

TEST_CASE("An environment of a glTF file: its faces lie where they should", "[io][environment]") {
  const Read map = read(withFaces(colours()));
  REQUIRE(map.environment);
  CHECK(map.environment->name == "hall");
  CHECK(map.environment->height == 2 * size);
  CHECK(map.notes.empty());
  CHECK(map.towards({1, 0.1, 0.1}) == glm::vec3(1, 0, 0));
  CHECK(map.towards({-1, 0.1, 0.1}) == glm::vec3(0, 1, 0));
  CHECK(map.towards({0.1, 1, 0.1}) == glm::vec3(0, 0, 1));
  CHECK(map.towards({0.1, -1, 0.1}) == glm::vec3(1, 1, 0));
  CHECK(map.towards({0.1, 0.1, 1}) == glm::vec3(0, 1, 1));
  CHECK(map.towards({0.1, 0.1, -1}) == glm::vec3(1, 0, 1));
}

TEST_CASE("An environment of a glTF file: a face is upright as it is seen from within", "[io][environment]") {
  std::vector<Bytes> faces(6, filled(0, 0, 0));
  for (int row = 0; row < size / 2; ++row)  // the upper left quarter
    for (int column = 0; column < size / 2; ++column) faces[4][size_t(3 * (row * size + column))] = 255;
  const Read map = read(withFaces(faces));
  REQUIRE(map.environment);
  // Who looks along +Z with +Y up has +X at the left.
  CHECK(map.towards({0.5, 0.5, 1}).r == 1);
  CHECK(map.towards({-0.5, 0.5, 1}).r == 0);
  CHECK(map.towards({0.5, -0.5, 1}).r == 0);
}

TEST_CASE("An environment of a glTF file: turned, brighter, packed as RGBD", "[io][environment]") {
  GltfBuilder b = withFaces(colours());
  lightOf(b)["rotation"] = {0, std::sqrt(0.5), 0, std::sqrt(0.5)};  // +Z to +X
  lightOf(b)["intensity"] = 3;
  CHECK(read(b).towards({1, 0.1, 0.1}) == glm::vec3(0, 3, 3));
  for (const double huge : {1e200, 1e-200}) {  // whose square is no number, or none
    lightOf(b)["rotation"] = {0, huge, 0, huge};
    const Read turned = read(b);
    CHECK(turned.notes.empty());
    CHECK(turned.towards({1, 0.1, 0.1}) == glm::vec3(0, 3, 3));
  }

  Bytes rgbd;
  for (int i = 0; i < size * size; ++i) rgbd.insert(rgbd.end(), {255, 0, 0, 51});
  CHECK(read(withFaces(std::vector<Bytes>(6, rgbd), 4)).towards({1, 0, 0}).r == Approx(5));
}

TEST_CASE("An environment of a glTF file: its coefficients tell mirrored images", "[io][environment]") {
  std::vector<Bytes> faces(6, filled(0, 0, 0));
  faces[0] = filled(255, 255, 255);
  GltfBuilder b = withFaces(faces);
  lightOf(b)["irradianceCoefficients"][3] = {1, 1, 1};  // light from +X, as the images have it
  CHECK(read(b).towards({1, 0, 0}).r == 1);
  CHECK(read(b).notes.empty());
  lightOf(b)["irradianceCoefficients"][3] = {-1, -1, -1};
  const Read mirrored = read(b);
  CHECK(mirrored.towards({1, 0, 0}).r == 0);
  CHECK(mirrored.towards({-1, 0, 0}).r == 1);
  REQUIRE(mirrored.notes.size() == 1);
  CHECK_THAT(mirrored.notes[0].text, Catch::Contains("mirrored"));
}

TEST_CASE("An environment of a glTF file: what is wrong", "[io][environment]") {
  GltfBuilder b = withFaces(colours());
  CHECK(problem(read(b, "1")) == "environment 1 does not exist; there are 1");
  CHECK(problem(read(b, "x")) == "an environment of it is called by its number");
  CHECK(problem(read(triangle())) == "environment 0 does not exist; there are 0");
  lightOf(b)["specularImages"] = {{0, 1, 2}};
  CHECK(problem(read(b)) == "is no list of six images");
  lightOf(b)["specularImages"] = {{0, 1, 2, 3, 4, 9}};
  CHECK(problem(read(b)) == "image 9 does not exist; there are 6");
  std::vector<Bytes> faces = colours();
  b = withFaces(faces);
  b.json["images"][5]["uri"] = dataUri(pngBytes(1, 1, 3, 8, Bytes(3)), "image/png");
  const auto instead = [&] {
    const Read map = read(b);
    REQUIRE(map.environment);
    CHECK(map.environment->name != "hall");
    return map.notes.back().text;
  };
  CHECK(instead() == "is 1 x 1, not a square as large as the first: builtin:studio takes the environment's place");
  b.json["images"][5]["uri"] = "data:,x";
  CHECK(instead() == "the image cannot be read: builtin:studio takes the environment's place");
  b.json["scenes"][0]["extensions"]["EXT_lights_image_based"]["light"] = 3;
  const auto model = test::loaded(b);
  CHECK(model.model.scenes[0].imageLight == -1);
  CHECK(
      notes(model) ==
      "! /scenes/0/extensions/EXT_lights_image_based/light: environment 3 does not exist; there are 1: another one is "
      "shown\n");
}

TEST_CASE("An environment of a glTF file: an extension that holds no lights has none", "[io][environment]") {
  for (const nlohmann::json& value : {nlohmann::json::array(), nlohmann::json::array({1}), nlohmann::json("x"),
                                      nlohmann::json(), nlohmann::json::object({{"lights", 3}})}) {
    GltfBuilder b = withFaces(colours());
    b.json["extensions"]["EXT_lights_image_based"] = value;
    INFO(value);
    CHECK(problem(read(b)) == "environment 0 does not exist; there are 0");
    const TemporaryFolder folder;
    CHECK(io::loadGltf(folder.write("m.glb", b.glb())));
  }
}

TEST_CASE("An environment of a glTF file is shown unless another one is named", "[io][environment]") {
  const TemporaryFolder folder;
  GltfBuilder b = withFaces(colours());
  attributes(b)["NORMAL"] = b.add(std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1}, floatType, "VEC3");
  const std::string file = folder.write("m.glb", b.glb()).string();
  const auto loaded = io::loadModel(file);
  REQUIRE(loaded);
  CHECK(notes(*loaded) == "");
  CHECK(loaded->model.scenes[0].imageLight == 0);
  frame::PictureSettings settings;
  const std::string source = frame::chooseEnvironment(settings, file, loaded->model, 0);
  CHECK(source == file + "#0");
  Notes said;
  const auto environment = io::loadEnvironmentSource(source, said);
  REQUIRE(environment);
  CHECK(environment->name == "hall");
  settings.sources.environment = "builtin:sky";
  CHECK(frame::chooseEnvironment(settings, file, loaded->model, 0) == "builtin:sky");
  b.json["scenes"][0].erase("extensions");
  CHECK(frame::chooseEnvironment({}, file, test::loaded(b).model, 0) == "builtin:studio");
}
