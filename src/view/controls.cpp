#include "view/controls.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "view/camera_control.hpp"
#include "view/listing.hpp"
#include "view/playback.hpp"

namespace facet::view {

namespace {

constexpr double fastFactor = 4;

void moveCamera(const Input& input, const Flight& flight, double windowHeight, ViewerState& state) {
  scene::OrbitCamera& camera = state.camera;
  const RadiusLimits limits = radiusLimits(state.shown.bounds);
  if (input.orbit != glm::dvec2(0)) camera = orbited(camera, input.orbit, windowHeight);
  if (input.pan != glm::dvec2(0)) camera = panned(camera, input.pan, windowHeight);
  if (input.look != glm::dvec2(0)) camera = looked(camera, input.look, windowHeight);
  if (input.wheel != 0) camera = zoomed(camera, input.wheel, limits);
  const double speed = flightSpeed(camera, state.shown.bounds) * (flight.fast ? fastFactor : 1);
  if (flight.rightUpForward != glm::dvec3(0)) camera = flown(camera, flight.rightUpForward * speed);
}

// What is open or chosen first; the program last.
void takeEscape(ViewerState& state, Actions& actions) {
  if (!state.loading.empty())
    actions.cancel = true;
  else if (state.helpVisible)
    state.helpVisible = false;
  else if (state.selection.node >= 0 || state.selection.material >= 0)
    state.selection = {}, state.inspection = {};
  else
    actions.quit = true;
}

// As many programs have it: 1 front, 3 right, 7 top, with Ctrl from the other side.
void lookAlong(const KeyPress& press, ViewFrom side, ViewFrom opposite, const std::optional<scene::View>& view,
               ViewerState& state) {
  if (view) freeCamera(state, *view);
  state.camera = seenFrom(state.camera, press.control ? opposite : side);
}

void takeKey(const KeyPress& press, const std::optional<scene::View>& view, ViewerState& state, Actions& actions) {
  const double aspect = static_cast<double>(state.settings.frame.width) / state.settings.frame.height;
  switch (press.key) {
    case GLFW_KEY_F:
      if (state.selection.node >= 0 && !press.shift) {
        actions.frameSelection = true;
        break;
      }
      [[fallthrough]];
    case GLFW_KEY_HOME:
      if (view) freeCamera(state, *view);
      state.camera = framedAll(state.camera, state.shown.bounds, aspect);
      break;
    case GLFW_KEY_1:
    case GLFW_KEY_KP_1:
      lookAlong(press, ViewFrom::front, ViewFrom::back, view, state);
      break;
    case GLFW_KEY_3:
    case GLFW_KEY_KP_3:
      lookAlong(press, ViewFrom::right, ViewFrom::left, view, state);
      break;
    case GLFW_KEY_7:
    case GLFW_KEY_KP_7:
      lookAlong(press, ViewFrom::top, ViewFrom::bottom, view, state);
      break;
    case GLFW_KEY_O:
      state.turntable.on = !state.turntable.on;
      break;
    case GLFW_KEY_F1:
      state.helpVisible = !state.helpVisible;
      break;
    case GLFW_KEY_SLASH:
      if (press.shift)
        state.helpVisible = !state.helpVisible;
      else
        state.browserVisible = state.panelVisible = state.searchAsked = true;
      break;
    case GLFW_KEY_R:
      state.settings.viewpoint.camera.clear();
      state.camera = state.startCamera;
      break;
    case GLFW_KEY_E:
      state.settings.sources.environment = nextEnvironment(state.shown.environment);
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
      takeEscape(state, actions);
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
  } else if (*kind == FileKind::environment) {
    offerEnvironment(state, path);
    state.settings.sources.environment = path;
  } else if (*kind == FileKind::folder) {
    actions.folders.push_back(path);
    state.browserVisible = state.panelVisible = true;
  } else {
    chooseBrdf(state, path);
  }
}

}  // namespace

const std::vector<Shortcut> shortcuts = {
    {"Camera", "left drag", "orbit; the horizon stays level"},
    {"Camera", "middle or Shift drag", "pan"},
    {"Camera", "wheel", "nearer, farther"},
    {"Camera", "right drag", "look around"},
    {"Camera", "W A S D, PgUp PgDn", "fly; Shift: faster"},
    {"Camera", "1, 3, 7", "from the front, the right, above; Ctrl: from the other side"},
    {"Camera", "F", "frame the selection, or everything"},
    {"Camera", "Shift+F, Home", "frame everything"},
    {"Camera", "R", "reset the camera"},
    {"Camera", "O", "turntable: go round the target about +Y"},
    {"Scene", "left click", "select a node, read its values there"},
    {"Scene", "E", "next built-in environment"},
    {"Scene", "Space", "play, pause"},
    {"Scene", "drop", ".glb .gltf, .hdr .exr, MERL's .binary, UTIA's .bin, a folder"},
    {"Window", "H, Tab", "hide or show all panels"},
    {"Window", "B, N, T", "browser, settings, timeline"},
    {"Window", "/", "search in the browser"},
    {"Window", "P, F12", "screenshot"},
    {"Window", "F1, ?", "this help"},
    {"Window", "Esc", "cancel loading, close the help, deselect, quit"},
    {"Window", "Ctrl+Q", "quit"},
};

bool isAbout(const Shortcut& shortcut, std::string_view query) {
  return hasWords(std::string(shortcut.group) + " " + shortcut.keys + " " + shortcut.does, query);
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
