#include <catch2/catch.hpp>

#include "support/ktx2_builder.hpp"
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
