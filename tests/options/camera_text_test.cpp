#include "options/camera_text.hpp"

#include <catch2/catch.hpp>

#include "frame/settings.hpp"

using namespace facet;
using frame::Viewpoint;
using options::cameraText;
using options::viewpointOf;

TEST_CASE("a camera as text is what its command needs, and comes back the same") {
  CHECK(cameraText({}) == "");
  Viewpoint view;
  view.orbit = frame::Orbit{-30.25, 0.1, 2.5}, view.target = glm::dvec3(0, -1e-7, 3);
  CHECK(cameraText(view) == "--orbit -30.25,0.1,2.5 --target 0,-1e-07,3");
  view.fovYDeg = 100.0 / 3, view.projection = frame::Projection::orthographic, view.up = {0, 0, 1}, view.rollDeg = 7;
  const std::string text = cameraText(view);
  CHECK(text.ends_with(" --projection orthographic --up z --roll 7"));
  const Result<Viewpoint> back = viewpointOf(text);
  REQUIRE(back);
  CHECK(*back == view);
  Viewpoint named;
  named.camera = "it's \"this\" $one";
  CHECK(viewpointOf(cameraText(named)).value() == named);
  Viewpoint high;
  high.orbit = frame::Orbit{0, 90, {}}, high.viewHeight = 2;
  CHECK(viewpointOf(cameraText(high)).value() == high);
}

TEST_CASE("a camera is found in a whole command, and what else it says is passed over") {
  const Result<Viewpoint> found = viewpointOf(
      "facet render 'a b.glb' -o picture.png --size 64x64\n  --orbit=10,20,3 --samples 4 --roll -5 --env \"x y.hdr\"");
  REQUIRE(found);
  CHECK(found->orbit == frame::Orbit{10, 20, 3});
  CHECK(found->rollDeg == -5);
  CHECK_FALSE(found->target);
  const auto message = [](const char* text) { return describe(viewpointOf(text).error()); };
  CHECK(message("") == "there is no camera in this text: ''; copy one such as --orbit 30,75,2 --target 0,0,0.");
  CHECK(message("facet a.glb --samples 4") ==
        "there is no camera in this text: 'facet a.glb --samples 4'; copy one such as --orbit 30,75,2 --target 0,0,0.");
  CHECK(message("--orbit 'a") ==
        "the text of a camera: has a quote that does not end; copy one such as --orbit 30,75,2 --target 0,0,0.");
  CHECK(message("--orbit") == "--orbit: has no value; copy one such as --orbit 30,75,2 --target 0,0,0.");
  CHECK(message("--orbit 1,2,x").starts_with("--orbit: 'x' is not a number"));
  CHECK(message("--camera 0 --roll 3").starts_with("--roll: the camera of the file has its own place"));
}
