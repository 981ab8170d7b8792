#include "view/controls.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "view/camera_control.hpp"

using namespace facet;

namespace {

view::ViewerState exampleState() {
  view::ViewerState state;
  state.settings.frame.width = 640;
  state.settings.frame.height = 480;
  state.shown.bounds = {glm::dvec3(-1), glm::dvec3(1)};
  state.shown.environment = "builtin:studio";
  state.environments = view::builtinEnvironmentSources();
  state.camera.radius = 5;
  state.startCamera = state.camera;
  return state;
}

view::Actions press(view::ViewerState& state, int key, bool withControl = false) {
  view::Input input;
  input.keys.push_back({key, withControl});
  return view::control(input, {}, {}, 480, state);
}

view::Actions drop(view::ViewerState& state, const std::string& path) {
  view::Input input;
  input.dropped.push_back(path);
  return view::control(input, {}, {}, 480, state);
}

}  // namespace

TEST_CASE("controls: drags and the wheel move the camera") {
  view::ViewerState state = exampleState();
  view::Input input;
  input.orbit = {48, 0};
  input.wheel = 2;
  view::control(input, {}, {}, 480, state);
  CHECK(state.camera.theta == Approx(-18));
  CHECK(state.camera.radius == Approx(5 * 0.81));
  input = {};
  input.pan = {0, 10};
  view::control(input, {}, {}, 480, state);
  CHECK(state.camera.target.y > 0);
  const glm::dvec3 eye = view::eyeOf(state.camera);
  input = {};
  input.look = {30, 0};
  view::control(input, {}, {}, 480, state);
  CHECK(glm::distance(view::eyeOf(state.camera), eye) < 1e-12);
}

TEST_CASE("controls: flight crosses the scene at 0.7 radii a second, four times as fast with Shift") {
  view::ViewerState state = exampleState();
  const double radius = std::sqrt(3.0);
  view::control({}, {{0, 0, 0.1}, false}, {}, 480, state);
  CHECK(state.camera.target.z == Approx(-0.07 * radius));
  view::control({}, {{0.1, 0, 0}, true}, {}, 480, state);
  CHECK(state.camera.target.x == Approx(0.28 * radius));
}

TEST_CASE("controls: keys") {
  view::ViewerState state = exampleState();
  CHECK(press(state, GLFW_KEY_P).screenshot);
  CHECK(press(state, GLFW_KEY_F12).screenshot);
  CHECK(press(state, GLFW_KEY_ESCAPE).quit);
  CHECK(press(state, GLFW_KEY_Q, true).quit);
  CHECK_FALSE(press(state, GLFW_KEY_Q).quit);
  press(state, GLFW_KEY_H);
  CHECK_FALSE(state.panelVisible);
  press(state, GLFW_KEY_TAB);
  CHECK(state.panelVisible);

  press(state, GLFW_KEY_B);
  CHECK_FALSE(state.browserVisible);
  press(state, GLFW_KEY_N);
  CHECK_FALSE(state.settingsVisible);
  press(state, GLFW_KEY_T);
  CHECK_FALSE(state.timelineVisible);
  press(state, GLFW_KEY_SLASH);
  CHECK(state.browserVisible);
  CHECK(state.searchAsked);
  state.loading = "large.glb";
  CHECK(press(state, GLFW_KEY_ESCAPE).cancel);
  CHECK_FALSE(press(state, GLFW_KEY_ESCAPE).quit);
  state.loading.clear();

  press(state, GLFW_KEY_E);
  CHECK(state.settings.sources.environment == "builtin:sky");
  state.shown.environment = "builtin:white";
  press(state, GLFW_KEY_E);
  CHECK(state.settings.sources.environment == "builtin:studio");
  state.shown.environment = "forest.hdr";
  press(state, GLFW_KEY_E);
  CHECK(state.settings.sources.environment == "builtin:studio");

  state.camera.theta = 20;
  state.camera.radius = 77;
  press(state, GLFW_KEY_HOME);
  CHECK(state.camera.theta == 20);
  CHECK(state.camera.radius == Approx(std::sqrt(3.0) / std::sin(glm::radians(22.5))));
  press(state, GLFW_KEY_R);
  CHECK(state.camera == state.startCamera);
}

TEST_CASE("controls: views along the axes, turntable, framing the selection, help") {
  view::ViewerState state = exampleState();
  press(state, GLFW_KEY_3);
  CHECK(state.camera.theta == 90);
  press(state, GLFW_KEY_KP_1, true);
  CHECK(state.camera.theta == 180);
  press(state, GLFW_KEY_7);
  CHECK(state.camera.phi == 0);
  CHECK(state.camera.radius == 5);
  press(state, GLFW_KEY_O);
  CHECK(state.turntable.on);

  CHECK_FALSE(press(state, GLFW_KEY_F).frameSelection);
  state.selection.node = 2;
  CHECK(press(state, GLFW_KEY_F).frameSelection);
  view::Input input;
  input.keys.push_back({GLFW_KEY_F, false, true});
  CHECK_FALSE(view::control(input, {}, {}, 480, state).frameSelection);

  press(state, GLFW_KEY_F1);
  CHECK(state.helpVisible);
  CHECK_FALSE(press(state, GLFW_KEY_ESCAPE).quit);  // closes the help,
  CHECK_FALSE(state.helpVisible);
  CHECK_FALSE(press(state, GLFW_KEY_ESCAPE).quit);  // deselects,
  CHECK(state.selection.node == -1);
  CHECK(press(state, GLFW_KEY_ESCAPE).quit);
}

TEST_CASE("controls: a hand on the camera leaves the file's camera and starts from its view") {
  view::ViewerState state = exampleState();
  scene::OrbitCamera placed;
  placed.theta = 70;
  placed.phi = 50;
  placed.radius = 4;
  placed.fovY = 30;
  const scene::View view = scene::orbitView(placed, 640.0 / 480, state.shown.bounds);
  state.settings.viewpoint.camera = "door";
  view::Input input;
  CHECK(view::control(input, {}, view, 480, state).quit == false);
  CHECK(state.settings.viewpoint.camera == "door");
  input.wheel = 1;
  view::control(input, {}, view, 480, state);
  CHECK(state.settings.viewpoint.camera.empty());
  CHECK(state.camera.theta == Approx(70));
  CHECK(state.camera.phi == Approx(50));
  CHECK(state.camera.fovY == Approx(30));
  CHECK(state.camera.radius == Approx(4 * 0.9));
}

TEST_CASE("controls: an orthographic camera becomes an orbit that shows as much") {
  view::ViewerState state = exampleState();
  scene::Camera camera;
  camera.perspective = false;
  camera.xMag = camera.yMag = 2;
  glm::dmat4 place(1);
  place[3] = {0, 0, 9, 1};
  const scene::View view = scene::cameraView(camera, place, 1, state.shown.bounds);
  state.settings.viewpoint.camera = "0";
  view::freeCamera(state, view);
  CHECK(state.camera.fovY == 45);
  CHECK(state.camera.radius * std::tan(glm::radians(22.5)) == Approx(2));
}

TEST_CASE("controls: dropped files are told apart by their ending") {
  view::ViewerState state = exampleState();
  CHECK(drop(state, "/models/a chair.GLB").model == "/models/a chair.GLB");
  CHECK(drop(state, "b.gltf").model == "b.gltf");
  CHECK(drop(state, "/skies/dawn.hdr").model.empty());
  CHECK(state.settings.sources.environment == "/skies/dawn.hdr");
  drop(state, "/skies/dusk.EXR");
  drop(state, "/skies/dawn.hdr");
  const std::vector<std::string> offered = {"builtin:studio",  "builtin:sky",     "builtin:white",
                                            "/skies/dawn.hdr", "/skies/dusk.EXR", "none"};
  CHECK(state.environments == offered);
  drop(state, "/brdfs/gold.binary");
  CHECK(state.settings.sources.brdf == "/brdfs/gold.binary");
  CHECK_FALSE(state.status.isError);
  drop(state, "notes.txt");
  CHECK(state.status.isError);
  CHECK(state.status.text ==
        "notes.txt: neither a model, an environment nor a measured BRDF; drop a .gltf or .glb, a .hdr or .exr, a "
        ".binary or .bin, or a folder.");
  state.panelVisible = state.browserVisible = false;
  CHECK(drop(state, "/").folders == std::vector<std::string>{"/"});
  CHECK(state.panelVisible);
  CHECK(state.browserVisible);
}

TEST_CASE("controls: shortcuts are found by any words of theirs") {
  const auto found = [](const char* query) {
    std::string keys;
    for (const view::Shortcut& shortcut : view::shortcuts)
      if (view::isAbout(shortcut, query)) keys += std::string(keys.empty() ? "" : "; ") + shortcut.keys;
    return keys;
  };
  CHECK(found("turntable") == "O");
  CHECK(found("SCREENSHOT") == "P, F12");
  CHECK(found("camera fly") == "W A S D, PgUp PgDn");
  CHECK(found("fly camera") == found("camera fly"));
  CHECK(found("ctrl+q") == "Ctrl+Q");
  CHECK(found("screenshot turntable").empty());
  CHECK(std::ranges::all_of(view::shortcuts, [](const view::Shortcut& s) { return view::isAbout(s, "  "); }));
}
