#include <catch2/catch.hpp>

#include "report/frame_cost.hpp"
#include "support/picture.hpp"

using namespace facet;
using test::GltfBuilder;

TEST_CASE("frame: on a slanted texture several reads are nearer to the converged picture than one", "[gl]") {
  // Stripes along the longer axis of footprints of 8 texels by 1.3.
  GltfBuilder builder = test::emptyScene();
  std::vector<uint8_t> texels;
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x) texels.push_back(((x / 4) & 1) != 0 ? 255 : 0);
  builder.append("images", {{"uri", test::dataUri(test::pngBytes(64, 64, 1, 8, texels), "image/png")}});
  builder.append("textures", {{"source", 0}});
  nlohmann::json m = test::unlit({1, 1, 1, 1});
  m["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
  nlohmann::json quad = test::addQuad(builder, {-1, -1}, {1, 1});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 6, 0, 6}, test::floatType, "VEC2");
  test::addMeshNode(builder, quad, builder.append("materials", m));
  test::addOrthographicCamera(builder, 1, 1);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  frame::LoadedScene scene = test::sceneOf(model);
  frame::PictureSettings settings = test::bareSettings(48, 48);
  settings.viewpoint.camera = "0";
  const auto rows = report::measureFilters(settings, 64, 1, 1, [&](const frame::PictureSettings& wanted, int repeat) {
    frame::Picture picture = studio.render(scene, wanted);
    picture.statistics.frameMs.resize(1 + size_t(repeat), 2.5);
    return Result<frame::Picture>(std::move(picture));
  });
  REQUIRE(rows);
  REQUIRE(rows->size() == 3);
  const report::FilterRow &isotropic = (*rows)[0], &reads = (*rows)[1], &hardware = (*rows)[2];
  CHECK(isotropic.filter == frame::TextureFilter::isotropic);
  CHECK(reads.filter == frame::TextureFilter::reads);
  CHECK(hardware.filter == frame::TextureFilter::hardware);
  INFO("isotropic " << isotropic.rms << ", reads " << reads.rms << ", hardware " << hardware.rms);
  CHECK(reads.rms < 0.6 * isotropic.rms);
  CHECK(reads.rms == Approx(reads.colorRms).epsilon(0.05));  // unlit: base colour is all there is
  CHECK(hardware.rms < 0.9 * isotropic.rms);
  CHECK(reads.milliseconds == 2.5);
}
