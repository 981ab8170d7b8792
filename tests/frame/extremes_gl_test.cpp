#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <iostream>

#include "support/picture.hpp"

// Scenes of extreme size, place and transform.

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material;
using test::GltfBuilder;

namespace {

// Pixels covered in one picture only, and the largest difference over those covered in both.
struct Difference {
  size_t covered = 0, coverageDiffers = 0;
  float largest = 0;
};
Difference compare(const frame::Picture& a, const frame::Picture& b) {
  REQUIRE(a.radiance.pixels.size() == b.radiance.pixels.size());
  Difference d;
  for (size_t i = 0; i < a.radiance.pixels.size(); ++i) {
    const glm::vec4 &p = a.radiance.pixels[i], &q = b.radiance.pixels[i];
    if (p.w != q.w) {
      ++d.coverageDiffers;
    } else if (p.w > 0) {
      ++d.covered;
      const glm::vec4 e = glm::abs(p - q);
      d.largest = std::max({d.largest, e.x, e.y, e.z});
    }
  }
  return d;
}

// A glossy sphere and a quad beside it under the studio and four lights.
io::LoadedModel still(const json& root, double geometryScale = 1) {
  GltfBuilder builder = emptyScene();
  const float s = static_cast<float>(geometryScale);
  const int gold = builder.append("materials", material({1, 0.7, 0.3, 1}, 1, 0.3));
  const int matt = builder.append("materials", material({0.3, 0.5, 0.8, 1}, 0, 0.6));
  const int sphere = test::addMeshNode(builder, test::addSphere(builder, geometryScale), gold);
  const int quad =
      test::addMeshNode(builder, test::addQuad(builder, glm::vec2(-2, -1) * s, glm::vec2(-1.2f, 1) * s), matt);
  json parent = root;
  parent["children"] = {sphere, quad};
  builder.json["scenes"][0]["nodes"] = {builder.append("nodes", parent)};
  return test::loadBuilt(builder);
}

PictureSettings stillSettings() {
  PictureSettings settings = test::bareSettings(64, 64);
  settings.sources.environment = "builtin:studio";
  settings.look.lights = frame::Lights::demo;
  return settings;
}

}  // namespace

TEST_CASE("A scene far away or of extreme size gives the same picture") {
  test::Studio studio;
  const frame::Picture reference = studio.render(still(json::object()), stillSettings());
  CHECK(reference.statistics.nonFinitePixels == 0);
  struct Row {
    const char* name;
    json root;
    double geometryScale;
  };
  const json small = {{"scale", {1e-6, 1e-6, 1e-6}}}, large = {{"scale", {1e6, 1e6, 1e6}}};
  for (const Row& row : {Row{"1e7 m from the origin", at(1e7, 2e7, -1e7), 1}, Row{"a micrometre", small, 1},
                         Row{"a thousand kilometres", large, 1}, Row{"a micrometre in the file", json::object(), 1e-6},
                         Row{"1e6 in the file, scaled back", small, 1e6}}) {
    const frame::Picture picture = studio.render(still(row.root, row.geometryScale), stillSettings());
    const Difference d = compare(reference, picture);
    INFO(row.name << ": largest difference " << d.largest << ", coverage differs in " << d.coverageDiffers);
    std::cout << row.name << ": largest difference " << d.largest << ", coverage differs in " << d.coverageDiffers
              << " of " << d.covered << " pixels\n";
    CHECK(picture.statistics.nonFinitePixels == 0);
    CHECK(d.covered > 800);
    CHECK(d.coverageDiffers <= 4);
    CHECK(d.largest < 0.03f);  // of radiance up to 10: four units of the last place of a half float
  }
}

TEST_CASE("Mirrored nodes keep their outside") {
  GltfBuilder plain = emptyScene(), mirrored = emptyScene();
  for (GltfBuilder* builder : {&plain, &mirrored}) {
    const int gold = builder->append("materials", material({1, 0.7, 0.3, 1}, 1, 0.3));
    const json scale = {{"scale", {builder == &mirrored ? -1 : 1, 1, 1}}};
    test::addMeshNode(*builder, test::addSphere(*builder, 1), gold, scale);
  }
  test::Studio studio;
  const Difference d = compare(studio.render(test::loadBuilt(plain), stillSettings()),
                               studio.render(test::loadBuilt(mirrored), stillSettings()));
  INFO("largest difference " << d.largest << ", coverage differs in " << d.coverageDiffers);
  CHECK(d.covered > 800);
  CHECK(d.coverageDiffers <= 4);
  CHECK(d.largest < 0.03f);  // of radiance up to 10: four units of the last place of a half float
}

TEST_CASE("A normal map on a mirrored node bends the way its picture is turned") {
  GltfBuilder builder = emptyScene();
  builder.append(
      "images", {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, std::vector<uint8_t>{204, 166, 217}), "image/png")}});
  builder.append("textures", {{"source", 0}});
  json m = material({1, 1, 1, 1});
  m["normalTexture"] = {{"index", 0}};
  builder.append("materials", m);
  json quad = test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  std::vector<float> tangents;
  for (int i = 0; i < 4; ++i) tangents.insert(tangents.end(), {1, 0, 0, 1});
  quad["attributes"]["TANGENT"] = builder.add(tangents, test::floatType, "VEC4");
  test::addMeshNode(builder, quad, 0, at(-0.5, 0, 0));
  json mirror = at(0.5, 0, 0);
  mirror["scale"] = {-1, 1, 1};
  test::addMeshNode(builder, quad, 0, mirror);
  test::addOrthographicCamera(builder, 1, 0.5);
  PictureSettings settings = test::bareSettings(8, 4);
  settings.viewpoint.camera = "0";
  settings.look.channel = "normal";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  const glm::vec3 n = glm::normalize(glm::vec3(204, 166, 217) / 255.0f * 2.0f - 1.0f);
  checkPixel(test::pixel(picture.radiance, 2, 2), glm::vec4(n * 0.5f + 0.5f, 1));
  checkPixel(test::pixel(picture.radiance, 6, 2), glm::vec4(glm::vec3(-n.x, n.y, n.z) * 0.5f + 0.5f, 1));
}

TEST_CASE("Singular node matrices draw what is left of the shape, and stay finite") {
  struct Row {
    const char* name;
    json root;
    bool visible;
  };
  const Row row =
      GENERATE(values<Row>({{"flat", {{"scale", {1, 1, 0}}}, true},
                            {"a line", {{"scale", {1, 0, 0}}}, false},
                            {"a point", {{"scale", {0, 0, 0}}}, false},
                            {"skewed flat", {{"matrix", {1, 0, 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 1}}}, true},
                            {"nearly flat", {{"scale", {1, 1, 1e-30}}}, true}}));
  INFO(row.name);
  const frame::Picture picture = test::Studio().render(still(row.root), stillSettings());
  CHECK(picture.statistics.nonFinitePixels == 0);
  size_t covered = 0;
  for (const glm::vec4& p : picture.radiance.pixels) covered += p.w > 0;
  if (row.visible)
    CHECK(covered > 300);
  else
    CHECK(covered < 64);
}
