#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "base/srgb.hpp"
#include "frame/value_range.hpp"
#include "optics/color.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material, test::unlit;
using test::GltfBuilder;

namespace {

// One texel, other in each of its channels, in an image of its own for each slot.
constexpr uint8_t texel[4] = {204, 153, 102, 51};
double linearTexel(int c) { return texel[c] / 255.0; }
glm::dvec3 colorTexel() {
  return {linearFromSrgb(linearTexel(0)), linearFromSrgb(linearTexel(1)), linearFromSrgb(linearTexel(2))};
}

json texture(GltfBuilder& builder, int texCoord = 0) {
  const std::vector<uint8_t> texels(texel, texel + 4);
  const int image = builder.append("images", {{"uri", test::dataUri(test::pngBytes(1, 1, 4, 8, texels), "image/png")}});
  return {{"index", builder.append("textures", {{"source", image}})}, {"texCoord", texCoord}};
}

// All that a metallic-roughness material can have, each factor another one, each slot with a texture of its own.
json fullMaterial(GltfBuilder& b) {
  auto t = [&, set = 0]() mutable { return texture(b, set++ % 8); };  // sets that none reads are not loaded
  json m = {{"pbrMetallicRoughness",
             {{"baseColorFactor", {0.9, 0.8, 0.7, 0.6}},
              {"baseColorTexture", t()},
              {"metallicFactor", 0.75},
              {"roughnessFactor", 0.625},
              {"metallicRoughnessTexture", t()}}},
            {"normalTexture", t()},
            {"occlusionTexture", t()},
            {"alphaMode", "BLEND"},
            {"emissiveTexture", t()},
            {"emissiveFactor", {0.25, 0.5, 1}}};
  json& x = m["extensions"];
  x["KHR_materials_ior"] = {{"ior", 1.75}};
  x["KHR_materials_specular"] = {{"specularFactor", 0.5},
                                 {"specularTexture", t()},
                                 {"specularColorFactor", {0.5, 0.75, 1}},
                                 {"specularColorTexture", t()}};
  x["KHR_materials_clearcoat"] = {{"clearcoatFactor", 0.875},
                                  {"clearcoatTexture", t()},
                                  {"clearcoatRoughnessFactor", 0.375},
                                  {"clearcoatRoughnessTexture", t()},
                                  {"clearcoatNormalTexture", t()}};
  x["KHR_materials_sheen"] = {{"sheenColorFactor", {1, 0.5, 0.25}},
                              {"sheenColorTexture", t()},
                              {"sheenRoughnessFactor", 0.5},
                              {"sheenRoughnessTexture", t()}};
  x["KHR_materials_anisotropy"] = {
      {"anisotropyStrength", 0.75}, {"anisotropyRotation", 0.5}, {"anisotropyTexture", t()}};
  x["KHR_materials_iridescence"] = {
      {"iridescenceFactor", 0.625},         {"iridescenceTexture", t()},          {"iridescenceIor", 1.375},
      {"iridescenceThicknessMinimum", 200}, {"iridescenceThicknessMaximum", 700}, {"iridescenceThicknessTexture", t()}};
  x["KHR_materials_transmission"] = {{"transmissionFactor", 0.5}, {"transmissionTexture", t()}};
  x["KHR_materials_volume"] = {{"thicknessFactor", 0.25},
                               {"thicknessTexture", t()},
                               {"attenuationColor", {0.125, 0.25, 0.5}},
                               {"attenuationDistance", 3}};
  x["KHR_materials_dispersion"] = {{"dispersion", 0.375}};
  x["KHR_materials_diffuse_transmission"] = {{"diffuseTransmissionFactor", 0.75},
                                             {"diffuseTransmissionTexture", t()},
                                             {"diffuseTransmissionColorFactor", {0.5, 1, 0.25}},
                                             {"diffuseTransmissionColorTexture", t()}};
  x["KHR_materials_diffuse_roughness"] = {{"diffuseRoughnessFactor", 0.875}, {"diffuseRoughnessTexture", t()}};
  return m;
}

// [-1, 1]^2 at z = 0 with normals that lean, tangents along +X whose bitangent is turned round, and eight sets.
json fullQuad(GltfBuilder& b) {
  json quad = test::addQuad(b, {-1, -1}, {1, 1});
  std::vector<float> normals, tangents;
  for (int i = 0; i < 4; ++i)
    normals.insert(normals.end(), {0, 0.6f, 0.8f}), tangents.insert(tangents.end(), {1, 0, 0, -1});
  quad["attributes"]["NORMAL"] = b.add(normals, test::floatType, "VEC3");
  quad["attributes"]["TANGENT"] = b.add(tangents, test::floatType, "VEC4");
  quad["attributes"]["COLOR_0"] =
      b.add(std::vector<float>{.5f, .25f, 1, .5f, .25f, 1, .5f, .25f, 1, .5f, .25f, 1}, test::floatType, "VEC3");
  for (int n = 0; n < 8; ++n) {
    const float u = (static_cast<float>(n) + 0.5f) / 16;
    quad["attributes"]["TEXCOORD_" + std::to_string(n)] =
        b.add(std::vector<float>{u, 0.25f, u, 0.25f, u, 0.25f, u, 0.25f}, test::floatType, "VEC2");
  }
  return quad;
}

struct Scene {
  io::LoadedModel model;
  frame::LoadedScene scene = test::sceneOf(model);
  PictureSettings settings = test::bareSettings(4, 4);
  explicit Scene(GltfBuilder& builder) : model(test::loadBuilt(builder)) { settings.viewpoint.camera = "0"; }
  frame::Picture render(test::Studio& studio, const std::string& channel) {
    settings.look.channel = channel;
    return studio.render(scene, settings);
  }
};

const glm::vec3 checks[] = {glm::vec3(0.35f), glm::vec3(0.05f)};

glm::dvec3 shownAt(const frame::Picture& picture, int x, int y) {
  const auto at = static_cast<size_t>((y * picture.display.width + x) * picture.display.channels);
  return {picture.display.data[at], picture.display.data[at + 1], picture.display.data[at + 2]};
}
void checkShown(const glm::dvec3& got, const glm::dvec3& expected, double margin = 1) {
  INFO(got.x << " " << got.y << " " << got.z << ", expected " << expected.x << " " << expected.y << " " << expected.z);
  CHECK(glm::all(glm::lessThanEqual(glm::abs(got - expected), glm::dvec3(margin))));
}

}  // namespace

TEST_CASE("Channels: each is the number that its factors, texels and attributes make", "[gl]") {
  GltfBuilder builder = emptyScene();
  const json quad = fullQuad(builder), full = fullMaterial(builder);
  const int first = builder.append("materials", material({1, 1, 1, 1}));
  const int index = builder.append("materials", full);
  test::addMeshNode(builder, test::addQuad(builder, {5, 5}, {6, 6}), first);  // out of sight, so that indices are not 0
  const int node = test::addMeshNode(builder, quad, index, {{"translation", {0, 0, 1}}});
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  test::Studio studio;
  studio.display = false;

  const double r = linearTexel(0), g = linearTexel(1), b = linearTexel(2), a = linearTexel(3);
  const glm::dvec3 color = colorTexel(), vertex(0.5, 0.25, 1);
  const glm::dvec3 base = glm::dvec3(0.9, 0.8, 0.7) * vertex * color;
  const double metallic = 0.75 * b, ratio = 0.75 / 2.75;
  const glm::dvec3 f0 = ratio * ratio * glm::dvec3(0.5, 0.75, 1) * color * (0.5 * a);
  // The texel in the frame of the tangent and its turned bitangent.
  const glm::dvec3 N(0, 0.6, 0.8), T(1, 0, 0), B = -glm::cross(N, T);
  const glm::dvec3 bump = glm::normalize((2 * r - 1) * T + (2 * g - 1) * B + (2 * b - 1) * N);
  const glm::dvec2 grain(2 * r - 1, 2 * g - 1);
  const glm::dvec2 turned(grain.x * std::cos(0.5) - grain.y * std::sin(0.5),
                          grain.x * std::sin(0.5) + grain.y * std::cos(0.5));
  const std::map<std::string, glm::dvec3> expected = {
      {"normal", bump},
      {"geometryNormal", N},
      {"faceNormal", {0, 0, 1}},
      {"normalTexture", {r, g, b}},
      {"tangent", T},
      {"bitangent", B},
      {"handedness", glm::dvec3(-1)},
      {"uv", {0.5 / 16, 0.25, 0}},
      {"uv1", {1.5 / 16, 0.25, 0}},
      {"uv2", {2.5 / 16, 0.25, 0}},
      {"uv3", {3.5 / 16, 0.25, 0}},
      {"uv4", {4.5 / 16, 0.25, 0}},
      {"uv5", {5.5 / 16, 0.25, 0}},
      {"uv6", {6.5 / 16, 0.25, 0}},
      {"uv7", {7.5 / 16, 0.25, 0}},
      // Cell (floor(10 u), 2): dark where the sum is odd.
      {"checker", glm::dvec3(0.5 / 16, 0.25, 0.5)},
      {"checker1", glm::dvec3(1.5 / 16, 0.25, 0.5)},
      {"checker2", glm::dvec3(2.5 / 16, 0.25, 0.5) * 0.35},
      {"checker3", glm::dvec3(3.5 / 16, 0.25, 0.5)},
      {"checker4", glm::dvec3(4.5 / 16, 0.25, 0.5)},
      {"checker5", glm::dvec3(5.5 / 16, 0.25, 0.5) * 0.35},
      {"checker6", glm::dvec3(6.5 / 16, 0.25, 0.5)},
      {"checker7", glm::dvec3(7.5 / 16, 0.25, 0.5)},
      {"vertexColor", vertex},
      {"depth", glm::dvec3(9)},
      {"node", glm::dvec3(node)},
      {"material", glm::dvec3(index)},
      {"texelDensity", glm::dvec3(0)},
      {"overdraw", glm::dvec3(1)},
      {"baseColor", base},
      {"alpha", glm::dvec3(0.6 * a)},
      {"metallic", glm::dvec3(metallic)},
      {"roughness", glm::dvec3(0.625 * g)},
      {"f0", glm::mix(f0, base, metallic)},
      {"occlusion", glm::dvec3(r)},
      {"emissive", glm::dvec3(0.25, 0.5, 1) * color},
      {"ior", glm::dvec3(1.75)},
      {"specular", glm::dvec3(0.5 * a)},
      {"specularColor", glm::dvec3(0.5, 0.75, 1) * color},
      {"clearcoat", glm::dvec3(0.875 * r)},
      {"clearcoatRoughness", glm::dvec3(0.375 * g)},
      {"clearcoatNormal", bump},
      {"sheenColor", glm::dvec3(1, 0.5, 0.25) * color},
      {"sheenRoughness", glm::dvec3(0.5 * a)},
      {"anisotropy", glm::dvec3(0.75 * b)},
      {"anisotropyDirection", glm::normalize(turned.x * T + turned.y * B)},
      {"iridescence", glm::dvec3(0.625 * r)},
      {"iridescenceThickness", glm::dvec3(200 + 500 * g)},
      {"iridescenceIor", glm::dvec3(1.375)},
      {"transmission", glm::dvec3(0.5 * r)},
      {"thickness", glm::dvec3(0.25 * g)},
      {"attenuationColor", {0.125, 0.25, 0.5}},
      {"attenuationDistance", glm::dvec3(3)},
      {"dispersion", glm::dvec3(0.375)},
      {"diffuseTransmission", glm::dvec3(0.75 * a)},
      {"diffuseTransmissionColor", glm::dvec3(0.5, 1, 0.25) * color},
      {"diffuseRoughness", glm::dvec3(0.875 * r)},
  };
  for (const Choice<int>& row : shading::channels) {
    const std::string word(row.word);
    if (shading::showsLight(row.value) || word == "mipLevel")
      continue;  // which is no number in texels that are all alike
    INFO(word);
    REQUIRE(expected.count(word) == 1);
    const frame::Picture picture = scene.render(studio, word);
    const glm::dvec3& value = expected.at(word);
    checkPixel(test::pixel(picture.radiance, 1, 2), glm::vec4(glm::vec3(value), 1),
               3e-3f * std::max(1.0f, static_cast<float>(value.x)));
    CHECK(picture.statistics.tables.empty());
  }
}

TEST_CASE("Channels: nothing is decoded or compiled that the chosen one does not show", "[gl]") {
  GltfBuilder builder = emptyScene();
  const json quad = fullQuad(builder);
  test::addMeshNode(builder, quad, builder.append("materials", fullMaterial(builder)));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:white";
  const std::map<std::string, int> images = {{"depth", 0},     {"node", 0},       {"uv7", 0},         {"ior", 0},
                                             {"baseColor", 1}, {"sheenColor", 1}, {"clearcoat", 1},   {"thickness", 1},
                                             {"normal", 1},    {"f0", 4},         {"transmission", 1}};
  for (const auto& [channel, decoded] : images) {
    settings.look.channel = channel;
    const frame::Picture picture = test::Studio().render(model, settings);
    INFO(channel);
    CHECK(picture.statistics.imagesDecoded == decoded);
    CHECK(picture.statistics.tables.empty());
    REQUIRE(picture.statistics.variants.size() == 1);
    const std::string& name = picture.statistics.variants.begin()->first;
    CHECK(name.find("environment") == std::string::npos);
    CHECK(name.find("clearcoat,") == std::string::npos);
  }
}

TEST_CASE("Channels: what is not there shows as checks, whatever the channel's colours are", "[gl]") {
  GltfBuilder builder = emptyScene();
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}),
                    builder.append("materials", material({1, 1, 1, 1})));
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  scene.settings.frame.width = scene.settings.frame.height = 16;
  test::Studio studio;
  const std::set<std::string> there = {"normal",   "geometryNormal", "faceNormal", "depth",    "node",      "material",
                                       "overdraw", "baseColor",      "alpha",      "metallic", "roughness", "f0",
                                       "emissive"};
  for (const Choice<int>& row : shading::channels) {
    const std::string word(row.word);
    if (shading::showsLight(row.value)) continue;
    INFO(word);
    const frame::Picture picture = scene.render(studio, word);
    const bool color = shading::channelKind(row.value) == shading::ChannelKind::color;
    int same = 0;
    for (const int x : {2, 10})
      for (const int y : {2, 10}) {
        glm::dvec3 expected(checks[(x / 8 + (15 - y) / 8) % 2]);
        if (color) expected = optics::encodeSRGB(expected);
        same += glm::length(shownAt(picture, x, y) - 255.0 * expected) < 2 ? 1 : 0;
      }
    CHECK((same == 4) == (there.count(word) == 0));
  }
}

TEST_CASE("Channels: quantities are shown in false colours over what the scene has of them, or over a range", "[gl]") {
  GltfBuilder builder = emptyScene();
  const int plain = builder.append("materials", material({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {0, 1}), plain, at(0, 0, 2));
  test::addMeshNode(builder, test::addQuad(builder, {0, -1}, {0.5, 1}), plain, at(0, 0, 1));
  test::addMeshNode(builder, test::addQuad(builder, {0, 2}, {0.5, 3}), plain, at(0, 0, -2));  // only of the bounds
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  scene.settings.frame.background = frame::Background::environment;
  scene.settings.quality.samples = GENERATE(1, 4, 16);
  test::Studio studio;
  const auto color = [](double share) { return 255.0 * optics::falseColor(share); };
  const frame::Picture usual = scene.render(studio, "depth");
  REQUIRE(usual.statistics.range);
  CHECK(usual.statistics.range->range == frame::ValueRange{8, 12, false});
  CHECK(frame::describe(*usual.statistics.range) == "depth from 8 to 12 m");
  checkShown(shownAt(usual, 0, 1), color(0));
  checkShown(shownAt(usual, 2, 1), color(0.25));
  checkShown(shownAt(usual, 3, 1), glm::dvec3(0));  // nothing there
  scene.settings.display.range = glm::dvec2(0, 10);
  const frame::Picture wished = scene.render(studio, "depth");
  checkShown(shownAt(wished, 0, 1), color(0.8));
  checkShown(shownAt(wished, 2, 1), color(0.9));
  scene.settings.frame.background = frame::Background::color;
  scene.settings.frame.backgroundColor = glm::vec3(1, 0, 0);
  checkShown(shownAt(scene.render(studio, "depth"), 3, 1), {255, 0, 0});
}

TEST_CASE("Light in false colours: its luminance over sixteen stops around white, or over a range", "[gl]") {
  GltfBuilder builder = emptyScene();
  const glm::dvec3 light(0.5, 0.25, 1);
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {0.5, 1}),
                    builder.append("materials", unlit(glm::vec4(glm::vec3(light), 1))));
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  frame::Display& display = scene.settings.display;
  scene.settings.quality.samples = GENERATE(1, 4, 16);
  scene.settings.quality.transport = GENERATE(frame::Transport::direct, frame::Transport::paths);
  display.falseColors = true;
  test::Studio studio;
  const double luminance = 0.2126 * light.r + 0.7152 * light.g + 0.0722 * light.b;
  const auto shown = [&](double from, double to) {
    return 255.0 * optics::falseColor(std::log2(luminance / from) / std::log2(to / from));
  };
  // Also where light is stored in another unit.
  for (const float stops : {0.0f, 3.0f, -12.0f, 20.0f}) {
    display.exposureStops = stops;
    const frame::Picture usual = scene.render(studio, "");
    REQUIRE(usual.statistics.range);
    const double white = std::exp2(-double{stops});
    CHECK(usual.statistics.range->range == frame::ValueRange{white / 1024, 64 * white, true});
    checkShown(shownAt(usual, 1, 1), shown(white / 1024, 64 * white));
    CHECK(usual.display.data[3 * 4 + 3] == 0);  // nothing there
  }
  display.exposureStops = 0;
  CHECK(frame::describe(*scene.render(studio, "").statistics.range) == "radiance from 0.0009766 to 64, logarithmic");
  display.range = glm::dvec2(0.125, 2);
  checkShown(shownAt(scene.render(studio, ""), 1, 1), shown(0.125, 2));
  scene.settings.frame.background = frame::Background::color;
  scene.settings.frame.backgroundColor = glm::vec3(1, 0, 0);
  const frame::Picture over = scene.render(studio, "");
  checkShown(shownAt(over, 3, 1), {255, 0, 0});
  checkShown(shownAt(over, 1, 1), shown(0.125, 2));
  display.falseColors = false;
  CHECK_FALSE(scene.render(studio, "").statistics.range);
}

TEST_CASE("Light that is no number is magenta in false colours, and counted", "[gl]") {
  const shading::ShaderReader whole = shading::shaderReader();
  const auto reader = [&](const std::string& name) {
    auto text = whole(name);
    const std::string line = "vec4 lit = litRadiance(";
    const size_t found = text && name == "passes/mesh.frag.glsl" ? text->find(line) : std::string::npos;
    if (found != std::string::npos)
      text->replace(found, line.size(), "vec4 lit = vec4(uintBitsToFloat(0x7fc00000u) * v.position.x) + litRadiance(");
    return text;
  };
  GltfBuilder builder = emptyScene();
  const int plain = builder.append("materials", material({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {0, 1}), plain);
  test::addMeshNode(builder, test::addQuad(builder, {0, -1}, {1, 1}), builder.append("materials", unlit({1, 1, 1, 1})));
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  scene.settings.quality.samples = GENERATE(1, 4, 16);
  test::Studio studio(reader);
  scene.settings.display.falseColors = true;
  const frame::Picture picture = scene.render(studio, "");
  CHECK(picture.statistics.nonFinitePixels == 8);
  checkShown(shownAt(picture, 0, 1), {255, 0, 255});
  checkShown(shownAt(picture, 3, 1), 255.0 * optics::falseColor(10.0 / 16));
}

TEST_CASE("Channels: texels per metre, and the level that is read of them", "[gl]") {
  GltfBuilder builder = emptyScene();
  const std::vector<uint8_t> texels(64 * 16 * 3, 100);
  const int image =
      builder.append("images", {{"uri", test::dataUri(test::pngBytes(64, 16, 3, 8, texels), "image/png")}});
  json m = material({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", builder.append("textures", {{"source", image}})},
                                                   {"extensions", {{"KHR_texture_transform", {{"scale", {2, 8}}}}}}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m), {{"scale", {0.5, 0.5, 0.5}}});
  test::addOrthographicCamera(builder, 0.5, 0.5);
  Scene scene(builder);
  test::Studio studio;
  // 128 x 128 texels over a square metre, 4 x 4 pixels.
  const frame::Picture density = scene.render(studio, "texelDensity");
  REQUIRE(density.statistics.range);
  CHECK(density.statistics.range->range == frame::ValueRange{16, 16384, true});  // radius 0.71
  checkShown(shownAt(density, 2, 2), 255.0 * optics::falseColor(0.3));
  checkShown(shownAt(scene.render(studio, "mipLevel"), 2, 2), 255.0 * optics::falseColor(7.0 / 12), 2);
  studio.display = false;
  checkPixel(test::pixel(scene.render(studio, "texelDensity").radiance, 2, 2), {128, 128, 128, 1}, 0.01f);
  checkPixel(test::pixel(scene.render(studio, "mipLevel").radiance, 2, 2), {5, 5, 5, 1}, 0.05f);
}

TEST_CASE("Channels: overdraw counts surfaces, masked ones where they are, and those of one side from there", "[gl]") {
  GltfBuilder builder = emptyScene();
  json holes = material({1, 1, 1, 1});
  const std::vector<uint8_t> texels = {255, 255, 255, 0, 255, 255, 255, 255};  // nothing at the left
  const int image = builder.append("images", {{"uri", test::dataUri(test::pngBytes(2, 1, 4, 8, texels), "image/png")}});
  holes["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", builder.append("textures", {{"source", image}})}};
  holes["alphaMode"] = "MASK";
  json glass = material({1, 1, 1, 0.5});
  glass["alphaMode"] = "BLEND";
  const json uv = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  const auto quad = [&](const json& m, double z, const json& extra = json::object()) {
    json primitive = test::addQuad(builder, {-1, -1}, {1, 1});
    primitive["attributes"]["TEXCOORD_0"] = uv;
    json node = at(0, 0, z);
    node.update(extra);
    test::addMeshNode(builder, primitive, builder.append("materials", m), node);
  };
  quad(material({1, 1, 1, 1}), 3);  // in front of all
  quad(holes, 0);
  quad(glass, 1);
  quad(material({1, 1, 1, 1}), 2, {{"rotation", {0, 1, 0, 0}}});  // shows its back
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  scene.settings.quality.samples = GENERATE(1, 4);
  test::Studio studio;
  const frame::Picture shown = scene.render(studio, "overdraw");
  checkShown(shownAt(shown, 0, 1), 255.0 * optics::falseColor(2.0 / 8));
  checkShown(shownAt(shown, 3, 1), 255.0 * optics::falseColor(3.0 / 8));
  studio.display = false;
  CHECK(test::pixel(scene.render(studio, "overdraw").radiance, 3, 1) == glm::vec4(3, 3, 3, 1));
}

TEST_CASE("Channels: nodes and materials have a colour each, numbers where radiance alone is read", "[gl]") {
  GltfBuilder builder = emptyScene();
  const int plain = builder.append("materials", material({1, 1, 1, 1}));
  const json quad = test::addQuad(builder, {-0.25, -1}, {0.25, 1});
  const int mesh = builder.append("meshes", {{"primitives", json::array({quad})}});
  builder.json["meshes"][static_cast<size_t>(mesh)]["primitives"][0]["material"] = plain;
  for (int i = 0; i < 4; ++i) {  // instances of one draw
    const int node = builder.append("nodes", {{"mesh", mesh}, {"translation", {-0.75 + 0.5 * i, 0, 0}}});
    builder.json["scenes"][0]["nodes"].push_back(node);
  }
  test::addOrthographicCamera(builder, 1, 1);
  Scene scene(builder);
  test::Studio studio;
  std::set<std::tuple<double, double, double>> colors;
  const frame::Picture shown = scene.render(studio, "node");
  for (int x = 0; x < 4; ++x) colors.insert({shownAt(shown, x, 1).x, shownAt(shown, x, 1).y, shownAt(shown, x, 1).z});
  CHECK(colors.size() == 4);
  studio.display = false;
  const frame::Picture numbers = scene.render(studio, "node");
  for (int x = 0; x < 4; ++x) CHECK(test::pixel(numbers.radiance, x, 1).x == static_cast<float>(x));
  CHECK(test::pixel(scene.render(studio, "material").radiance, 1, 1).x == 0);
}
