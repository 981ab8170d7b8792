#include "view/controls.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "options/camera_text.hpp"
#include "view/camera_control.hpp"

using namespace facet;
using view::Command;

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

view::Actions press(view::ViewerState& state, Command command) {
  view::Input input;
  input.commands.push_back(command);
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
  CHECK(press(state, Command::screenshot).screenshot);
  CHECK(press(state, Command::copyCommand).copyCommand);
  CHECK(press(state, Command::quit).quit);
  CHECK_FALSE(press(state, Command::escape).quit);
  CHECK(state.status.text == "Ctrl+Q quits");
  press(state, Command::screenshotConverged);
  CHECK(state.screenshotWaits);
  press(state, Command::escape);
  CHECK_FALSE(state.screenshotWaits);
  press(state, Command::panels);
  CHECK_FALSE(state.panelVisible);
  press(state, Command::panels);
  CHECK(state.panelVisible);

  press(state, Command::browser);
  CHECK_FALSE(state.browserVisible);
  press(state, Command::settings);
  CHECK_FALSE(state.settingsVisible);
  press(state, Command::timeline);
  CHECK_FALSE(state.timelineVisible);
  press(state, Command::search);
  CHECK(state.browserVisible);
  CHECK(state.searchAsked);
  state.loading = "large.glb";
  CHECK(press(state, Command::escape).cancel);
  CHECK_FALSE(press(state, Command::escape).quit);
  state.loading.clear();

  press(state, Command::nextEnvironment);
  CHECK(state.settings.sources.environment == "builtin:sky");
  state.shown.environment = "builtin:white";
  press(state, Command::nextEnvironment);
  CHECK(state.settings.sources.environment == "builtin:studio");
  state.shown.environment = "forest.hdr";
  press(state, Command::nextEnvironment);
  CHECK(state.settings.sources.environment == "builtin:studio");

  state.camera.theta = 20;
  state.camera.radius = 77;
  press(state, Command::frameAll);
  CHECK(state.camera.theta == 20);
  CHECK(state.camera.radius == Approx(std::sqrt(3.0) / std::sin(glm::radians(22.5))));
  press(state, Command::resetCamera);
  CHECK(state.camera == state.startCamera);
}

TEST_CASE("controls: views along the axes, turntable, framing the selection, help") {
  view::ViewerState state = exampleState();
  press(state, Command::viewRight);
  CHECK(state.camera.theta == 90);
  press(state, Command::viewBack);
  CHECK(state.camera.theta == 180);
  press(state, Command::viewTop);
  CHECK(state.camera.phi == 0);
  CHECK(state.camera.radius == 5);
  press(state, Command::turntable);
  CHECK(state.turntable.on);

  CHECK_FALSE(press(state, Command::frameSelection).frameSelection);
  state.selection.node = 2;
  CHECK(press(state, Command::frameSelection).frameSelection);
  CHECK_FALSE(press(state, Command::frameAll).frameSelection);

  press(state, Command::help);
  CHECK(state.helpVisible);
  CHECK_FALSE(press(state, Command::escape).quit);  // closes the help,
  CHECK_FALSE(state.helpVisible);
  CHECK_FALSE(press(state, Command::escape).quit);  // deselects,
  CHECK(state.selection.node == -1);
  CHECK_FALSE(press(state, Command::escape).quit);  // and never quits
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
  CHECK(state.camera.orthographic);
  CHECK(state.camera.radius * std::tan(glm::radians(22.5)) == Approx(2));
}

TEST_CASE("controls: the hand is a trackball, or moves the picture alone") {
  view::ViewerState state = exampleState();
  view::Input input;
  input.orbit = {10, 240};
  state.preferences.hand = view::Hand::trackball;
  view::control(input, {}, {}, 480, state);
  CHECK(state.camera.roll != 0);
  state = exampleState();
  state.preferences.hand = view::Hand::plane;
  input.look = {3, -2};
  view::control(input, {}, {}, 480, state);
  CHECK(state.camera.theta == exampleState().camera.theta);
  CHECK(state.camera.target == view::panned(exampleState().camera, {13, 238}, 480).target);
  const double depth = state.camera.target.z;
  view::control({}, {{0, 0, 1}, false}, {}, 480, state);  // forward is up
  CHECK(state.camera.target.z == Approx(depth));
  CHECK(state.camera.target.y > view::panned(exampleState().camera, {13, 238}, 480).target.y);
  input = {};
  input.roll = 12;
  view::control(input, {}, {}, 480, state);
  CHECK(state.camera.roll == 12);
  press(state, Command::orthographic);
  CHECK(state.camera.orthographic);
  CHECK(press(state, Command::copyCamera).copyCamera);
  CHECK(press(state, Command::pasteCamera).pasteCamera);
}

TEST_CASE("controls: a camera that is kept as text is gone to") {
  view::ViewerState state = exampleState();
  state.camera.theta = 12.5, state.camera.orthographic = true, state.camera.up = {0, 0, 1}, state.camera.roll = -3;
  const scene::OrbitCamera kept = state.camera;
  const std::string text = options::cameraText(view::commandSettings(state).viewpoint);
  state.camera = {};
  REQUIRE(view::goToCamera(state, "facet render a.glb " + text + " --samples 3"));
  CHECK(state.camera == kept);
  REQUIRE(view::goToCamera(state, "--camera door --fov-y 20"));
  CHECK(state.settings.viewpoint.camera == "door");
  CHECK(state.settings.viewpoint.fovYDeg == 20);
  CHECK_FALSE(view::goToCamera(state, "a letter"));
  CHECK(state.settings.viewpoint.camera == "door");
  REQUIRE(view::goToCamera(state, text));
  CHECK(state.settings.viewpoint == frame::Viewpoint());
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
  CHECK(state.status.isError);  // and no longer once another file is opened
  CHECK(state.status.text ==
        "notes.txt: neither a model, an environment nor a measured BRDF; drop a .gltf or .glb, a .hdr or .exr, a "
        ".binary or .bin, or a folder.");
  state.panelVisible = state.browserVisible = false;
  CHECK(drop(state, "/").folders == std::vector<std::string>{"/"});
  CHECK_FALSE(state.status.isError);
  CHECK(state.panelVisible);
  CHECK(state.browserVisible);
}

TEST_CASE("controls: shortcuts are found by any words of theirs") {
  view::KeyMap map = view::usualKeys();
  map[Command::turntable].clear();
  const std::vector<view::Shortcut> rows = view::shortcuts(view::usualKeys()), fewer = view::shortcuts(map);
  CHECK(fewer.size() + 1 == rows.size());
  const auto found = [&](const char* query) {
    std::string keys;
    for (const view::Shortcut& shortcut : rows)
      if (view::isAbout(shortcut, query)) keys += std::string(keys.empty() ? "" : "; ") + shortcut.keys;
    return keys;
  };
  CHECK(found("turntable") == "O");
  CHECK(found("SCREENSHOT") == "P, F12; Shift+P");
  CHECK(found("camera fly") == "W  A  S  D  PgUp  PgDn");
  CHECK(found("fly camera") == found("camera fly"));
  CHECK(found("ctrl+q") == "Ctrl+Q");
  CHECK(found("screenshot turntable").empty());
  CHECK(std::ranges::all_of(rows, [](const view::Shortcut& s) { return view::isAbout(s, "  "); }));
}
