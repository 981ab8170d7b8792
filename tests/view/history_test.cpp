#include "view/history.hpp"

#include <catch2/catch.hpp>

using namespace facet;
using namespace facet::view;

namespace {

void setRoughness(frame::PictureSettings& settings, double value) {
  scene::setEdit(settings.placement.arrangement.edits, "/materials/0/roughnessFactor", {value});
}

double roughness(const frame::PictureSettings& settings) {
  const scene::Edit* edit = scene::findEdit(settings.placement.arrangement.edits, "/materials/0/roughnessFactor");
  return edit ? edit->values[0] : -1;
}

}  // namespace

TEST_CASE("Changes are undone and redone step by step", "[view]") {
  History history;
  frame::PictureSettings settings;
  follow(history, "a", settings, false);
  CHECK_FALSE(undo(history, settings));
  // What is dragged is one step.
  for (const double value : {0.1, 0.2, 0.3}) setRoughness(settings, value), follow(history, "a", settings, true);
  follow(history, "a", settings, false);
  settings.look.material.on = true;
  follow(history, "a", settings, false);
  settings.display.exposureStops = 2;  // no change of the model
  follow(history, "a", settings, false);
  CHECK(history.past.size() == 2);

  REQUIRE(undo(history, settings));
  follow(history, "a", settings, false);
  CHECK_FALSE(settings.look.material.on);
  CHECK(roughness(settings) == 0.3);
  REQUIRE(undo(history, settings));
  follow(history, "a", settings, false);
  CHECK(roughness(settings) == -1);
  CHECK_FALSE(undo(history, settings));
  CHECK(settings.display.exposureStops == 2);

  REQUIRE(redo(history, settings));
  follow(history, "a", settings, false);
  CHECK(roughness(settings) == 0.3);
  // A new change forgets what was undone.
  setRoughness(settings, 0.9);
  follow(history, "a", settings, false);
  CHECK_FALSE(redo(history, settings));
  REQUIRE(undo(history, settings));
  CHECK(roughness(settings) == 0.3);

  // Another model begins anew.
  follow(history, "b", settings, false);
  CHECK_FALSE(undo(history, settings));
}

TEST_CASE("Steps are kept up to a number", "[view]") {
  History history;
  frame::PictureSettings settings;
  for (int i = 0; i < 500; ++i) setRoughness(settings, i / 500.0), follow(history, "a", settings, false);
  CHECK(history.past.size() == keptSteps);
}
