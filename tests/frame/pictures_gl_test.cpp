#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>
#include <iostream>

#include "optics/bsdf.hpp"
#include "optics/color.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material, test::unlit;
using test::GltfBuilder;

namespace {

std::vector<std::string> tableNames(const frame::Picture& picture) {
  std::vector<std::string> names;
  for (const ibl::TableStatistics& table : picture.statistics.tables) names.push_back(table.name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("White furnace: white metal and white dielectric of any roughness cannot be seen") {
  const io::LoadedModel model = test::loadBuiltin("builtin:furnace");
  PictureSettings settings = test::bareSettings(220, 44);
  settings.sources.environment = "builtin:white";
  settings.viewpoint.orbit = frame::Orbit{0, 90, 32.2};  // nearly parallel: 11.2 m wide
  settings.viewpoint.fovYDeg = 4;
  const frame::Picture picture = test::Studio().render(model, settings);
  CHECK(picture.statistics.nonFinitePixels == 0);
  float worst[2] = {0, 0};  // metal above, dielectric below
  size_t covered[2] = {0, 0};
  for (int y = 0; y < 44; ++y)
    for (int x = 0; x < 220; ++x) {
      const glm::vec4& p = test::pixel(picture.radiance, x, y);
      if (p.w < 1) continue;
      ++covered[y < 22 ? 0 : 1];
      for (int i = 0; i < 3; ++i) worst[y < 22 ? 0 : 1] = std::max(worst[y < 22 ? 0 : 1], std::abs(p[i] - 1));
    }
  std::cout << "white furnace: metal off by at most " << worst[0] << ", dielectric " << worst[1] << "\n";
  CHECK(covered[0] > 2000);  // 11 discs of 9 pixels radius
  CHECK(covered[1] > 2000);
  CHECK(worst[0] <= 0.001f);
  CHECK(worst[1] <= 0.001f);
}

TEST_CASE("White furnace: the converging picture keeps the energy too") {
  const io::LoadedModel model = test::loadBuiltin("builtin:furnace");
  PictureSettings settings = test::bareSettings(220, 44);
  settings.sources.environment = "builtin:white";
  settings.viewpoint.orbit = frame::Orbit{0, 90, 32.2};
  settings.viewpoint.fovYDeg = 4;
  settings.quality.samples = 16;
  const frame::Picture picture = test::Studio().render(model, settings);
  float worst = 0;
  double sum = 0;
  size_t covered = 0;
  for (const glm::vec4& p : picture.radiance.pixels)
    if (p.w == 1) ++covered, sum += double(p.x), worst = std::max(worst, std::abs(p.x - 1));
  std::cout << "white furnace, 16 samples: off by at most " << worst << ", on average " << sum / double(covered) - 1
            << "\n";
  CHECK(covered > 4000);
  // 64 samples of the lobe, the same ones in every pixel.
  CHECK(std::abs(sum / double(covered) - 1) < 0.01);
  CHECK(worst <= 0.06f);
}

TEST_CASE("A half-metallic white sphere keeps the furnace's energy too") {
  GltfBuilder builder = emptyScene();
  const int half = builder.append("materials", material({1, 1, 1, 1}, 0.5, 0.7));
  test::addMeshNode(builder, test::addSphere(builder, 1), half);
  PictureSettings settings = test::bareSettings(40, 40);
  settings.sources.environment = "builtin:white";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  float worst = 0;
  for (const glm::vec4& p : picture.radiance.pixels)
    if (p.w == 1) worst = std::max(worst, std::abs(p.x - 1));
  CHECK(test::pixel(picture.radiance, 20, 20).w == 1);
  CHECK(worst <= 0.01f);
}

TEST_CASE("A point light on a plane, against the double-precision surface") {
  GltfBuilder builder = emptyScene();
  const glm::dvec3 color(0.8, 0.5, 0.1);
  const double metallic = 0.5, roughness = 0.4;
  const int mixed = builder.append("materials", material(glm::vec4(glm::vec3(color), 1), metallic, roughness));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), mixed);
  builder.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 7}}};
  const glm::dvec3 light(0.4, -0.3, 0.9);
  json node = at(light.x, light.y, light.z);
  node["extensions"]["KHR_lights_punctual"]["light"] = 0;
  builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", node));
  test::addOrthographicCamera(builder, 1, 1);
  PictureSettings settings = test::bareSettings(16, 16);
  settings.viewpoint.camera = "0";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);

  const optics::Surface surface{color, metallic, roughness};
  const glm::dvec3 N(0, 0, 1);
  const optics::Dfg dfg = optics::dfgOf(surface, 1);
  double worst = 0;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x) {
      const glm::dvec3 towards = light - glm::dvec3((x + 0.5) / 8 - 1, 1 - (y + 0.5) / 8, 0);
      const double distance2 = glm::dot(towards, towards);
      const optics::Reflected r = optics::reflect(surface, dfg, N, N, towards / std::sqrt(distance2));
      const glm::dvec3 expected = (r.specular + r.diffuse) * (7 / distance2);
      const glm::vec4& got = test::pixel(picture.radiance, x, y);
      for (int i = 0; i < 3; ++i) worst = std::max(worst, std::abs(double(got[i]) - expected[i]) / expected[i]);
    }
  std::cout << "point light on a plane: largest relative error " << worst << "\n";
  CHECK(worst < 2e-3);  // half floats and the DFG table
}

TEST_CASE("Alpha modes: opaque ignores alpha, mask cuts, blend mixes from back to front") {
  GltfBuilder builder = emptyScene();
  const auto quad = [&](const json& m, const json& where) {
    test::addMeshNode(builder, test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}), builder.append("materials", m), where);
  };
  const json blend = {{"alphaMode", "BLEND"}}, mask = {{"alphaMode", "MASK"}};
  quad(unlit({0.5, 0.25, 0.125, 0.3}), at(-2, 0, 0));
  quad(unlit({0.5, 0.25, 0.125, 0.4}, mask), at(-1, 0, 0));
  quad(unlit({0.5, 0.25, 0.125, 0.6}, mask), at(0, 0, 0));
  quad(unlit({1, 0, 0, 0.25}, blend), at(1, 0, 1));  // in front, though first in the file
  quad(unlit({0, 1, 0, 0.5}, blend), at(1, 0, 0));
  quad(unlit({0, 0, 1, 0.5}, blend), at(2, 0, 1));
  quad(unlit({1, 1, 0, 1}), at(2, 0, 0));
  quad(unlit({1, 1, 1, 0.9}, blend), at(2, 0, -1));  // hidden
  test::addOrthographicCamera(builder, 2.5, 0.5);
  PictureSettings settings = test::bareSettings(20, 4);
  settings.viewpoint.camera = "0";
  test::Studio studio;
  const frame::Picture picture = studio.render(test::loadBuilt(builder), settings);
  const auto column = [&](int x) { return test::pixel(picture.radiance, 4 * x + 1, 2); };
  checkPixel(column(0), {0.5, 0.25, 0.125, 1});
  checkPixel(column(1), {0, 0, 0, 0});
  checkPixel(column(2), {0.5, 0.25, 0.125, 1});
  checkPixel(column(3), {0.25, 0.375, 0, 0.625});
  checkPixel(column(4), {0.5, 0.5, 0.5, 1});
  CHECK(picture.statistics.frame.passes == Names{"opaque", "blend", "display"});
  // PNG keeps the surface's own colour: straight alpha.
  const auto png = [&](int x, int channel) { return int(picture.display.data[size_t((2 * 20 + x) * 4 + channel)]); };
  CHECK(png(13, 3) == Approx(0.625 * 255).margin(1));
}

TEST_CASE("Back faces show only where the material is double-sided, and then face the viewer") {
  GltfBuilder builder = emptyScene();
  json twoSided = material({1, 1, 1, 1});
  twoSided["doubleSided"] = true;
  const json turned = {{"rotation", {0, 1, 0, 0}}};
  json left = turned, right = turned;
  left["translation"] = {-0.5, 0, 0}, right["translation"] = {0.5, 0, 0};
  test::addMeshNode(builder, test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}),
                    builder.append("materials", material({1, 1, 1, 1})), left);
  test::addMeshNode(builder, test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}), builder.append("materials", twoSided),
                    right);
  test::addOrthographicCamera(builder, 1, 0.5);
  PictureSettings settings = test::bareSettings(8, 4);
  settings.viewpoint.camera = "0";
  settings.look.channel = "normal";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  CHECK(test::pixel(picture.radiance, 1, 2).w == 0);
  checkPixel(test::pixel(picture.radiance, 6, 2), {0.5, 0.5, 1, 1});
}

TEST_CASE("A double-sided back face has the reversed shading normal, bumps included") {
  GltfBuilder builder = emptyScene();
  const std::vector<uint8_t> texel = {218, 128, 218};  // tilted along the tangent
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, texel), "image/png")}});
  builder.append("textures", {{"source", 0}});
  const int uv = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  const int tangent =
      builder.add(std::vector<float>{1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1}, test::floatType, "VEC4");
  json m = material({1, 1, 1, 1});
  m["doubleSided"] = true;
  m["normalTexture"] = {{"index", 0}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = uv;
  quad["attributes"]["TANGENT"] = tangent;
  const bool back = GENERATE(false, true);
  test::addMeshNode(builder, quad, builder.append("materials", m),
                    back ? json{{"rotation", {0, 1, 0, 0}}} : json::object());
  test::addOrthographicCamera(builder, 1, 1);
  PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  settings.look.channel = "normal";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  // The front's normal is (a, 0, a); turned about +Y the surface has (-a, 0, -a) outside, so (a, 0, a) towards the
  // viewer.
  checkPixel(test::pixel(picture.radiance, 2, 2), {218 / 255.0f, 0.5f, 218 / 255.0f, 1}, 6e-3f);
}

TEST_CASE("The sky is drawn where nothing else is, and an empty scene still is a picture") {
  GltfBuilder builder = emptyScene();
  const bool blended = GENERATE(false, true);
  if (blended)
    test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                      builder.append("materials", unlit({1, 0, 0, 0.5}, {{"alphaMode", "BLEND"}})));
  PictureSettings settings = test::bareSettings(8, 8);
  settings.sources.environment = "builtin:white";
  settings.frame.background = frame::Background::environment;
  settings.viewpoint.orbit = frame::Orbit{0, 90, 20.0};
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  checkPixel(test::pixel(picture.radiance, 0, 0), {1, 1, 1, 1});
}

TEST_CASE("A background colour is that colour in the PNG, whatever exposure and tone mapper") {
  GltfBuilder builder = emptyScene();
  PictureSettings settings = test::bareSettings(4, 4);
  settings.frame.background = frame::Background::color;
  settings.frame.backgroundColor = {1, 0.21404114f, 0};  // #ff8000 in linear light
  settings.display.exposureStops = 2;
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  REQUIRE(picture.display.channels == 3);
  CHECK(picture.display.data[0] == 255);
  CHECK(std::abs(picture.display.data[1] - 128) <= 1);
  CHECK(picture.display.data[2] == 0);
  checkPixel(test::pixel(picture.radiance, 1, 1), {1, 0.21404114f, 0, 1});
}

TEST_CASE("Tone mapping end to end: exposure, mapper, sRGB, 8 bits") {
  GltfBuilder builder = emptyScene();
  const glm::dvec3 color(0.2, 0.5, 0.9);
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", unlit(glm::vec4(glm::vec3(color), 1))));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(2, 2);
  settings.viewpoint.camera = "0";
  test::Studio studio;
  for (const auto& [mapper, word, label, note] : optics::toneMappers)
    for (const float stops : {-2.0f, 0.0f, 3.0f}) {
      settings.display.toneMapper = mapper;
      settings.display.exposureStops = stops;
      const frame::Picture picture = studio.render(model, settings);
      const glm::dvec3 expected = optics::encodeSRGB(optics::toneMap(mapper, color * std::exp2(double(stops)))) * 255.0;
      INFO(word << ", " << stops << " stops");
      for (int i = 0; i < 3; ++i) CHECK(std::abs(picture.display.data[size_t(i)] - expected[i]) <= 0.75);
      // The scene-linear picture knows nothing of it.
      checkPixel(picture.radiance.pixels[0], glm::vec4(glm::vec3(color), 1), 5e-4f);
    }
}

TEST_CASE("The same picture twice is the same bytes") {
  const io::LoadedModel model = test::loadBuiltin("builtin:spheres");
  PictureSettings settings;
  settings.frame.width = settings.frame.height = 64;
  const frame::Picture a = test::Studio().render(model, settings), b = test::Studio().render(model, settings);
  CHECK(std::memcmp(a.radiance.pixels.data(), b.radiance.pixels.data(), a.radiance.pixels.size() * sizeof(glm::vec4)) ==
        0);
  CHECK(a.display.data == b.display.data);
  CHECK(a.statistics.nonFinitePixels == 0);
}

// ---- what a scene does not need -------------------------------------------------------------------------------------

TEST_CASE("Frugality: an unlit scene decodes one image, compiles one mesh program and computes nothing") {
  GltfBuilder builder = emptyScene();
  for (int i = 0; i < 3; ++i)
    builder.append(
        "images", {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, std::vector<uint8_t>{255, 128, 0}), "image/png")}});
  for (int i = 0; i < 3; ++i) builder.append("textures", {{"source", i}});
  json m = unlit({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  m["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 1}};
  m["emissiveTexture"] = {{"index", 1}};
  m["emissiveFactor"] = {1, 1, 1};
  builder.append("materials", m);
  json unused = material({1, 1, 1, 1});
  unused["normalTexture"] = {{"index", 2}};
  builder.append("materials", unused);
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>(8, 0.5f), test::floatType, "VEC2");
  test::addMeshNode(builder, quad, 0);
  PictureSettings settings = test::bareSettings(8, 8);
  settings.sources.environment = "";  // none is chosen, for nothing could be lit
  settings.frame.background = frame::Background::environment;
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  const frame::PictureStatistics& s = picture.statistics;
  CHECK(s.imagesDecoded == 1);
  CHECK(s.programsCompiled == 2);  // the mesh's and the display's
  CHECK(s.tables.empty());
  CHECK(s.tableBytes == 0);
  CHECK(s.frame.passes == Names{"opaque", "display"});
  CHECK(s.frame.draws == 1);
  CHECK(test::pixel(picture.radiance, 4, 4).x == 1);
}

TEST_CASE("Frugality: lights alone need the DFG table, an environment all tables, once") {
  GltfBuilder builder = emptyScene();
  builder.append("materials", material({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), 0);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(8, 8);
  settings.look.lights = frame::Lights::demo;
  {
    const frame::Picture picture = test::Studio().render(model, settings);
    CHECK(tableNames(picture) == Names{"DFG"});
    CHECK(picture.statistics.programsCompiled == 3);  // mesh, display, DFG
    CHECK(picture.statistics.imagesDecoded == 0);
    CHECK(picture.statistics.tableBytes == 64 * 64 * 8);
    CHECK(test::pixel(picture.radiance, 4, 4).x > 0.1f);
  }
  settings.look.lights = frame::Lights::scene;
  settings.sources.environment = "builtin:white";
  test::Studio studio;
  const frame::Picture hidden = studio.render(model, settings);
  CHECK(tableNames(hidden) == Names{"DFG", "taps", "environment cube", "irradiance", "LD layers"});
  // mesh, display, DFG, and six to filter the environment
  CHECK(hidden.statistics.programsCompiled == 9);
  CHECK(hidden.statistics.frame.passes == Names{"opaque", "display"});
  // Then the sky: one more program, no table computed anew.
  settings.frame.background = frame::Background::environment;
  settings.quality.samples = 4;
  const frame::Picture seen = studio.render(model, settings);
  CHECK(tableNames(seen) == Names{"background"});
  CHECK(seen.statistics.programsCompiled == 1);
  CHECK(seen.statistics.frame.passes == Names{"opaque", "sky", "resolve", "display"});
  // An environment without strength is none.
  settings.frame.environmentStrength = 0;
  settings.frame.background = frame::Background::transparent;
  const frame::Picture dark = test::Studio().render(model, settings);
  CHECK(dark.statistics.tables.empty());
}

TEST_CASE("Statistics are of all bands of a picture, not of its last") {
  GltfBuilder builder = emptyScene();
  builder.append("materials", test::unlit({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, -0.5}), 0);  // at the bottom: in the first band
  test::addOrthographicCamera(builder, 1, 1);
  PictureSettings settings = test::bareSettings(4096, 160);
  settings.viewpoint.camera = "0";
  const frame::PictureStatistics s = test::Studio().render(test::loadBuilt(builder), settings).statistics;
  REQUIRE(s.bands > 1);
  CHECK(s.frame.draws == 1);
  CHECK(s.frame.triangles == 2);
  CHECK(s.frame.passes == Names{"opaque", "display"});
}

// 0.9, 0.5, 0.2 / pi times the cosine of 30 degrees lie between halves: 0.248047, 0.137817, 0.055115 are the next
// below.
TEST_CASE("Precision: radiance alone is exact to single precision, of one sample and of many", "[gl]") {
  const glm::vec4 radiance(0.248098f, 0.137832f, 0.055133f, 1);
  GltfBuilder builder = emptyScene();
  const int plain = builder.append("materials", unlit(radiance));
  json glass = material({1, 1, 1, 1}, 0, 0);
  glass["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                         {"KHR_materials_ior", {{"ior", 1}}}};
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), plain);
  test::addMeshNode(builder, test::addQuad(builder, {0, -1}, {1, 1}), builder.append("materials", glass), at(0, 0, 1));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  studio.display = false;
  PictureSettings settings = test::bareSettings(8, 8);
  settings.viewpoint.camera = "0";
  for (const int samples : {1, 4, 64}) {
    settings.quality.samples = samples;
    const frame::Picture picture = studio.render(model, settings);
    INFO(samples << " samples");
    for (const int x : {1, 6})  // itself, and through what does not refract
      for (int i = 0; i < 3; ++i)
        CHECK(test::pixel(picture.radiance, x, 4)[i] == Approx(radiance[i]).epsilon(x == 1 ? 1e-6 : 1e-5));
  }
}

TEST_CASE("Points and lines without normals show base colour and emission, whatever lights the scene", "[gl]") {
  GltfBuilder builder = emptyScene();
  builder.append("images",
                 {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, std::vector<uint8_t>{255, 0, 255}), "image/png")}});
  builder.append("textures", {{"source", 0}});
  nlohmann::json m = material({0.25, 0.5, 0.125, 1});
  m["emissiveFactor"] = {0.5, 1, 1};
  m["emissiveTexture"] = {{"index", 0}};
  m["extensions"] = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}};
  nlohmann::json unlitMaterial = m;
  unlitMaterial["extensions"]["KHR_materials_unlit"] = nlohmann::json::object();
  const int glowing = builder.append("materials", m), plain = builder.append("materials", unlitMaterial);
  const auto add = [&](int mode, const std::vector<float>& positions, int material) {
    const std::vector<float> uv(positions.size() / 3 * 2, 0.5f);
    test::addMeshNode(builder,
                      {{"mode", mode},
                       {"attributes",
                        {{"POSITION", builder.add(positions, test::floatType, "VEC3")},
                         {"TEXCOORD_0", builder.add(uv, test::floatType, "VEC2")}}}},
                      material);
  };
  add(1, {-4, 0.5f, 0, 4, 0.5f, 0}, glowing);
  add(0, {-0.5f, -0.5f, 0}, glowing);
  add(1, {-4, 2.5f, 0, 4, 2.5f, 0}, plain);
  test::addOrthographicCamera(builder, 4, 4);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  for (const char* environment : {"none", "builtin:white"})
    for (const int samples : {1, 4, 8}) {
      INFO(environment << ", " << samples << " samples");
      PictureSettings settings = test::bareSettings(8, 8);
      settings.viewpoint.camera = "0";
      settings.sources.environment = environment;
      settings.quality.samples = samples;
      const frame::Picture picture = studio.render(model, settings);
      const auto color = [&](int x, int y) {
        const glm::vec4& p = test::pixel(picture.radiance, x, y);
        REQUIRE(p.w > 0);
        return glm::vec4(glm::vec3(p) / p.w, 1);
      };
      checkPixel(color(2, 3), {2.25f, 0.5f, 4.125f, 1}, 4e-3f);
      checkPixel(color(3, 4), {2.25f, 0.5f, 4.125f, 1}, 4e-3f);
      checkPixel(color(2, 1), {0.25f, 0.5f, 0.125f, 1}, 1e-3f);
    }
}
