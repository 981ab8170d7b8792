#include <catch2/catch.hpp>

#include "compare/compare.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::Viewer;
using view::Beside;

namespace {

io::Pixels secondDisplay(const Viewer& viewer) { return frame::readDisplay(viewer.viewport.second.targets, false); }

io::Pixels bothDisplay(const Viewer& viewer) {
  io::Pixels out = viewer.display();
  const std::vector<glm::dvec4> texels = test::texelsOf(viewer.viewport.second.pair.picture);
  for (size_t i = 0; i < out.data.size(); ++i)
    out.data[i] = static_cast<uint8_t>(std::lround(255 * texels[i / 3][static_cast<int>(i % 3)]));
  return out;
}

}  // namespace

TEST_CASE("a second model stands beside the first, under the same light and through the same camera", "[gl]") {
  Viewer viewer;
  viewer.state.settings.sources.environment = "builtin:studio";
  viewer.state.settings.quality.samples = 64;
  viewer.load("builtin:spheres");
  viewer.converge();
  const io::Pixels converged = viewer.display();
  CHECK_FALSE(viewer.viewport.second.scene);

  // The same once more: no pixel differs.
  viewer.state.secondModel = "builtin:spheres";
  viewer.settle();
  viewer.converge();
  REQUIRE(viewer.viewport.second.pair.shown);
  CHECK(viewer.state.shown.second == "builtin:spheres");
  CHECK((secondDisplay(viewer).data == viewer.display().data));
  CHECK(viewer.state.shown.comparison.value().largest == 0);

  // Another one is what a window of its own shows, whatever changes.
  viewer.state.secondModel = "builtin:tutorial";
  viewer.settle();
  viewer.converge();
  for (const bool turned : {false, true}) {
    if (turned) {
      viewer.state.camera.theta += 0.4;
      viewer.state.settings.sources.environment = "builtin:sky";
      viewer.state.settings.display.exposureStops = 1;
      viewer.settle();
      viewer.converge();
    }
    INFO(turned);
    REQUIRE(viewer.viewport.second.pair.shown);
    Viewer alone;
    alone.state.settings.sources.environment = viewer.state.settings.sources.environment;
    alone.state.settings.display.exposureStops = viewer.state.settings.display.exposureStops;
    alone.state.settings.quality.samples = 4;
    alone.state.settings.quality.visibility = frame::Visibility::screen;
    alone.load("builtin:tutorial");
    alone.state.camera = viewer.state.camera;
    alone.converge();
    CHECK((secondDisplay(viewer).data == alone.display().data));
    const io::Pixels first = viewer.display(), second = secondDisplay(viewer), both = bothDisplay(viewer);
    size_t wrong = 0;
    for (size_t i = 0; i < both.data.size(); ++i) {
      const bool left = i / 3 % static_cast<size_t>(first.width) < static_cast<size_t>(first.width) / 2;
      wrong += both.data[i] != (left ? first : second).data[i];
    }
    CHECK(wrong == 0);
    CHECK(viewer.state.shown.comparison.value().rms > 10);
    for (int i = 0; i < 500 && !viewer.state.shown.flip; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      view::followFlip(viewer.viewport, viewer.state);
    }
    const auto apart =
        compare::comparePictures(compare::linearPicture(frame::readDisplay(viewer.viewport.targets, true)),
                                 compare::linearPicture(frame::readDisplay(viewer.viewport.second.targets, true)));
    CHECK(viewer.state.shown.flip.value() == apart->flipMean);
    CHECK(viewer.state.shown.flip.value() > 0.05);
  }

  viewer.state.second.how = Beside::difference;
  viewer.state.second.scale = 1;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  const io::Pixels first = viewer.display(), second = secondDisplay(viewer), both = bothDisplay(viewer);
  size_t wrong = 0;
  for (size_t i = 0; i < both.data.size(); ++i)
    wrong += std::abs(std::abs(int{first.data[i]} - int{second.data[i]}) - int{both.data[i]}) > 1;
  CHECK(wrong == 0);

  // Without it everything is as before.
  viewer.state.secondModel.clear();
  viewer.state.camera.theta -= 0.4;
  viewer.state.settings.sources.environment = "builtin:studio";
  viewer.state.settings.display.exposureStops = 0;
  viewer.settle();
  viewer.converge();
  CHECK_FALSE(viewer.viewport.second.pair.shown);
  CHECK_FALSE(viewer.viewport.second.scene);
  CHECK((viewer.display().data == converged.data));
}

TEST_CASE("a second model that cannot be read is told, and the first one stays", "[gl]") {
  Viewer viewer;
  viewer.state.settings.sources.environment = "builtin:studio";
  viewer.load("builtin:spheres");
  viewer.converge();
  const io::Pixels alone = viewer.display();
  viewer.state.secondModel = "nowhere.glb";
  viewer.settle();
  viewer.converge();
  CHECK(viewer.state.secondModel.empty());
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find("nowhere.glb") != std::string::npos);
  CHECK((viewer.display().data == alone.data));

  // Another first model leaves the second where it is.
  viewer.state.secondModel = "builtin:spheres";
  viewer.settle();
  viewer.load("builtin:tutorial");
  viewer.converge();
  REQUIRE(viewer.viewport.second.pair.shown);
  CHECK(viewer.state.shown.model == "builtin:tutorial");
  CHECK(viewer.state.shown.second == "builtin:spheres");
  CHECK(viewer.state.shown.comparison.value().largest > 10);
}
