#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "frame/path_scenes.hpp"
#include "optics/horizons.hpp"
#include "support/picture.hpp"

// Shadow maps and horizons, against closed forms.

using namespace facet;
using frame::PictureSettings;
using test::addBox, test::addMeshNode, test::addQuad, test::at, test::emptyScene, test::lambert;
using test::GltfBuilder;

namespace {

// Sees [-2, 2]^2 from +Z.
PictureSettings screenSettings(int size, const char* environment) {
  PictureSettings settings = test::bareSettings(size, size);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  settings.quality.visibility = frame::Visibility::screen;
  return settings;
}

bool passed(const frame::Picture& picture, const char* pass) {
  return std::ranges::count(picture.statistics.frame.passes, pass) == 1;
}

// A white floor in z = 0 and a plate of 1 m x 1 m above its middle, lit from -X: the shadow lies towards +X.
struct Shadow {
  scene::LightType type = scene::LightType::directional;
  double outer = 0.9;                                   // of the spot
  nlohmann::json plate = test::material({0, 0, 0, 1});  // its material
};
io::LoadedModel plateInLight(const Shadow& shadow) {
  GltfBuilder builder = emptyScene();
  test::addOrthographicCamera(builder, 2, 2);
  const int white = builder.append("materials", test::material({1, 1, 1, 1}));
  const int plate = builder.append("materials", shadow.plate);
  addMeshNode(builder, addQuad(builder, {-2, -2}, {2, 2}), white);
  addMeshNode(builder, addQuad(builder, {-0.5f, -0.5f}, {0.5f, 0.5f}), plate, at(0, 0, 1));
  io::LoadedModel model = test::loadBuilt(builder);
  lambert(model.model.materials[0], 1);
  scene::Light light;
  light.type = shadow.type;
  light.intensity = 20;
  light.innerConeAngle = 0, light.outerConeAngle = static_cast<float>(shadow.outer);
  model.model.lights = {light};
  scene::Node node;
  node.light = 0, node.translation = {-2, 0, 3};
  // Along (1, 0, -1) for parallel light, and towards the floor's middle for a spot: -Z of the node.
  const double angle = shadow.type == scene::LightType::directional ? pi / 4 : std::atan2(2.0, 3.0);
  node.rotation = glm::angleAxis(-angle, glm::dvec3(0, 1, 0));
  model.model.nodes.push_back(node);
  model.model.scenes[0].nodes.push_back(static_cast<int>(model.model.nodes.size()) - 1);
  return model;
}

// Radiance of the floor at (x, y) over that without a shadow.
double litShare(const frame::Picture& picture, const frame::Picture& unblocked, double x, double y) {
  const int size = picture.radiance.width;
  const auto index = [&](double v) { return static_cast<int>((v + 2) / 4 * size); };
  const float lit = test::pixel(unblocked.radiance, index(x), index(-y)).x;
  REQUIRE(lit > 0);
  return test::pixel(picture.radiance, index(x), index(-y)).x / lit;
}

frame::Picture without(test::Studio& studio, const io::LoadedModel& model, PictureSettings settings) {
  settings.quality.visibility = frame::Visibility::none;
  return studio.render(model, settings);
}

}  // namespace

TEST_CASE("Shadow maps: a plate's shadow lies where light of each kind puts it, black inside and nothing beside it",
          "[gl]") {
  test::Studio studio;
  const PictureSettings settings = screenSettings(128, "none");
  struct Case {
    Shadow shadow;
    double from, to, halfWidth;  // where it ends along x, and along y
    const char* pass;
  };
  // Parallel light moves it by 1 m; from (-2, 0, 3) it is half as large again.
  const std::vector<Case> cases = {{{scene::LightType::directional}, 0.5, 1.5, 0.5, "1 shadow map"},
                                   {{scene::LightType::point}, 0.25, 1.75, 0.75, "6 shadow maps"},
                                   {{scene::LightType::spot}, 0.25, 1.75, 0.75, "1 shadow map"},
                                   {{scene::LightType::spot, 1.4}, 0.25, 1.75, 0.75, "6 shadow maps"}};
  for (const Case& c : cases) {
    const io::LoadedModel model = plateInLight(c.shadow);
    const frame::Picture picture = studio.render(model, settings), lit = without(studio, model, settings);
    INFO(c.pass << " of a light of type " << static_cast<int>(c.shadow.type));
    CHECK(picture.statistics.visibility.method == "screen");
    CHECK(passed(picture, c.pass));
    CHECK_FALSE(passed(picture, "horizons"));  // there is no environment
    constexpr double edge = 0.07;              // two pixels
    for (const double x : {0.55, 1.0, c.to - edge})
      for (const double y : {0.0, c.halfWidth - edge, edge - c.halfWidth}) CHECK(litShare(picture, lit, x, y) == 0);
    for (const double x : {c.to + edge, 1.95, -0.8, -1.9})
      for (const double y : {0.0, 1.0, -1.9}) CHECK(litShare(picture, lit, x, y) == Approx(1).epsilon(1e-6));
    for (const double y : {c.halfWidth + edge, -c.halfWidth - edge}) CHECK(litShare(picture, lit, 1, y) == Approx(1));
  }
}

TEST_CASE("Shadow maps: a lamp far away casts the shadow of parallel light", "[gl]") {
  test::Studio studio;
  const PictureSettings settings = screenSettings(128, "none");
  io::LoadedModel model = plateInLight({scene::LightType::point});
  for (const double distance : {100.0, 1e4}) {
    model.model.nodes.back().translation = distance * glm::normalize(glm::dvec3(-1, 0, 1));
    model.model.lights[0].intensity = static_cast<float>(5 * distance * distance);
    const frame::Picture picture = studio.render(model, settings), lit = without(studio, model, settings);
    INFO(distance << " m");
    CHECK(passed(picture, "1 shadow map"));
    for (const double x : {0.55, 1.0, 1.4})
      for (const double y : {-0.4, 0.0, 0.4}) CHECK(litShare(picture, lit, x, y) == 0);
    for (const double x : {1.62, 1.9, -0.8}) CHECK(litShare(picture, lit, x, 0) == Approx(1).epsilon(1e-6));
  }
}

TEST_CASE("Shadow maps: masks cast what they show, what is blended or lets light pass casts nothing", "[gl]") {
  test::Studio studio;
  const PictureSettings settings = screenSettings(64, "none");
  const auto shareUnder = [&](const nlohmann::json& plate) {
    const io::LoadedModel model = plateInLight({.plate = plate});
    return litShare(studio.render(model, settings), without(studio, model, settings), 1, 0);
  };
  nlohmann::json masked = test::material({0, 0, 0, 0.4});
  masked["alphaMode"] = "MASK";
  CHECK(shareUnder(masked) == 1);
  masked["alphaCutoff"] = 0.3;
  CHECK(shareUnder(masked) == 0);
  nlohmann::json blended = test::material({0, 0, 0, 0.9});
  blended["alphaMode"] = "BLEND";
  CHECK(shareUnder(blended) == 1);
  nlohmann::json glass = test::material({1, 1, 1, 1});
  glass["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}};
  CHECK(shareUnder(glass) == 1);
}

TEST_CASE("Shadow maps: they follow morph targets", "[gl]") {
  test::Studio studio;
  PictureSettings settings = screenSettings(64, "none");
  io::LoadedModel model = plateInLight({});
  scene::Primitive& plate = model.model.meshes[1].primitives[0];
  plate.targets.resize(1);
  plate.targets[0].positions.assign(plate.positions.size(), glm::vec3(0, 1, 0));
  model.model.meshes[1].weights = {1};
  const frame::Picture picture = studio.render(model, settings), lit = without(studio, model, settings);
  CHECK(litShare(picture, lit, 1, 0.6) == 0);  // moved by 1 m: y in [0.5, 1.5]
  CHECK(litShare(picture, lit, 1, 1) == 0);
  CHECK(litShare(picture, lit, 1, -0.2) == Approx(1));
}

TEST_CASE("Horizons: beside a long wall the sky is hidden as its height says", "[gl]") {
  test::Studio studio;
  constexpr double height = 0.3;
  constexpr float albedo = 0.05f;
  GltfBuilder builder = emptyScene();
  test::addOrthographicCamera(builder, 2, 2);
  const int grey = builder.append("materials", test::material({1, 1, 1, 1}));
  addMeshNode(builder, addQuad(builder, {-2, -2}, {2, 2}), grey);
  addMeshNode(builder, addBox(builder, {0.2f, 2, static_cast<float>(height / 2)}, false), grey, at(0, 0, height / 2));
  io::LoadedModel model = test::loadBuilt(builder);
  lambert(model.model.materials[0], albedo);
  const PictureSettings settings = screenSettings(256, "builtin:white");
  const frame::Picture picture = studio.render(model, settings), lit = without(studio, model, settings);
  CHECK(passed(picture, "horizons"));
  CHECK(picture.statistics.frame.passes.front() == "horizons");
  // The wall's edge lies between two of eight steps, and what is seen of it behind is less steep: never too dark.
  for (const double d : {0.08, 0.15, 0.3}) {
    const double share = 0.5 * (1 + d / std::hypot(d, height));
    const double expected = share * optics::interreflection(share, glm::dvec3(albedo)).x;
    INFO("at " << d << " m, where " << expected << " is right");
    for (const double side : {1.0, -1.0}) {
      const double found = litShare(picture, lit, side * (0.2 + d), 0);
      CHECK(found > expected - 0.01);
      CHECK(found < expected + 0.08);
    }
  }
  // The wall's top, and the floor farther away than horizons are looked for, see all of the sky.
  CHECK(litShare(picture, lit, 0, 0) == Approx(1).margin(2e-3));
  CHECK(litShare(picture, lit, 1.6, 0) == Approx(1).margin(2e-3));
}

TEST_CASE("Horizons: thin things and edges of the picture hide nothing of themselves", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  test::addOrthographicCamera(builder, 2, 2);
  const int white = builder.append("materials", test::material({1, 1, 1, 1}));
  addMeshNode(builder, addQuad(builder, {-2, -2}, {1, 2}), white);  // to the picture's edges
  for (int i = 0; i < 6; ++i)                                       // lines half as wide as a pixel and wider
    addMeshNode(builder, addQuad(builder, {0, -2}, {0.01f + 0.01f * static_cast<float>(i), 2}), white,
                at(1.2 + 0.12 * i, 0, 0));
  const io::LoadedModel model = test::loadBuilt(builder);
  const PictureSettings settings = screenSettings(128, "builtin:white");
  const frame::Picture picture = studio.render(model, settings), lit = without(studio, model, settings);
  double darkest = 1;
  for (size_t i = 0; i < lit.radiance.pixels.size(); ++i)
    if (lit.radiance.pixels[i].x > 0)
      darkest = std::min(darkest, double(picture.radiance.pixels[i].x) / double(lit.radiance.pixels[i].x));
  CHECK(darkest > 0.995);
}

TEST_CASE("Screen space: nothing of it is made where there is nothing to know", "[gl]") {
  test::Studio studio;
  PictureSettings settings = screenSettings(32, "builtin:white");
  // A convex body alone.
  GltfBuilder ball = emptyScene();
  test::addOrthographicCamera(ball, 2, 2);
  addMeshNode(ball, test::addSphere(ball, 1), ball.append("materials", test::material({1, 1, 1, 1})));
  const io::LoadedModel alone = test::loadBuilt(ball);
  const frame::Picture picture = studio.render(alone, settings);
  CHECK(picture.statistics.visibility.method == "none");
  CHECK(picture.statistics.visibility.why == "a convex body, alone");
  CHECK_FALSE(passed(picture, "horizons"));
  CHECK(picture.display.data == without(studio, alone, settings).display.data);
  // Nothing is lit.
  GltfBuilder flat = emptyScene();
  test::addOrthographicCamera(flat, 2, 2);
  const int unlit = flat.append("materials", test::unlit({1, 1, 1, 1}));
  for (const double z : {0.0, 1.0}) addMeshNode(flat, addQuad(flat, {-1, -1}, {1, 1}), unlit, at(0, 0, z));
  const frame::Picture dark = studio.render(test::loadBuilt(flat), settings);
  CHECK(dark.statistics.visibility.method == "none");
  CHECK(dark.statistics.visibility.why == "nothing is lit");
  // A channel shows no light.
  settings.look.channel = "normal";
  CHECK(studio.render(plateInLight({}), settings).statistics.visibility.method == "none");
}
