#include <webp/encode.h>

#include <catch2/catch.hpp>
#include <cmath>

#include "base/srgb.hpp"
#include "support/ktx2_builder.hpp"
#include "support/ktx2_samples.hpp"
#include "support/picture.hpp"

using namespace facet;
using nlohmann::json;
using test::checkPixel, test::emptyScene, test::unlit;

// Red, green and blue levels of 8, 4 and 2 texels; the last one, which the file lacks, is made from the blue one.
TEST_CASE("Mip levels of a file are those that are drawn", "[gl][ktx2]") {
  test::Ktx2File file;
  file.vkFormat = 29;
  file.transfer = 2;
  file.channelIds = {0, 1, 2};
  file.width = file.height = 8;
  for (size_t level = 0; level < 3; ++level) {
    const size_t side = 8u >> level;
    std::vector<uint8_t> texels(3 * side * side);
    for (size_t i = level; i < texels.size(); i += 3) texels[i] = 255;
    file.levels.push_back(texels);
  }
  test::GltfBuilder builder = emptyScene();
  builder.append("images", {{"uri", test::dataUri(file.bytes(), "image/ktx2")}});
  builder.append("textures", {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  json m = unlit({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  CHECK(model.notes.empty());
  test::Studio studio;
  for (const auto& [side, color] : {std::pair(8, glm::vec4(1, 0, 0, 1)), std::pair(4, glm::vec4(0, 1, 0, 1)),
                                    std::pair(2, glm::vec4(0, 0, 1, 1)), std::pair(1, glm::vec4(0, 0, 1, 1))}) {
    INFO(side);
    frame::PictureSettings settings = test::bareSettings(side, side);
    settings.viewpoint.camera = "0";
    checkPixel(test::pixel(studio.render(model, settings).radiance, side / 2, side / 2), color);
  }
}

// One picture as PNG, as WebP, which loses nothing here, and in the two formats of Basis Universal.
TEST_CASE("PNG, WebP and KTX2 of one picture agree within the formats' errors", "[gl][ktx2]") {
  std::vector<uint8_t> texels;
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x)
      for (const int value : {8 * x + 4, 8 * y + 4, (x * x + y * y) / 8}) texels.push_back(static_cast<uint8_t>(value));
  uint8_t* encoded = nullptr;
  const size_t size = WebPEncodeLosslessRGB(texels.data(), 32, 32, 96, &encoded);
  const std::vector<uint8_t> webp(encoded, encoded + size);
  WebPFree(encoded);
  test::Studio studio;
  const auto shown = [&](const std::vector<uint8_t>& file, const char* extension) {
    test::GltfBuilder builder = emptyScene();
    builder.append("images", {{"uri", test::dataUri(file)}});
    builder.append("samplers", {{"magFilter", 9728}, {"minFilter", 9728}});
    json texture = {{"sampler", 0}};
    if (extension)
      texture["extensions"][extension] = {{"source", 0}};
    else
      texture["source"] = 0;
    builder.append("textures", texture);
    json m = unlit({1, 1, 1, 1});
    m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    json quad = test::addQuad(builder, {-1, -1}, {1, 1});
    quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 1, 1, 1, 1, 0, 0, 0}, test::floatType, "VEC2");
    test::addMeshNode(builder, quad, builder.append("materials", m));
    test::addOrthographicCamera(builder, 1, 1);
    frame::PictureSettings settings = test::bareSettings(32, 32);
    settings.viewpoint.camera = "0";
    const frame::Picture picture = studio.render(test::loadBuilt(builder), settings);
    CHECK(studio.notes.empty());
    std::vector<double> bytes;
    for (int i = 0; i < 32 * 32; ++i) {
      const glm::vec4& linear = test::pixel(picture.radiance, i % 32, i / 32);
      for (const float c : {linear.x, linear.y, linear.z}) bytes.push_back(255 * srgbFromLinear(c));
    }
    return bytes;
  };
  const std::vector<double> png = shown(test::pngBytes(32, 32, 3, 8, texels), nullptr);
  const auto rms = [&](const std::vector<double>& other) {
    double sum = 0;
    for (size_t i = 0; i < png.size(); ++i) sum += std::pow(png[i] - other[i], 2);
    return std::sqrt(sum / static_cast<double>(png.size()));
  };
  CHECK(rms(shown(webp, "EXT_texture_webp")) == 0);
  // Of the texels themselves the encoder's files are off by 1.97 and 6.89.
  CHECK(rms(shown(test::fromHex(test::uastcRamps), "KHR_texture_basisu")) == Approx(1.97).margin(0.1));
  CHECK(rms(shown(test::fromHex(test::etc1sRamps), "KHR_texture_basisu")) == Approx(6.89).margin(0.1));
}

// The alpha of a mask's levels is made from the largest one, whatever the file's say: here 0.
TEST_CASE("Masks keep their coverage with mip levels of a file", "[gl][ktx2]") {
  std::vector<uint8_t> texels;
  for (int y = 0; y < 16; ++y)
    for (int x = 0; x < 16; ++x)
      texels.insert(texels.end(), {200, 100, 50, static_cast<uint8_t>(x % 4 < 2 || y > 11 ? 255 : 0)});
  test::Ktx2File file;
  file.vkFormat = 43;
  file.transfer = 2;
  file.width = file.height = 16;
  file.levels = {texels};
  for (size_t side = 8; side > 0; side /= 2) {
    std::vector<uint8_t> level;
    for (size_t i = 0; i < side * side; ++i) level.insert(level.end(), {200, 100, 50, 0});
    file.levels.push_back(level);
  }
  test::Studio studio;
  const auto shown = [&](const std::vector<uint8_t>& image, const json& texture) {
    test::GltfBuilder builder = emptyScene();
    builder.append("images", {{"uri", test::dataUri(image)}});
    builder.append("textures", texture);
    json m = unlit({1, 1, 1, 1});
    m["alphaMode"] = "MASK";
    m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    json quad = test::addQuad(builder, {-1, -1}, {1, 1});
    quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
    test::addMeshNode(builder, quad, builder.append("materials", m));
    test::addOrthographicCamera(builder, 1, 1);
    frame::PictureSettings settings = test::bareSettings(4, 4);
    settings.quality.samples = 16;
    settings.viewpoint.camera = "0";
    return studio.render(test::loadBuilt(builder), settings).radiance;
  };
  const auto png = shown(test::pngBytes(16, 16, 4, 8, texels), {{"source", 0}});
  const auto ktx2 = shown(file.bytes(), {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}});
  float covered = 0;
  for (int i = 0; i < 16; ++i) {
    checkPixel(test::pixel(ktx2, i % 4, i / 4), test::pixel(png, i % 4, i / 4), 5e-3f);
    covered += test::pixel(ktx2, i % 4, i / 4).w / 16;
  }
  CHECK(covered == Approx(0.625).margin(0.1));
}
