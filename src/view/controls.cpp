#include "view/controls.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <filesystem>

#include "view/camera_control.hpp"
#include "view/playback.hpp"

namespace facet::view {

namespace {

// A scene is crossed in about three seconds.
constexpr double radiiPerSecond = 0.7, fastFactor = 4;

void moveCamera(const Input& input, const Flight& flight, double windowHeight, ViewerState& state) {
  scene::OrbitCamera& camera = state.camera;
  const RadiusLimits limits = radiusLimits(state.shown.bounds);
  if (input.orbit != glm::dvec2(0)) camera = orbited(camera, input.orbit, windowHeight);
  if (input.pan != glm::dvec2(0)) camera = panned(camera, input.pan, windowHeight);
  if (input.look != glm::dvec2(0)) camera = looked(camera, input.look, windowHeight);
  if (input.wheel != 0) camera = zoomed(camera, input.wheel, limits);
  const double speed = limits.max * 1e-2 * radiiPerSecond * (flight.fast ? fastFactor : 1);
  if (flight.rightUpForward != glm::dvec3(0)) camera = flown(camera, flight.rightUpForward * speed);
}

void takeKey(const KeyPress& press, const std::optional<scene::View>& view, ViewerState& state, Actions& actions) {
  const double aspect = static_cast<double>(state.settings.width) / state.settings.height;
  switch (press.key) {
    case GLFW_KEY_F:
    case GLFW_KEY_HOME:
      if (view) freeCamera(state, *view);
      state.camera = framedAll(state.camera, state.shown.bounds, aspect);
      break;
    case GLFW_KEY_R:
      state.settings.camera.clear();
      state.camera = state.startCamera;
      break;
    case GLFW_KEY_E:
      state.settings.environment = nextEnvironment(state.shown.environment);
      break;
    case GLFW_KEY_SPACE:
      togglePlaying(state);
      break;
    case GLFW_KEY_P:
    case GLFW_KEY_F12:
      actions.screenshot = true;
      break;
    case GLFW_KEY_H:
    case GLFW_KEY_TAB:
      state.panelVisible = !state.panelVisible;
      break;
    case GLFW_KEY_B:
      state.browserVisible = !state.browserVisible;
      state.panelVisible = true;
      break;
    case GLFW_KEY_N:
      state.settingsVisible = !state.settingsVisible;
      state.panelVisible = true;
      break;
    case GLFW_KEY_T:
      state.timelineVisible = !state.timelineVisible;
      state.panelVisible = true;
      break;
    case GLFW_KEY_ESCAPE:
      actions.quit = true;
      break;
    case GLFW_KEY_Q:
      actions.quit = actions.quit || press.control;
      break;
    default:
      break;
  }
}

void takeFile(const std::string& path, ViewerState& state, Actions& actions) {
  const Result<FileKind> kind = fileKind(path);
  if (!kind) {
    state.status = {describe(kind.error()), true};
  } else if (*kind == FileKind::model) {
    actions.model = path;
  } else {
    offerEnvironment(state, path);
    state.settings.environment = path;
  }
}

}  // namespace

const std::vector<Shortcut> shortcuts = {
    {"left drag", "orbit"},
    {"middle or Shift drag", "pan"},
    {"wheel", "nearer, farther"},
    {"right drag", "look around"},
    {"W A S D, PgUp PgDn", "fly; Shift: faster"},
    {"F, Home", "frame all"},
    {"R", "reset the camera"},
    {"E", "next built-in environment"},
    {"Space", "play, pause"},
    {"P, F12", "screenshot"},
    {"H, Tab", "hide or show all panels"},
    {"B, N, T", "browser, settings, timeline"},
    {"Esc, Ctrl+Q", "quit"},
    {"drop a file", ".glb .gltf .hdr .exr"},
};

Result<FileKind> fileKind(std::string_view path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  if (extension == ".gltf" || extension == ".glb") return FileKind::model;
  if (extension == ".hdr" || extension == ".exr") return FileKind::environment;
  return fail(std::string(path), "", "neither a model nor an environment", "drop a .gltf or .glb, or a .hdr or .exr");
}

Actions control(const Input& input, const Flight& flight, const std::optional<scene::View>& view, double windowHeight,
                ViewerState& state) {
  const glm::dvec2 none(0);
  const bool moves = input.orbit != none || input.pan != none || input.look != none || input.wheel != 0 ||
                     flight.rightUpForward != glm::dvec3(0);
  if (moves && view) freeCamera(state, *view);
  if (moves) moveCamera(input, flight, windowHeight, state);
  Actions actions;
  for (const KeyPress& press : input.keys) takeKey(press, view, state, actions);
  for (const std::string& path : input.dropped) takeFile(path, state, actions);
  return actions;
}

}  // namespace facet::view
