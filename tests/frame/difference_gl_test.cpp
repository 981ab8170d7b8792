#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstring>

#include "frame/difference.hpp"
#include "frame/left_out.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using frame::Visibility;
using test::at, test::emptyScene;
using test::GltfBuilder;

namespace {

PictureSettings withVisibility(PictureSettings settings, Visibility visibility, int samples) {
  settings.quality.visibility = visibility;
  settings.quality.samples = samples;
  return settings;
}

PictureSettings cameraSettings(int size, const char* environment) {
  PictureSettings settings = test::bareSettings(size, size);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  return settings;
}

// Of what a screen shows, 1 / 255.
double displayRms(const frame::Picture& a, const frame::Picture& b) {
  double squares = 0;
  REQUIRE(a.display.data.size() == b.display.data.size());
  for (size_t i = 0; i < a.display.data.size(); ++i)
    squares += std::pow(double(a.display.data[i]) - double(b.display.data[i]), 2);
  return std::sqrt(squares / double(a.display.data.size()));
}

bool sameRadiance(const frame::Picture& a, const frame::Picture& b) {
  return a.radiance.pixels.size() == b.radiance.pixels.size() &&
         std::memcmp(a.radiance.pixels.data(), b.radiance.pixels.data(),
                     a.radiance.pixels.size() * sizeof(glm::vec4)) == 0;
}

void addLight(io::LoadedModel& model, const glm::dvec3& position, float intensity) {
  scene::Light lamp;
  lamp.intensity = intensity;
  model.model.lights.push_back(lamp);
  scene::Node node;
  node.light = static_cast<int>(model.model.lights.size()) - 1, node.translation = position;
  model.model.nodes.push_back(node);
  model.model.scenes[0].nodes.push_back(static_cast<int>(model.model.nodes.size()) - 1);
}

// A small square before a large one, seen from the front; the small one of another material.
io::LoadedModel squares(const nlohmann::json& front) {
  GltfBuilder builder = emptyScene();
  const int grey = builder.append("materials", test::material({0.5, 0.5, 0.5, 1}, 0.6));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), grey);
  test::addMeshNode(builder, test::addQuad(builder, {-0.2, -0.2}, {0.2, 0.2}), builder.append("materials", front),
                    at(0, 0, 0.5));
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  for (scene::Material& m : model.model.materials) m.metallicFactor = 0;
  return model;
}

}  // namespace

TEST_CASE("Visibility by rays: where nothing is in the way the picture is that of the tables, to the byte", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  for (const double x : {-0.6, 0.6})  // they see nothing of each other
    test::addMeshNode(builder, test::addQuad(builder, {-0.5, -0.5}, {0.5, 0.5}),
                      builder.append("materials", test::material({0.8, 0.5, x + 0.6, 1}, 0.3)), at(x, 0, 0));
  test::addOrthographicCamera(builder, 1.4, 1.4);
  const io::LoadedModel model = test::loadBuilt(builder);
  PictureSettings settings = cameraSettings(24, "builtin:sky");
  settings.look.lights = frame::Lights::demo;
  settings.look.models.imageLight = optics::usualLookUp;
  const frame::Picture drawn = studio.render(model, withVisibility(settings, Visibility::none, 8));
  const frame::Picture corrected = studio.render(model, withVisibility(settings, Visibility::rays, 8));
  CHECK(corrected.statistics.frame.rays > 24 * 24);
  CHECK(corrected.statistics.visibility.method == "rays");
  CHECK(sameRadiance(drawn, corrected));
}

TEST_CASE("Visibility by rays: few samples are nearer to converged paths than without, on each kind of light", "[gl]") {
  test::Studio studio;
  struct Case {
    const char* name;
    io::LoadedModel model;
    PictureSettings settings;
    double least;  // of the error without visibility, over that with
  };
  PictureSettings poster = test::bareSettings(160, 160);
  poster.sources.environment = "builtin:studio";
  PictureSettings sky = poster;
  sky.sources.environment = "builtin:sky";
  nlohmann::json glow = test::material({0, 0, 0, 1});
  glow["emissiveFactor"] = {1, 0.4, 0.1};
  nlohmann::json glass = test::material({1, 1, 1, 1}, 0.1);
  glass["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 1;
  io::LoadedModel lamp = squares(test::material({0.5, 0.5, 0.5, 1}, 0.8));
  addLight(lamp, {0, 0, 1}, 4);
  const Case cases[] = {
      {"poster", test::loadBuiltin("builtin:poster"), poster, 1.35},
      {"poster under a sun", test::loadBuiltin("builtin:poster"), sky, 1.4},
      {"a lamp's shadow", lamp, cameraSettings(40, "none"), 4},
      {"what glows", squares(glow), cameraSettings(40, "builtin:white"), 1.7},
      {"before glass", squares(glass), cameraSettings(40, "builtin:studio"), 0.97},
  };
  for (const Case& c : cases) {
    INFO(c.name);
    PictureSettings paths = c.settings;
    paths.quality.transport = frame::Transport::paths;
    paths.quality.samples = 256;
    const frame::Picture truth = studio.render(c.model, paths);
    const double without = displayRms(studio.render(c.model, withVisibility(c.settings, Visibility::none, 4)), truth);
    const double with = displayRms(studio.render(c.model, withVisibility(c.settings, Visibility::rays, 4)), truth);
    CAPTURE(without, with);
    CHECK(with * c.least < without);
  }
}

TEST_CASE("Visibility by rays: a lamp's shadow is black, and beside it all is as it was drawn", "[gl]") {
  test::Studio studio;
  io::LoadedModel model = squares(test::material({0, 0, 0, 1}, 1));
  model.model.materials[1].specularWeight = 0;  // returns nothing
  addLight(model, {0, 0, 1}, 4);
  PictureSettings settings = cameraSettings(80, "none");
  settings.look.models.imageLight = optics::usualLookUp;
  const frame::Picture drawn = studio.render(model, withVisibility(settings, Visibility::none, 16));
  const frame::Picture corrected = studio.render(model, withVisibility(settings, Visibility::rays, 16));
  const auto red = [](const frame::Picture& picture, int x, int y) { return test::pixel(picture.radiance, x, y).x; };
  for (const int x : {28, 29, 51}) {  // between the square (32 to 48) and its shadow's edge (24 to 56)
    CHECK(red(drawn, x, 40) > 0.1f);
    CHECK(red(corrected, x, 40) < 1e-3f);
  }
  for (const glm::ivec2 lit : {glm::ivec2(10, 40), glm::ivec2(68, 6), glm::ivec2(8, 18)})
    CHECK(red(corrected, lit.x, lit.y) == red(drawn, lit.x, lit.y));
}

TEST_CASE("Visibility by rays: white bodies side by side in a white furnace stay white", "[gl]") {
  test::Studio studio;
  GltfBuilder builder = emptyScene();
  nlohmann::json white = test::material({1, 1, 1, 1}, 0.5);
  const int metal = builder.append("materials", white);
  for (const double x : {-0.55, 0.55})
    test::addMeshNode(builder, test::addSphere(builder, 0.5, 48, 96), metal, at(x, 0, 0));
  test::addOrthographicCamera(builder, 0.5, 0.3);  // the gap
  io::LoadedModel model = test::loadBuilt(builder);
  model.model.materials[0].metallicFactor = 1;
  const frame::Picture corrected =
      studio.render(model, withVisibility(cameraSettings(32, "builtin:white"), Visibility::rays, 16));
  double sum = 0, count = 0;
  for (const glm::vec4& p : corrected.radiance.pixels)
    if (p.w >= 1) sum += double(p.x), ++count;
  REQUIRE(count > 100);
  CHECK(sum / count == Approx(1).epsilon(0.015));
}

TEST_CASE("Visibility: what the automatic choice takes, and what it leaves out", "[gl]") {
  test::Studio studio;
  const auto render = [&](const io::LoadedModel& model, PictureSettings settings, Visibility visibility, int samples) {
    return studio.render(model, withVisibility(std::move(settings), visibility, samples));
  };
  const auto chosen = [](const frame::Picture& picture) {
    return picture.statistics.visibility.method + ": " + picture.statistics.visibility.why;
  };
  PictureSettings settings = test::bareSettings(12, 12);
  settings.sources.environment = "builtin:studio";
  const io::LoadedModel spheres = test::loadBuiltin("builtin:spheres");
  CHECK(chosen(render(spheres, settings, Visibility::automatic, 4)) == "rays: few samples");
  CHECK(chosen(render(spheres, settings, Visibility::automatic, 17)) == "paths: more than 16 samples");
  CHECK(chosen(render(spheres, settings, Visibility::none, 4)) == "none: asked for");
  PictureSettings measured = settings;
  measured.sources.brdf = "builtin:plastic-0.2";
  CHECK(chosen(render(spheres, measured, Visibility::automatic, 4)) ==
        "none: few samples of a measured BRDF are noise enough");
  CHECK(chosen(render(spheres, measured, Visibility::rays, 4)) == "rays: asked for");
  PictureSettings exact = settings;
  exact.quality.maxError = 0.05;
  CHECK(chosen(render(spheres, exact, Visibility::automatic, 64)) == "paths: an error is to be kept to");
  PictureSettings channel = settings;
  channel.look.channel = "normal";
  CHECK(chosen(render(spheres, channel, Visibility::automatic, 4)) == "none: a channel shows no light");

  const auto leaves = [&](Visibility visibility, int samples, const std::string& what) {
    const std::vector<std::string> out =
        frame::leftOut(spheres.model, render(spheres, settings, visibility, samples).statistics);
    return std::ranges::find(out, what) != out.end();
  };
  CHECK(leaves(Visibility::none, 4, "no trees for rays: asked for"));
  CHECK_FALSE(leaves(Visibility::automatic, 4, "no draws, no vertex buffers: rays meet everything"));
  CHECK(leaves(Visibility::automatic, 17, "no draws, no vertex buffers: rays meet everything"));

  // A convex body alone: no trees, and the bytes of none.
  GltfBuilder builder = emptyScene();
  test::addMeshNode(builder, test::addSphere(builder, 0.5, 12, 24),
                    builder.append("materials", test::material({0.8, 0.5, 0.3, 1}, 0.4)));
  const io::LoadedModel ball = test::loadBuilt(builder);
  for (const int samples : {4, 20}) {
    const frame::Picture automatic = render(ball, settings, Visibility::automatic, samples);
    CHECK(chosen(automatic) == "none: a convex body, alone");
    CHECK_FALSE(automatic.statistics.traced);
    CHECK(sameRadiance(automatic, render(ball, settings, Visibility::none, samples)));
  }
  CHECK(chosen(render(ball, settings, Visibility::rays, 4)) == "rays: asked for");

  GltfBuilder dark = emptyScene();
  for (const double x : {-0.5, 0.5})
    test::addMeshNode(dark, test::addQuad(dark, {-1, -1}, {1, 1}), dark.append("materials", test::unlit({1, 1, 0, 1})),
                      at(x, 0, 0));
  const frame::Picture unlit = render(test::loadBuilt(dark), settings, Visibility::rays, 4);
  CHECK(chosen(unlit) == "none: nothing is lit");
  CHECK_FALSE(unlit.statistics.traced);
}

TEST_CASE("Visibility by rays: small pictures have a path for each sample, larger ones for some, each pixel has one") {
  CHECK(frame::pathsOfPixel(4, 384 * 384) == 4);
  CHECK(frame::pathsOfPixel(4, 450'000) == 4);
  CHECK(frame::pathsOfPixel(4, 1024 * 640) == 2);
  CHECK(frame::pathsOfPixel(4, 2048 * 2048) == 1);
  CHECK(frame::pathsOfPixel(16, 1024 * 640) == 8);
  CHECK(frame::pathsOfPixel(1, int64_t{1} << 40) == 1);
}
