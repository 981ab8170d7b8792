#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/angle.hpp"
#include "frame/path_scenes.hpp"
#include "support/picture.hpp"

// The floor that shows only what the scene does to its light, against closed forms.

using namespace facet;
using frame::PictureSettings;
using test::addBox, test::at, test::emptyScene, test::lambert;
using test::GltfBuilder;

namespace {

// A black plate of 2 a x 2 a, h above the floor's height, which a speck in a corner gives.
struct Plate {
  double a = 0.5, h = 0.5;
  float albedo = 0;
  bool lamp = false;  // a point light, 2 m above the floor's middle
};
io::LoadedModel plateOverFloor(const Plate& plate) {
  GltfBuilder builder = emptyScene();
  const int black = builder.append("materials", test::material({0, 0, 0, 1}));
  const auto a = static_cast<float>(plate.a);
  test::addMeshNode(builder, addBox(builder, {a, 1e-4f, a}, false), black, at(0, plate.h, 0));
  test::addMeshNode(builder, addBox(builder, {1e-4f, 1e-4f, 1e-4f}, false), black, at(0.45, 1e-4, 0.45));
  io::LoadedModel model = test::loadBuilt(builder);
  for (scene::Material& m : model.model.materials) lambert(m, plate.albedo);
  if (plate.lamp) {
    test::addPointLight(model.model, 4, {0, 2, 0});
  }
  return model;
}

// Sees the floor from straight above, 4 m x 4 m of it: pixel (x, y) lies at (x + 0.5) / 64 * 4 - 2.
PictureSettings fromAbove(const char* environment) {
  PictureSettings settings = test::bareSettings(64, 64);
  settings.sources.environment = environment;
  settings.frame.ground = true;
  settings.frame.background = frame::Background::transparent;
  settings.quality.visibility = frame::Visibility::none;
  settings.viewpoint.target = glm::dvec3(0);
  settings.viewpoint.orbit = frame::Orbit{0, 0.01, 400};
  settings.viewpoint.fovYDeg = 2 * std::atan(2.0 / 400) * 180 / pi;
  return settings;
}
int pixelAt(double metres) { return static_cast<int>((metres + 2) / 4 * 64); }

// Form factor of an element to a parallel rectangle [0, x] x [0, y] at distance h, with its corner above the element.
double cornerFactor(double x, double y, double h) {
  const auto part = [&](double p, double q) {
    const double root = std::sqrt(h * h + p * p);
    return p / root * std::atan(q / root);
  };
  return (part(x, y) + part(y, x)) / (2 * pi);
}
// Of the plate, signed corners.
double plateFactor(const Plate& plate, double x, double z) {
  const auto corner = [&](double dx, double dz) {
    const double sign = (dx < 0 ? -1 : 1) * (dz < 0 ? -1 : 1);
    return sign * cornerFactor(std::abs(dx), std::abs(dz), plate.h);
  };
  const double l = -plate.a - x, r = plate.a - x, n = -plate.a - z, f = plate.a - z;
  return corner(r, f) - corner(l, f) - corner(r, n) + corner(l, n);
}

}  // namespace

TEST_CASE("Ground: under a black plate in white light it is covered by the plate's form factor", "[gl]") {
  test::Studio studio;
  const Plate plate;
  const frame::Picture picture = studio.render(plateOverFloor(plate), fromAbove("builtin:white"));
  REQUIRE(picture.statistics.ground);
  CHECK(std::ranges::count(picture.statistics.frame.passes, "ground") == 1);
  CHECK(picture.statistics.visibility.method == "none");
  for (const double x : {0.62, 0.75, 0.95}) {
    const int column = pixelAt(x);
    const double centre = (column + 0.5) / 64 * 4 - 2;
    const glm::vec4 seen = test::pixel(picture.radiance, column, 32);
    INFO("at " << centre);
    CHECK(double(seen.w) == Approx(plateFactor(plate, centre, 0.03)).margin(0.025));
    CHECK(glm::vec3(seen) == glm::vec3(0));  // a black plate returns nothing
  }
}

TEST_CASE("Ground: a lamp's shadow is black to its edge, and beside it there is nothing at all", "[gl]") {
  test::Studio studio;
  Plate plate;
  plate.lamp = true;
  plate.h = 1;  // the shadow is twice as wide: to 1 m
  const frame::Picture picture = studio.render(plateOverFloor(plate), fromAbove("none"));
  const auto cover = [&](double x) { return test::pixel(picture.radiance, pixelAt(x), 32).w; };
  for (const double x : {0.6, 0.8, 0.9}) CHECK(cover(x) == Approx(1).margin(0.01));
  for (const double x : {1.1, 1.2, 1.3}) CHECK(cover(x) == 0);
}

TEST_CASE("Ground: what the scene returns brightens it, more than its shadow where that is", "[gl]") {
  test::Studio studio;
  Plate plate;
  plate.albedo = 1;
  const frame::Picture white = studio.render(plateOverFloor(plate), fromAbove("builtin:white"));
  plate.albedo = 0;
  const frame::Picture black = studio.render(plateOverFloor(plate), fromAbove("builtin:white"));
  const auto cover = [&](const frame::Picture& p) { return test::pixel(p.radiance, pixelAt(0.62), 32).w; };
  // The plate sees a white half space below it, since the floor is in no ray's way: all that it blocks it returns.
  CHECK(cover(white) < 0.02f);
  CHECK(cover(black) > 0.1f);
}

TEST_CASE("Ground: drawn, corrected and traced pictures show the same floor, over any background", "[gl]") {
  test::Studio studio;
  PictureSettings settings = fromAbove("builtin:white");
  const Plate plate;
  const io::LoadedModel model = plateOverFloor(plate);
  const frame::Picture drawn = studio.render(model, settings);
  settings.quality.visibility = frame::Visibility::rays;
  const frame::Picture corrected = studio.render(model, settings);
  settings.quality.transport = frame::Transport::paths;
  const frame::Picture traced = studio.render(model, settings);
  settings.quality.transport = frame::Transport::direct;
  settings.quality.visibility = frame::Visibility::none;
  settings.frame.background = frame::Background::environment;
  const frame::Picture over = studio.render(model, settings);
  for (const double x : {0.7, 0.8, 0.95, 1.2}) {
    const auto at = [&](const frame::Picture& p) { return test::pixel(p.radiance, pixelAt(x), 32); };
    CHECK(at(corrected).w == Approx(at(drawn).w).margin(0.002));
    CHECK(at(traced).w == Approx(at(drawn).w).margin(0.04));  // its samples lie elsewhere in the pixel
    CHECK(at(over).x == Approx(1 - at(drawn).w).margin(0.01));
    CHECK(at(over).w == 1);
  }
  // From below there is none.
  settings.viewpoint.orbit = frame::Orbit{0, 179.99, 400};
  settings.frame.background = frame::Background::transparent;
  const frame::Picture below = studio.render(model, settings);
  CHECK(test::pixel(below.radiance, pixelAt(0.75), 32) == glm::vec4(0));
}

TEST_CASE("Ground: a floor that no light reaches shows nothing, one that is not asked for costs nothing", "[gl]") {
  test::Studio studio;
  const Plate plate;
  const frame::Picture dark = studio.render(plateOverFloor(plate), fromAbove("none"));
  for (const glm::vec4& p : dark.radiance.pixels) CHECK(glm::vec3(p) == glm::vec3(0));
  CHECK(test::pixel(dark.radiance, pixelAt(0.75), 32).w == 0);
  PictureSettings settings = fromAbove("builtin:white");
  settings.frame.ground = false;
  const frame::Picture without = studio.render(plateOverFloor(plate), settings);
  CHECK_FALSE(without.statistics.ground);
  CHECK_FALSE(without.statistics.traced);
  settings.frame.ground = true;
  settings.look.channel = "baseColor";
  CHECK_FALSE(studio.render(plateOverFloor(plate), settings).statistics.ground);
}

TEST_CASE("Ground: it stays where it is while an animation lifts what stands on it", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  const int node = test::addMeshNode(builder, test::addSphere(builder, 0.5, 24, 48),
                                     builder.append("materials", test::material({0, 0, 0, 1})));
  const std::vector<float> times = {0, 1}, heights = {0, 0, 0, 0, 1, 0};
  builder.append("animations",
                 {{"samplers",
                   {{{"input", builder.add(times, test::floatType, "SCALAR")},
                     {"output", builder.add(heights, test::floatType, "VEC3")}}}},
                  {"channels", {{{"sampler", 0}, {"target", {{"node", node}, {"path", "translation"}}}}}}});
  PictureSettings settings = fromAbove("builtin:white");
  settings.placement.animation = "0";
  const io::LoadedModel model = test::loadBuilt(builder);
  const auto cover = [&](double time) {
    settings.placement.timeSeconds = time;
    return test::pixel(studio.render(model, settings).radiance, pixelAt(0.6), 32).w;
  };
  // Beside the sphere, which covers r^2 h / d^3 of the light (its centre h above the floor, d away).
  CHECK(double(cover(0)) == Approx(0.25 * 0.5 / std::pow(0.594 * 0.594 + 0.5 * 0.5, 1.5)).margin(0.03));
  CHECK(double(cover(1)) == Approx(0.25 * 1.5 / std::pow(0.594 * 0.594 + 1.5 * 1.5, 1.5)).margin(0.02));
}
