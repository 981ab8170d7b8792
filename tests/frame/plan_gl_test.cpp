#include <catch2/catch.hpp>
#include <set>
#include <string>

#include "frame/plan.hpp"
#include "frame/session.hpp"
#include "support/gpu.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using frame::Progress;

namespace {

// A plan of the moving picture, as the window runs it, with everything at hand.
struct Planned {
  io::LoadedModel model = test::loadBuiltin("builtin:spheres");
  frame::LoadedScene scene = test::sceneOf(model);
  shading::ProgramStore programs = test::makeProgramStore();
  frame::Shelf shelf;
  Notes notes;
  frame::Supply supply = frame::supplyAtOnce(shelf, programs, notes);
  frame::Plan plan = {.moving = true};
  frame::Drawable shown;
  PictureSettings wish;

  Planned() {
    scene.source = "builtin:spheres";
    wish.frame.width = wish.frame.height = 16;
    wish.quality.visibility = frame::Visibility::none;
  }
  // What the steps did; empty where there was nothing to do.
  std::set<std::string> run() {
    std::set<std::string> did;
    for (;;) {
      const auto step = frame::advance(plan, scene, wish, shown.scene ? &shown : nullptr, supply, programs);
      REQUIRE(step);
      REQUIRE(step->progress != Progress::waiting);
      if (step->progress == Progress::nothing) return did;
      did.insert(step->did);
      if (step->progress != Progress::done) continue;
      shown = std::move(plan.next);
      plan.listed = false;
      return did;
    }
  }
};

}  // namespace

TEST_CASE("Plan: a wish that is fulfilled asks for nothing, another for what it changes", "[gl]") {
  Planned planned;
  CHECK(planned.run().contains("read environment"));
  CHECK(planned.shown.environment->tables.irradiance);
  CHECK_FALSE(planned.shown.environment->tables.rest);
  CHECK(planned.run().empty());

  planned.wish.display.exposureStops = 2;
  planned.wish.frame.environmentRotationDeg = 10;
  planned.wish.viewpoint.fovYDeg = 20;
  CHECK(planned.run().empty());

  planned.wish.look.channel = "normal";
  const std::set<std::string> channel = planned.run();
  CHECK(channel.contains("prepare"));
  CHECK_FALSE(channel.contains("read environment"));
  CHECK(planned.shown.list.features.channel == shading::channelIndex("normal"));
  planned.wish.look.channel.clear();
  planned.run();

  planned.wish.quality.samples = 64;  // at rest the environment is sampled: its lamps are found by then
  CHECK_FALSE(planned.run().empty());
  CHECK(planned.shown.environment->tables.rest);

  const frame::LoadedEnvironment* before = planned.shown.environment;
  planned.wish.sources.environment = "builtin:sky";
  CHECK(planned.run().contains("read environment"));
  CHECK(planned.shown.environment != before);
  CHECK(planned.shown.inputs.list.options.sun.has_value());

  planned.wish.sources.brdf = "builtin:plastic-0.2";
  CHECK(planned.run().contains("read BRDF"));
  REQUIRE(planned.shown.inputs.list.measured);
  planned.wish.look.brdfSamples = 7;  // the number is compiled into the program
  CHECK_FALSE(planned.run().empty());
  CHECK(planned.run().empty());
}

TEST_CASE("Plan: what is on its way is waited for, images while the environment is read", "[gl]") {
  Planned planned;
  const auto environment = planned.supply.environment;
  planned.supply.environment = [](const std::string&) -> Result<frame::LoadedEnvironment*> { return nullptr; };
  const auto step = [&] {
    const auto made =
        frame::advance(planned.plan, planned.scene, planned.wish, nullptr, planned.supply, planned.programs);
    REQUIRE(made);
    return *made;
  };
  CHECK(std::string(step().did) == "prepare");
  CHECK(step().progress == Progress::waiting);
  CHECK(step().progress == Progress::waiting);
  planned.supply.environment = environment;
  CHECK(planned.run().contains("compile"));
  CHECK(planned.shown.environment);
}

TEST_CASE("Plan: what failed is not tried again until something else is wished for", "[gl]") {
  Planned planned;
  int asked = 0;
  const auto tables = planned.supply.tables;
  planned.supply.tables = [&](frame::LoadedEnvironment&, const ibl::Needs&) -> Result<void> {
    ++asked;
    return fail("tables", "", "cannot be made", "");
  };
  const auto failing = [&] {
    for (int i = 0; i < 10; ++i) {
      const auto step =
          frame::advance(planned.plan, planned.scene, planned.wish, nullptr, planned.supply, planned.programs);
      if (!step || step->progress == Progress::nothing) return !step;
    }
    return false;
  };
  CHECK(failing());
  CHECK_FALSE(failing());
  CHECK(asked == 1);
  planned.supply.tables = tables;
  planned.wish.look.lights = frame::Lights::demo;
  CHECK_FALSE(planned.run().empty());
}
