#include "view/playback.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace facet;

namespace {

view::ViewerState playing() {
  view::ViewerState state;
  state.shown.animations = {{"walk", "walk", 2}, {"1", "animation 1", 5}};
  state.settings.placement.animation = "walk";
  state.settings.placement.timeSeconds = 1.5;
  state.playback.playing = true;
  return state;
}

}  // namespace

TEST_CASE("playback: time goes on with the clock, times the speed, and around") {
  view::ViewerState state = playing();
  view::advance(state, 0.25);
  CHECK(state.settings.placement.timeSeconds == Approx(1.75));
  state.playback.speed = 2;
  view::advance(state, 0.25);
  CHECK(state.settings.placement.timeSeconds == Approx(0.25));
  state.playback.speed = -1;
  view::advance(state, 0.5);
  CHECK(state.settings.placement.timeSeconds == Approx(1.75));
  state.playback.playing = false;
  view::advance(state, 0.5);
  CHECK(state.settings.placement.timeSeconds == Approx(1.75));
}

TEST_CASE("playback: without loop it stops at the end and begins anew") {
  view::ViewerState state = playing();
  state.playback.loop = false;
  view::advance(state, 10);
  CHECK(state.settings.placement.timeSeconds == 2);
  CHECK_FALSE(state.playback.playing);
  view::togglePlaying(state);
  CHECK(state.settings.placement.timeSeconds == 0);
  CHECK(state.playback.playing);
}

TEST_CASE("playback: an hour of frames ends where the hour does, and a long pause is as much time as it took") {
  for (const double fps : {60.0, 59.94, 7.0}) {
    view::ViewerState state = playing();
    state.settings.placement.timeSeconds = 0;
    const auto frames = static_cast<int>(3600 * fps);
    bool inside = true;
    for (int i = 0; i < frames; ++i) {
      view::advance(state, 1 / fps);
      inside = inside && state.settings.placement.timeSeconds >= 0 && state.settings.placement.timeSeconds <= 2;
    }
    CHECK(inside);
    // The other end of the loop is the same moment.
    const double off = std::remainder(state.settings.placement.timeSeconds - frames / fps, 2);
    CHECK(std::abs(off) < 1e-7);  // a thousandth of a thousandth of a frame
    CHECK(state.playback.playing);
  }
  view::ViewerState state = playing();
  view::advance(state, 3600);
  CHECK(state.settings.placement.timeSeconds == Approx(1.5));
  view::advance(state, 1e12);
  CHECK(state.settings.placement.timeSeconds <= 2);
}

TEST_CASE("playback: at rest, the first animation is what plays") {
  view::ViewerState state = playing();
  state.settings.placement.animation.clear();
  state.playback.playing = false;
  CHECK(view::chosenDuration(state) == 0);
  view::togglePlaying(state);
  CHECK(state.settings.placement.animation == "walk");
  CHECK(state.settings.placement.timeSeconds == 0);
  CHECK(state.playback.playing);
  view::ViewerState still;
  view::togglePlaying(still);
  CHECK_FALSE(still.playback.playing);
}

TEST_CASE("playback: names, indices where names don't tell, all at once") {
  scene::Model model;
  CHECK(view::animationNames(model).empty());
  scene::AnimationSampler sampler;
  sampler.times = {0, 3};
  for (const char* name : {"run", "", "jump", "jump"}) {
    model.animations.push_back({name, {sampler}, {{}}});
    sampler.times[1] += 1;
  }
  const auto names = view::animationNames(model);
  REQUIRE(names.size() == 5);
  CHECK(names[0].option == "run");
  CHECK(names[1].option == "1");
  CHECK(names[1].label == "animation 1");
  CHECK(names[2].option == "2");
  CHECK(names[2].label == "jump");
  CHECK(names[3].option == "3");
  CHECK(names[4].option == "all");
  CHECK(names[4].duration == 6);
  CHECK(view::animationOption(model, "0") == "run");
  CHECK(view::animationOption(model, "2") == "2");
  CHECK(view::animationOption(model, "all") == "all");
  CHECK(view::animationOption(model, "") == "");
  model.animations.resize(1);
  CHECK(view::animationOption(model, "all") == "run");
}
