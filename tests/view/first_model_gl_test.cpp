#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"
#include "view/textured_triangle.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::texturedTriangle;
using test::Viewer;

TEST_CASE("viewport: what the command line names is the first model's alone", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string red = folder.write("red.glb", texturedTriangle({255, 0, 0}));
  const std::string blue = folder.write("blue.glb", texturedTriangle({0, 0, 255}));
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.viewpoint.orbit = frame::Orbit{33, 44, 5};
  settings.viewpoint.target = glm::dvec3(1, 2, 3);
  settings.viewpoint.fovYDeg = 30;
  settings.placement.scene = 0;

  SECTION("shown") {
    viewer.load(red);
    const scene::OrbitCamera& camera = viewer.state.camera;
    CHECK(camera.theta == 33);
    CHECK(camera.phi == 44);
    CHECK(camera.radius == 5);
    CHECK(camera.target == glm::dvec3(1, 2, 3));
    CHECK(camera.fovY == Approx(30));
    CHECK(viewer.state.startCamera == viewer.state.camera);
    CHECK_FALSE(viewer.state.modelFailed);
    return;
  }
  SECTION("another model is opened before it has been read") {
    view::startModel(viewer.loader, red, view::Opening::first);
    view::startModel(viewer.loader, blue);
    viewer.settle();
  }
  SECTION("another model is opened while it comes up") {
    view::startModel(viewer.loader, red, view::Opening::first);
    view::takeModel(viewer.viewport, viewer.state, *viewer.loader.model.take(true));
    REQUIRE(viewer.viewport.next);
    view::startModel(viewer.loader, blue);
    view::takeModel(viewer.viewport, viewer.state, *viewer.loader.model.take(true));
    viewer.settle();
  }
  SECTION("it cannot be read") {
    viewer.load(folder.write("cut.glb", std::string("glTF half a fi")));
    CHECK_FALSE(viewer.viewport.scene);
    CHECK(viewer.state.modelFailed);
    CHECK(viewer.state.status.isError);
    CHECK(viewer.state.status.text.find("cut.glb") != std::string::npos);
    view::startModel(viewer.loader, blue);
    viewer.settle();
  }
  CHECK(viewer.state.shown.model == blue);
  CHECK(viewer.state.camera.theta == 0);  // framed, with the field of view that was asked for
  CHECK(viewer.state.camera.fovY == Approx(30));
  CHECK(viewer.state.camera.target.x == Approx(0.5));
  CHECK(viewer.state.startCamera == viewer.state.camera);
  CHECK_FALSE(settings.viewpoint.orbit);
}

TEST_CASE("viewport: a new model's images are asked for while those of another are still decoded", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string red = folder.write("red.glb", texturedTriangle({255, 0, 0}));
  const std::string blue = folder.write("blue.glb", texturedTriangle({0, 0, 255}));
  Viewer viewer;
  view::startModel(viewer.loader, red, view::Opening::first);
  view::takeModel(viewer.viewport, viewer.state, *viewer.loader.model.take(true));
  const auto ask = [&] {  // the loader's images are never taken
    for (int turn = 0; turn < 100; ++turn) view::bringUp(viewer.viewport, viewer.state, viewer.loader);
    return viewer.loader.imagesAsked;
  };
  CHECK(ask().model == viewer.viewport.next->loaded);
  view::startModel(viewer.loader, blue);
  view::takeModel(viewer.viewport, viewer.state, *viewer.loader.model.take(true));
  CHECK(ask().model == viewer.viewport.next->loaded);
  CHECK(ask().wanted == std::vector<bool>{true});
  viewer.settle();
  CHECK(viewer.state.shown.model == blue);
}

TEST_CASE("viewport: a first model without what the command line names of it is told and not shown", "[gl]") {
  struct Row {
    void (*set)(frame::PictureSettings&);
    const char* told;
  };
  const Row row = GENERATE(values<Row>({
      {[](frame::PictureSettings& s) { s.placement.scene = 3; }, "there is no scene 3"},
      {[](frame::PictureSettings& s) { s.placement.animation = "walk"; }, "walk"},
      {[](frame::PictureSettings& s) { s.look.variant = "sea"; }, "the file has no material variant 'sea'"},
      {[](frame::PictureSettings& s) { s.viewpoint.camera = "door"; }, "door"},
  }));
  const test::TemporaryFolder folder;
  const std::string red = folder.write("red.glb", texturedTriangle({255, 0, 0}));
  Viewer viewer;
  row.set(viewer.state.settings);
  viewer.load(red);
  INFO(viewer.state.status.text);
  CHECK_FALSE(viewer.viewport.scene);
  CHECK(viewer.state.modelFailed);
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find(row.told) != std::string::npos);
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
  view::startModel(viewer.loader, red);  // chosen in the browser
  viewer.settle();
  CHECK(viewer.state.shown.model == red);
}

TEST_CASE("viewport: an environment that cannot be read at the start leaves the choice to the model", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.state.settings.sources.environment = folder.write("cut.hdr", std::string("#?RADIANCE"));
  viewer.load("builtin:furnace");
  CHECK(viewer.state.shown.model == "builtin:furnace");
  CHECK(viewer.state.shown.environment == "builtin:white");
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find("cut.hdr") != std::string::npos);
}

TEST_CASE("viewport: a model's warnings are told, each whole, and no longer counted once another is shown", "[gl]") {
  const test::TemporaryFolder folder;
  test::GltfBuilder odd = test::triangle();
  odd.json["nodes"][0]["rotation"] = {0, 0, 0, 0};
  odd.append("nodes", {{"rotation", {0, 0, 0, 0}}});
  test::Viewer viewer;
  viewer.load(folder.write("odd.glb", odd.glb()));
  const std::vector<std::string> warnings = viewer.state.shown.warnings;
  REQUIRE_FALSE(warnings.empty());
  CHECK_FALSE(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find(warnings.front()) != std::string::npos);
  REQUIRE(viewer.state.messages.size() == warnings.size());
  CHECK(viewer.state.messages.back().text == warnings.back());
  CHECK_FALSE(view::messageCount(viewer.state.messages).empty());
  viewer.load("builtin:spheres");
  CHECK(viewer.state.messages.size() == warnings.size());
  CHECK(view::messageCount(viewer.state.messages).empty());
}

TEST_CASE("viewport: on wish, a model's first animation plays as soon as it is shown", "[gl]") {
  const test::TemporaryFolder folder;
  test::GltfBuilder moving = test::triangle();
  const std::vector<float> times = {0, 1}, heights = {0, 0, 0, 0, 1, 0};
  const int input = moving.add(times, test::floatType, "SCALAR"), output = moving.add(heights, test::floatType, "VEC3");
  moving.append("animations", {{"name", "rise"},
                               {"samplers", {{{"input", input}, {"output", output}}}},
                               {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  const std::string file = folder.write("moving.glb", moving.glb());
  for (const bool wish : {false, true}) {
    test::Viewer viewer;
    viewer.state.preferences.playOnOpening = wish;
    viewer.load(file);
    CHECK(viewer.state.playback.playing == wish);
    CHECK(viewer.state.settings.placement.animation == (wish ? "rise" : ""));
    viewer.load("builtin:spheres");
    CHECK_FALSE(viewer.state.playback.playing);
  }
}

TEST_CASE("viewport: a new model is framed beside the panels", "[gl]") {
  test::Viewer viewer;
  viewer.load("builtin:spheres");
  const double whole = viewer.state.camera.radius;
  viewer.state.coveredRight = 0.4 * viewer.state.settings.frame.width;
  viewer.load("builtin:poster");
  viewer.load("builtin:spheres");
  CHECK(viewer.state.camera.radius == Approx(whole / (0.3 * 64 / 48)));
  CHECK(viewer.state.camera == viewer.state.startCamera);
}
