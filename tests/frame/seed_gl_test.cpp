#include <catch2/catch.hpp>

#include "support/picture.hpp"

using namespace facet;

namespace {

double meanSquare(const io::RadianceImage& a, const io::RadianceImage& b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const glm::dvec3 d = glm::dvec3(a.pixels[i]) - glm::dvec3(b.pixels[i]);
    sum += glm::dot(d, d);
  }
  return sum / static_cast<double>(a.pixels.size());
}

}  // namespace

TEST_CASE("seed: the same one draws the same bytes, another one independent noise", "[gl]") {
  test::GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addSphere(builder, 0.5),
                    builder.append("materials", test::material({0.9, 0.6, 0.4, 1}, 1, 0.5)), test::at(0, 0, 0));
  test::addOrthographicCamera(builder, 0.3, 0.3);
  const io::LoadedModel model = test::loadBuilt(builder);
  frame::LoadedScene scene = test::sceneOf(model);
  test::Studio studio;
  frame::PictureSettings settings = test::bareSettings(24, 24);
  settings.viewpoint.camera = "0";
  settings.sources.environment = "builtin:studio";
  settings.quality.transport = GENERATE(frame::Transport::direct, frame::Transport::paths);
  const auto drawn = [&](int samples, int seed) {
    settings.quality.samples = samples, settings.quality.seed = seed;
    return studio.render(scene, settings).radiance;
  };
  const io::RadianceImage first = drawn(16, 0), second = drawn(16, 1), third = drawn(16, frame::largestSeed);
  CHECK((drawn(16, 1).pixels == second.pixels));
  const io::RadianceImage truth = drawn(1024, 2);
  const double a = meanSquare(first, truth), b = meanSquare(second, truth), c = meanSquare(third, truth);
  // Independent errors: their squares add up.
  CHECK(meanSquare(first, second) == Approx(a + b).epsilon(0.15));
  CHECK(meanSquare(second, third) == Approx(b + c).epsilon(0.15));
  CHECK(meanSquare(first, third) == Approx(a + c).epsilon(0.15));
}
