// The KTX2 images of the shared models, where they are at hand.

#include <catch2/catch.hpp>

#include "io/gltf.hpp"
#include "io/image.hpp"
#include "support/skip.hpp"

using namespace facet;

TEST_CASE("KTX2 images of the shared models are shown whole", "[io][image][ktx2][shared]") {
  struct Row {
    const char* path;
    const char* format;
    size_t images;
    int side;
    int levels;
  };
  const Row rows[] = {
      {"AnisotropyBarnLamp/glTF-KTX2-Basisu/AnisotropyBarnLamp.gltf", "KTX2 (UASTC, Zstandard)", 4, 2048, 1},
      {"JetFighter/glTF-Binary/jet-fighter.glb", "KTX2 (ETC1S, BasisLZ)", 3, 4096, 13}};
  for (const Row& row : rows) {
    INFO(row.path);
    const std::string path = test::sharedFile(std::string("assets/models/") + row.path);
    if (path.empty()) return;
    const auto loaded = io::loadGltf(path);
    REQUIRE(loaded);
    const scene::Model& model = loaded->model;
    const auto infos = io::describeImages(model);
    REQUIRE(infos.size() == row.images);
    for (const io::ImageInfo& info : infos) {
      CHECK(info.problem == "");
      CHECK(info.format == row.format);
      CHECK(info.width == row.side);
      CHECK(info.height == row.side);
      CHECK(info.levels == row.levels);
    }
    Notes notes;
    const auto pixels = io::decodeImages(model, std::vector<bool>(row.images, true), notes);
    for (const Note& note : notes) CHECK(note.text == "");
    for (const io::Pixels& image : pixels) {
      CHECK(image.levels.size() + 1 == static_cast<size_t>(row.levels));
      // The smallest level is the mean of the largest.
      if (image.levels.empty()) continue;
      for (size_t c = 0; c < 3; ++c) {
        uint64_t sum = 0;
        const auto channels = static_cast<size_t>(image.channels);
        for (size_t i = c; i < image.data.size(); i += channels) sum += image.data[i];
        const double mean = static_cast<double>(sum) / static_cast<double>(image.data.size() / channels);
        CHECK(std::abs(mean - image.levels.back()[c]) < 40);
      }
    }
  }
}
