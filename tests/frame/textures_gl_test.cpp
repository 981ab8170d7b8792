#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/srgb.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;
using test::at, test::checkPixel, test::emptyScene, test::material, test::unlit;
using test::GltfBuilder;

TEST_CASE("Textures: transform, sampler and vertex colour reach the pixel") {
  GltfBuilder builder = emptyScene();
  const std::vector<uint8_t> texels = {255, 0, 0, 0, 255, 0};
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(2, 1, 3, 8, texels), "image/png")}});
  builder.append("samplers", {{"magFilter", 9728}, {"minFilter", 9728}});
  builder.append("textures", {{"source", 0}, {"sampler", 0}});
  const int uv = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  for (const double offset : {0.0, 0.5}) {
    json m = unlit({1, 0.5, 1, 1});
    m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    if (offset > 0)
      m["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"]["offset"] = {offset, 0};
    json quad = test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5});
    quad["attributes"]["TEXCOORD_0"] = uv;
    test::addMeshNode(builder, quad, builder.append("materials", m), at(offset * 2 - 0.5, 0, 0));
  }
  test::addOrthographicCamera(builder, 1, 0.5);
  PictureSettings settings = test::bareSettings(8, 4);
  settings.viewpoint.camera = "0";
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  checkPixel(test::pixel(picture.radiance, 1, 2), {1, 0, 0, 1});
  checkPixel(test::pixel(picture.radiance, 3, 2), {0, 0.5, 0, 1});
  checkPixel(test::pixel(picture.radiance, 5, 2), {0, 0.5, 0, 1});  // half a turn on
  checkPixel(test::pixel(picture.radiance, 7, 2), {1, 0, 0, 1});
  CHECK(picture.statistics.imagesDecoded == 1);
}

// Columns of 8 texels, black and white in turn, a pixel wide; 64 texels of a pixel's height, by which the level is
// chosen.
TEST_CASE("Textures: many draws do not blur by the longer axis of what a pixel sees", "[gl]") {
  GltfBuilder builder = emptyScene();
  std::vector<uint8_t> texels;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) texels.push_back(x / 8 % 2 == 0 ? 0 : 255);
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(64, 64, 1, 8, texels), "image/png")}});
  builder.append("textures", {{"source", 0}});
  json m = unlit({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 8, 0, 8}, test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  PictureSettings settings = test::bareSettings(8, 8);
  settings.viewpoint.camera = "0";
  settings.quality.samples = 64;
  const frame::Picture picture = test::Studio().render(test::loadBuilt(builder), settings);
  for (int x = 0; x < 8; ++x) {
    // Of a level whose texels are a quarter of a pixel, a sixteenth is the neighbours'.
    const float value = test::pixel(picture.radiance, x, 4).x;
    CHECK((x % 2 == 0 ? value : 1 - value) < 0.08f);
  }
}

TEST_CASE("Every set of texture coordinates reaches its texture") {
  const int set = GENERATE(0, 1, 2, 5, 7);
  GltfBuilder builder = emptyScene();
  // Texel i is (i + 1) * 25; set n points at texel n, the second texture's set at texel 8.
  std::vector<uint8_t> texels;
  for (int i = 0; i < 9; ++i) texels.insert(texels.end(), 3, static_cast<uint8_t>((i + 1) * 25));
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(9, 1, 3, 8, texels), "image/png")}});
  builder.append("samplers", {{"magFilter", 9728}, {"minFilter", 9728}});
  builder.append("textures", {{"source", 0}, {"sampler", 0}});
  json m = material({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}, {"texCoord", set}};
  m["occlusionTexture"] = {{"index", 0}, {"texCoord", 7 - set}};
  m["emissiveTexture"] = {{"index", 0}, {"texCoord", 7 - set}};
  m["emissiveFactor"] = {1, 1, 1};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  for (int n = 0; n < 8; ++n) {
    const float u = (static_cast<float>(n) + 0.5f) / 9;
    quad["attributes"]["TEXCOORD_" + std::to_string(n)] =
        builder.add(std::vector<float>{u, 0, u, 0, u, 0, u, 0}, test::floatType, "VEC2");
  }
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = test::bareSettings(2, 2);
  settings.viewpoint.camera = "0";
  test::Studio studio;
  for (const char* channel : {"roughness", "occlusion"}) {
    settings.look.channel = channel;
    const int expected = channel[0] == 'r' ? set : 7 - set;
    const float value = static_cast<float>((expected + 1) * 25) / 255;
    checkPixel(test::pixel(studio.render(model, settings).radiance, 1, 1), {value, value, value, 1});
  }
  // Two sets in one program. Nothing lights it, so that only emission is left.
  settings.look.channel = "";
  const auto linear = static_cast<float>(linearFromSrgb(static_cast<float>((8 - set) * 25) / 255));
  // Drivers may decode sRGB with a few bits less; the texels are 0.02 apart at least.
  checkPixel(test::pixel(studio.render(model, settings).radiance, 1, 1), {linear, linear, linear, 1}, 3e-3f);
}

namespace {

// The occlusion texture over the whole of a square picture, as linear numbers.
frame::Picture textured(const std::vector<uint8_t>& png, int side, const json& sampler) {
  GltfBuilder builder = emptyScene();
  builder.append("images", {{"uri", test::dataUri(png, "image/png")}});
  builder.append("samplers", sampler);
  builder.append("textures", {{"source", 0}, {"sampler", 0}});
  json m = material({1, 1, 1, 1});
  m["occlusionTexture"] = {{"index", 0}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  PictureSettings settings = test::bareSettings(side, side);
  settings.viewpoint.camera = "0";
  settings.look.channel = "occlusion";
  return test::Studio().render(test::loadBuilt(builder), settings);
}

}  // namespace

TEST_CASE("Texture filters: nearest has hard edges, linear has none") {
  const std::vector<uint8_t> png = test::pngBytes(2, 2, 1, 8, std::vector<uint8_t>{0, 255, 51, 153});
  const frame::Picture hard = textured(png, 16, {{"magFilter", 9728}, {"wrapS", 33071}, {"wrapT", 33071}});
  const float texels[2][2] = {{0, 1}, {0.2f, 0.6f}};
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      REQUIRE(test::pixel(hard.radiance, x, y).x == Approx(texels[y / 8][x / 8]).margin(5e-4));  // half floats
  // Without mipmaps, so that no anisotropic filter takes the place of the linear one: Mesa's does when magnifying too.
  const frame::Picture soft =
      textured(png, 16, {{"magFilter", 9729}, {"minFilter", 9729}, {"wrapS", 33071}, {"wrapT", 33071}});
  for (int x = 0; x < 16; ++x) {
    // Texel centres lie at 4 and 12 pixels.
    const float t = std::clamp((static_cast<float>(x) + 0.5f - 4) / 8, 0.0f, 1.0f);
    CHECK(test::pixel(soft.radiance, x, 0).x == Approx(t).margin(5e-3));  // drivers weigh with 8 bits
  }
}

TEST_CASE("Texture filters: smaller pictures of a checkerboard show texels or their mean, as the sampler says") {
  std::vector<uint8_t> board(64);
  for (size_t i = 0; i < 64; ++i) board[i] = (i / 8 + i) % 2 == 0 ? 255 : 0;
  const auto png = test::pngBytes(8, 8, 1, 8, board);
  const auto shown = [&](int minFilter) {
    return test::pixel(textured(png, 2, {{"minFilter", minFilter}}).radiance, 0, 0).x;
  };
  const float nearest = shown(9728);
  CHECK((nearest == 0 || nearest == 1));
  CHECK(shown(9984) == Approx(0.5f).margin(3e-3));  // NEAREST_MIPMAP_NEAREST
  CHECK(shown(9986) == Approx(0.5f).margin(3e-3));  // NEAREST_MIPMAP_LINEAR
  CHECK(shown(9987) == Approx(0.5f).margin(3e-3));  // LINEAR_MIPMAP_LINEAR
}

TEST_CASE("A 16-bit PNG keeps its depth up to the pixel") {
  // Both would be 8 of 255, 0.03137.
  const std::vector<uint8_t> png = test::pngBytes(2, 1, 1, 16, std::vector<uint8_t>{0x08, 0x00, 0x08, 0x20});
  const frame::Picture picture = textured(png, 2, {{"magFilter", 9728}, {"minFilter", 9728}});
  CHECK(test::pixel(picture.radiance, 0, 0).x == Approx(0x0800 / 65535.0).margin(2e-5));
  CHECK(test::pixel(picture.radiance, 1, 0).x == Approx(0x0820 / 65535.0).margin(2e-5));
}
