#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/angle.hpp"
#include "frame/path_scenes.hpp"
#include "support/picture.hpp"

// Surfaces that glow as lights that paths look at.

using namespace facet;
using frame::PictureSettings;
using test::at, test::emptyScene, test::glowing, test::lambert, test::meanOf, test::tracedSettings;
using test::GltfBuilder;

namespace {

constexpr double lampHalf = 0.1, lampHeight = 1, floorAlbedo = 0.5;

// A small square of radiance 10 above a grey floor; `extra` goes into the lamp's material.
io::LoadedModel lampOverFloor(const nlohmann::json& extra = nlohmann::json::object()) {
  GltfBuilder builder = emptyScene();
  nlohmann::json lamp = glowing({1, 1, 1, 1}, extra);
  lamp["doubleSided"] = true;
  const auto half = static_cast<float>(lampHalf);
  nlohmann::json quad = test::addQuad(builder, {-half, -half}, {half, half});
  quad["attributes"]["TEXCOORD_0"] = builder.add(std::vector<float>{0, 0, 1, 0, 1, 1, 0, 1}, test::floatType, "VEC2");
  const int lit = builder.append("materials", lamp);
  test::addMeshNode(builder, quad, lit, at(0, 0, lampHeight));
  const int grey = builder.append("materials", test::material({1, 1, 1, 1}));
  test::addMeshNode(builder, test::addQuad(builder, {-2, -2}, {2, 2}), grey);
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  model.model.materials[0].emissiveStrength = 10;
  lambert(model.model.materials[static_cast<size_t>(grey)], static_cast<float>(floorAlbedo));
  return model;
}

// Radiance of the floor x m from its middle: albedo times radiance times the lamp's form factor, by midpoints.
double floorRadiance(double x) {
  double factor = 0;
  constexpr int steps = 200;
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double dx = x - lampHalf + 2 * lampHalf * (i + 0.5) / steps,
                   dy = -lampHalf + 2 * lampHalf * (j + 0.5) / steps;
      const double d2 = dx * dx + dy * dy + lampHeight * lampHeight;
      factor += lampHeight * lampHeight / (pi * d2 * d2);
    }
  return floorAlbedo * 10 * factor * 4 * lampHalf * lampHalf / (steps * steps);
}

// Of 4 x 20 pixels at the right edge of a 40 x 40 picture.
template <class Each>
void eachAtRight(const Each& each) {
  for (int y = 10; y < 30; ++y)
    for (int x = 36; x < 40; ++x) each(x, y);
}
double meanAtRight(const frame::Picture& picture) {
  double sum = 0;
  eachAtRight([&](int x, int y) { sum += double(test::pixel(picture.radiance, x, y).x) / 80; });
  return sum;
}
// What is seen over what the lamp's form factor says: its mean, and its standard deviation.
struct Ratio {
  double mean = 0, deviation = 0;
};
Ratio overExpected(const frame::Picture& picture) {
  double sum = 0, squares = 0;
  eachAtRight([&](int x, int y) {
    const double expected = floorRadiance(std::hypot((x + 0.5) / 20 - 1, (y + 0.5) / 20 - 1));
    const double ratio = double(test::pixel(picture.radiance, x, y).x) / expected;
    sum += ratio / 80, squares += ratio * ratio / 80;
  });
  return {sum, std::sqrt(std::max(squares - sum * sum, 0.0))};
}

}  // namespace

TEST_CASE("Paths: a small lamp that glows lights a floor by its form factor, with few samples", "[gl]") {
  test::Studio studio;
  PictureSettings settings = tracedSettings(40, 40, 16, "none");
  settings.quality.bounces = 1;
  const Ratio seen = overExpected(studio.render(lampOverFloor(), settings));
  CHECK(seen.mean == Approx(1).epsilon(0.01));
  CHECK(seen.deviation < 0.1);  // by chance one path in 300 finds it
}

TEST_CASE("Paths: what glows by a texture, is coated or lets light through is found by chance, and as bright", "[gl]") {
  test::Studio studio;
  PictureSettings settings = tracedSettings(40, 40, 1024, "none");
  settings.quality.bounces = 1;
  const Ratio looked = overExpected(studio.render(lampOverFloor(), settings));
  io::LoadedModel masked = lampOverFloor({{"alphaMode", "MASK"}, {"alphaCutoff", 0.5}});
  const Ratio chance = overExpected(studio.render(masked, settings));
  CHECK(looked.deviation < 0.02);
  CHECK(chance.deviation > 0.2);
  CHECK(chance.mean == Approx(1).epsilon(0.1));
}

TEST_CASE("Paths: environment, point light and glow together are their sum", "[gl]") {
  test::Studio studio;
  const auto render = [&](bool environment, bool point, bool glow) {
    io::LoadedModel model = lampOverFloor();
    if (!glow) model.model.materials[0].emissiveStrength = 0;
    if (point) {
      test::addPointLight(model.model, 1, {0.7, 0, 0.8});
    }
    PictureSettings settings = tracedSettings(40, 40, 128, environment ? "builtin:studio" : "none");
    settings.quality.bounces = 1;
    return meanAtRight(studio.render(model, settings));
  };
  const double sum = render(true, false, false) + render(false, true, false) + render(false, false, true);
  CHECK(render(true, true, true) == Approx(sum).epsilon(0.01));
  CHECK(render(true, false, true) == Approx(render(true, false, false) + render(false, false, true)).epsilon(0.01));
  CHECK(render(false, true, true) == Approx(render(false, true, false) + render(false, false, true)).epsilon(0.01));
}

TEST_CASE("Paths: a mirror shows what glows as bright as it is, a rough metal as bright as chance finds it", "[gl]") {
  test::Studio studio;
  for (const float roughness : {0.0f, 0.3f}) {
    const auto render = [&](bool masked, int samples) {
      GltfBuilder builder = emptyScene();
      const int lamp = builder.append(
          "materials",
          glowing({1, 0.5f, 0.25f, 1}, masked ? nlohmann::json{{"alphaMode", "MASK"}} : nlohmann::json::object()));
      builder.json["materials"][0]["doubleSided"] = true;
      test::addMeshNode(builder, test::addQuad(builder, {-8, -8}, {8, 8}), lamp, at(0, 0, 12));  // behind the camera
      const int metal = builder.append("materials", test::material({1, 1, 1, 1}, 1, double(roughness)));
      test::addMeshNode(builder, test::addQuad(builder, {-2, -2}, {2, 2}), metal);
      test::addOrthographicCamera(builder, 0.5, 0.5);
      PictureSettings settings = tracedSettings(16, 16, samples, "none");
      settings.quality.bounces = 1;
      return meanOf(studio.render(test::loadBuilt(builder), settings).radiance);
    };
    const glm::dvec3 looked = render(false, 64), chance = render(true, 256);
    INFO("roughness " << roughness);
    for (int c = 0; c < 3; ++c) CHECK(looked[c] == Approx(chance[c]).epsilon(0.01));
    if (roughness == 0) CHECK(looked.x == Approx(1).epsilon(0.01));
  }
}
