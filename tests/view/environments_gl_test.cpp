#include <catch2/catch.hpp>

#include "ibl/cache.hpp"
#include "support/picture.hpp"
#include "support/temporary_folder.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::Viewer;

namespace {

io::Pixels headless(const std::string& source, const frame::PictureSettings& settings) {
  test::Studio studio;
  return studio.render(test::loadBuiltin(source), frame::restingSettings(settings)).display;
}

view::EnvironmentSlot& shown(Viewer& viewer) { return *viewer.viewport.environments.shown; }

// Turns of the loop until the tables are final.
int sharpened(Viewer& viewer) {
  int turns = 0;
  for (; shown(viewer).preview && turns < 1000; ++turns) {
    view::drawViewport(viewer.viewport, viewer.state);
    glFinish();
  }
  REQUIRE_FALSE(shown(viewer).preview);
  return turns;
}

}  // namespace

TEST_CASE("environments: shown at once with coarse tables, then as facet render shows it", "[gl]") {
  Viewer viewer;
  viewer.viewport.environments.immediateMs = 0;
  viewer.load("builtin:spheres");
  sharpened(viewer);
  const io::Pixels studio = viewer.display();
  CHECK((studio.data == headless("builtin:spheres", viewer.state.settings).data));

  viewer.state.settings.sources.environment = "builtin:sky";
  viewer.settle();
  CHECK(viewer.state.shown.environment == "builtin:sky");
  CHECK(shown(viewer).preview);
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(view::refinementText(viewer.state.refinement) == "the light is a preview and sharpens");
  const io::Pixels coarse = viewer.display();
  CHECK((coarse.data != studio.data));
  CHECK(sharpened(viewer) > 5);
  CHECK(view::refinementText(viewer.state.refinement).empty());
  const io::Pixels final = viewer.display();
  CHECK((final.data != coarse.data));
  CHECK((final.data == headless("builtin:spheres", viewer.state.settings).data));
  CHECK_FALSE(view::atWork(viewer.viewport, viewer.state));

  // The one before is still there: nothing to be made.
  viewer.state.settings.sources.environment = "builtin:studio";
  viewer.settle();
  CHECK_FALSE(shown(viewer).preview);
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK((viewer.display().data == studio.data));
}

TEST_CASE("environments: another choice cancels what sharpens", "[gl]") {
  Viewer viewer;
  viewer.viewport.environments.immediateMs = 0;
  viewer.load("builtin:spheres");
  view::drawViewport(viewer.viewport, viewer.state);
  glFinish();
  view::drawViewport(viewer.viewport, viewer.state);
  view::EnvironmentSlot& first = shown(viewer);
  REQUIRE(first.sharpening);
  CHECK(first.sharpening->work.next > 0);
  viewer.state.settings.sources.environment = "builtin:sky";
  viewer.settle();
  CHECK_FALSE(first.sharpening);
  CHECK_FALSE(first.preview);
  CHECK_FALSE(first.tables.irradiance);
  CHECK_FALSE(first.tables.roughLayers);
  sharpened(viewer);
  viewer.state.settings.sources.environment = "builtin:studio";
  viewer.settle();
  CHECK(shown(viewer).preview);
  sharpened(viewer);
  CHECK((viewer.display().data == headless("builtin:spheres", viewer.state.settings).data));
}

TEST_CASE("environments: final tables are stored and come back at once", "[gl]") {
  const test::TemporaryFolder folder;
  io::Pixels first;
  for (const bool cached : {false, true}) {
    Viewer viewer;
    viewer.viewport.environments.immediateMs = 0;
    viewer.viewport.tableCache = {{folder.path(), 64 << 20}, "build"};
    viewer.load("builtin:spheres");
    CHECK(shown(viewer).preview == !cached);
    sharpened(viewer);
    for (int i = 0; view::atWork(viewer.viewport, viewer.state) && i < 1000; ++i)
      view::drawViewport(viewer.viewport, viewer.state);
    CHECK_FALSE(view::atWork(viewer.viewport, viewer.state));
    view::drawViewport(viewer.viewport, viewer.state);
    if (cached)
      CHECK((viewer.display().data == first.data));
    else
      first = viewer.display();
  }
}

TEST_CASE("environments: with time enough there is no preview, the picture at rest waits for the final light", "[gl]") {
  Viewer viewer;
  viewer.viewport.environments.immediateMs = 1e9;
  viewer.load("builtin:spheres");
  CHECK_FALSE(shown(viewer).preview);
  viewer.viewport.environments.immediateMs = 0;
  viewer.state.settings.quality.samples = 8;
  viewer.state.settings.sources.environment = "builtin:sky";
  viewer.settle();
  CHECK(shown(viewer).preview);
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(view::refining(viewer.viewport, viewer.state));
  CHECK(view::atWork(viewer.viewport, viewer.state));
  sharpened(viewer);
  CHECK(shown(viewer).tables.rest);
  viewer.converge();
  CHECK((viewer.display().data == headless("builtin:spheres", viewer.state.settings).data));
}

TEST_CASE("environments: those that are not shown stay within a bound", "[gl]") {
  view::Environments environments;
  const auto add = [&](const std::string& name, int width) {
    auto slot = std::make_unique<view::EnvironmentSlot>();
    slot->source = name;
    auto map = std::make_shared<scene::Environment>();
    map->radiance.resize(static_cast<size_t>(width));
    slot->environment = map;
    environments.slots.push_back(std::move(slot));
    view::showEnvironment(environments, environments.slots.back().get());
  };
  constexpr int mebibyte = (1 << 20) / int(sizeof(glm::vec3));
  for (const char* name : {"a", "b", "c", "d"}) add(name, 100 * mebibyte);
  CHECK(environments.slots.size() == 3);  // the shown one and 200 MB
  CHECK_FALSE(view::findEnvironment(environments, "a"));
  CHECK(view::findEnvironment(environments, "b"));
  add("large", 1000 * mebibyte / 2);
  CHECK(environments.shown->source == "large");
  CHECK(environments.slots.size() == 3);
  add("small", 1);
  CHECK(environments.slots.size() == 1);
}
