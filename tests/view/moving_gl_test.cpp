#include <catch2/catch.hpp>

#include "support/picture.hpp"
#include "support/temporary_folder.hpp"
#include "view/copied_command.hpp"
#include "view/moving.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

// Turns until the whole cheap picture is there.
int finishMoving(test::Viewer& viewer) {
  int turns = 0;
  for (; viewer.viewport.moving.underWay && turns < 10'000; ++turns) view::drawViewport(viewer.viewport, viewer.state);
  REQUIRE_FALSE(viewer.viewport.moving.underWay);
  return turns;
}

}  // namespace

TEST_CASE("moving: as much of the picture as there is time for") {
  CHECK(view::reduction(-1, 1'000'000, 40) == 16);
  CHECK(view::reduction(40, 1'000'000, 40) == 1);
  CHECK(view::reduction(41, 1'000'000, 40) == 2);
  CHECK(view::reduction(640, 1'000'000, 40) == 4);
  CHECK(view::reduction(1e9, 1'000'000, 40) == 16);
}

TEST_CASE("moving: where it takes long a smaller picture comes first, the whole one in slices, the same to the bit",
          "[gl]") {
  test::Viewer viewer;
  viewer.state.settings.frame.width = 160;
  viewer.state.settings.frame.height = 120;
  viewer.state.settings.quality.samples = GENERATE(4, 16);
  viewer.load("builtin:poster");
  view::Moving& moving = viewer.viewport.moving;
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(moving.showsSmall);
  const io::Pixels whole = viewer.display();

  moving.turnMs = 1e-3;
  moving.pixelNs = -1;
  viewer.state.camera.theta += 10;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(moving.showsSmall);
  CHECK(moving.underWay);
  CHECK(view::atWork(viewer.viewport, viewer.state));
  CHECK_FALSE(view::refining(viewer.viewport, viewer.state));
  CHECK(moving.small.width == 10);
  CHECK(moving.small.height == 8);
  const io::Pixels small = frame::readDisplay(moving.small, false);
  CHECK(std::ranges::count_if(small.data, [](uint8_t v) { return v > 0; }) > 100);

  // Any change begins anew.
  view::drawViewport(viewer.viewport, viewer.state);
  viewer.state.camera.theta -= 10;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(finishMoving(viewer) >= 120 / 8);
  CHECK_FALSE(moving.showsSmall);
  CHECK((viewer.display().data == whole.data));
  CHECK(viewer.state.shown.statistics.frame.draws > 0);
  CHECK(viewer.state.shown.statistics.frame.passes.back() == "display");

  // A screenshot does not wait for the end of what moves.
  viewer.state.screenshotAsked = true;
  viewer.state.camera.theta += 1;
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(moving.underWay);
  viewer.state.screenshotAsked = false;
  viewer.state.camera.theta -= 1;
  view::drawViewport(viewer.viewport, viewer.state);
  finishMoving(viewer);

  // It goes on from there.
  viewer.converge();
  CHECK(viewer.state.refinement.shown == (viewer.state.settings.quality.samples == 16 ? 16 : 0));
}

TEST_CASE("moving: slices of a large picture of few samples are the command's", "[gl]") {
  const test::TemporaryFolder folder;
  test::GltfBuilder scene = test::emptyScene();
  scene.append("materials", test::material({0.8f, 0.3f, 0.1f, 1}, 0, 0.3));
  nlohmann::json veil = test::material({0.1f, 0.4f, 0.9f, 0.5f}, 0, 0.4);
  veil["alphaMode"] = "BLEND";
  scene.append("materials", veil);
  nlohmann::json glass = test::material({1, 1, 1, 1}, 0, 0.2);
  const bool transmits = GENERATE(false, true);
  if (transmits) glass["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}};
  scene.append("materials", glass);
  for (int i = 0; i < 3; ++i) test::addMeshNode(scene, test::addSphere(scene, 0.6), i, test::at(i - 1, 0, i));
  test::Viewer viewer;
  viewer.viewport.moving.turnMs = 1e-3;
  viewer.state.settings.frame.width = 640;
  viewer.state.settings.frame.height = 480;
  viewer.state.settings.quality.samples = 4;
  viewer.state.settings.sources.environment = "builtin:sky";
  viewer.load(folder.write("balls.glb", scene.glb()));
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK(viewer.viewport.moving.showsSmall);
  CHECK(finishMoving(viewer) >= (transmits ? 1 : 4));  // what shines through is drawn whole
  test::checkCopiedCommand(viewer, folder);
}
