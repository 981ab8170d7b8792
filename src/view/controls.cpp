#include "view/controls.hpp"

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
  const Hand hand = state.preferences.hand;
  const bool plane = hand == Hand::plane;
  const glm::dvec2 pan = plane ? input.pan + input.orbit + input.look : input.pan, none(0);
  if (input.orbit != none && hand == Hand::orbit) camera = orbited(camera, input.orbit, windowHeight);
  if (input.orbit != none && hand == Hand::trackball) camera = tumbled(camera, input.orbit, windowHeight);
  if (pan != none) camera = panned(camera, pan, windowHeight);
  if (input.look != none && !plane) camera = looked(camera, input.look, windowHeight);
  if (input.roll != 0) camera = rolled(camera, input.roll);
  const glm::dvec2 window(windowHeight * frame::aspectOf(state.settings.frame), windowHeight);
  if (input.wheel != 0) camera = zoomedAt(camera, input.wheel, limits, input.cursor, window);
  const double speed = flightSpeed(camera, state.shown.bounds) * (flight.fast ? fastFactor : 1);
  glm::dvec3 way = flight.rightUpForward;
  if (plane) way = {way.x, way.y + way.z, 0};
  if (way != glm::dvec3(0)) camera = flown(camera, way * speed);
}

// What is open or chosen first. Never the program: a second press that was meant for a list would cost the view.
void takeEscape(ViewerState& state, Actions& actions) {
  if (!state.loading.empty())
    actions.cancel = true;
  else if (state.screenshotWaits)
    state.screenshotWaits = false, say(state, "no screenshot");
  else if (state.helpVisible)
    state.helpVisible = false;
  else if (state.selection.node >= 0 || state.selection.material >= 0)
    state.selection = {}, state.inspection = {};
  else if (const std::string keys = keysText(state.keys, Command::quit); !keys.empty())
    say(state, keys + " quits");
}

void lookFrom(ViewFrom side, const std::optional<scene::View>& view, ViewerState& state) {
  if (view) freeCamera(state, *view);
  state.camera = seenFrom(state.camera, side);
}

void frameAll(const std::optional<scene::View>& view, ViewerState& state) {
  if (view) freeCamera(state, *view);
  state.camera = framedAll(state.camera, state.shown.bounds, framingAspect(state));
}

// Shows or hides it; one that is folded is shown.
void showPart(ViewerState& state, bool& part) {
  part = !part;
  state.panelVisible = true;
}
void showSide(ViewerState& state, Side side) {
  bool& part = side == Side::left ? state.browserVisible : state.settingsVisible;
  if (!state.panelVisible || !part || state.layout.folded != side) showPart(state, part);
  if (part) state.layout.last = side;
}

void take(Command command, const std::optional<scene::View>& view, ViewerState& state, Actions& actions) {
  switch (command) {
    case Command::flyForward:
    case Command::flyLeft:
    case Command::flyBack:
    case Command::flyRight:
    case Command::flyUp:
    case Command::flyDown:
      return;  // as long as it is held: Flight
    case Command::viewFront:
      return lookFrom(ViewFrom::front, view, state);
    case Command::viewRight:
      return lookFrom(ViewFrom::right, view, state);
    case Command::viewTop:
      return lookFrom(ViewFrom::top, view, state);
    case Command::viewBack:
      return lookFrom(ViewFrom::back, view, state);
    case Command::viewLeft:
      return lookFrom(ViewFrom::left, view, state);
    case Command::viewBottom:
      return lookFrom(ViewFrom::bottom, view, state);
    case Command::frameSelection:
      if (state.selection.node < 0) return frameAll(view, state);
      actions.frameSelection = true;
      return;
    case Command::frameAll:
      return frameAll(view, state);
    case Command::resetCamera:
      state.settings.viewpoint.camera.clear();
      state.camera = state.startCamera;
      return;
    case Command::orthographic:
      if (view) freeCamera(state, *view);
      state.camera.orthographic = !state.camera.orthographic;
      return;
    case Command::copyCamera:
      actions.copyCamera = true;
      return;
    case Command::pasteCamera:
      actions.pasteCamera = true;
      return;
    case Command::turntable:
      state.turntable.on = !state.turntable.on;
      return;
    case Command::nextEnvironment:
      state.settings.sources.environment = nextEnvironment(state.shown.environment);
      return;
    case Command::play:
      return togglePlaying(state);
    case Command::panels:
      state.panelVisible = !state.panelVisible;
      return;
    case Command::browser:
      return showSide(state, Side::left);
    case Command::settings:
      return showSide(state, Side::right);
    case Command::timeline:
      return showPart(state, state.timelineVisible);
    case Command::search:
      state.browserVisible = state.panelVisible = state.searchAsked = true;
      state.layout.last = Side::left;
      return;
    case Command::screenshot:
      actions.screenshot = true;
      return;
    case Command::screenshotConverged:
      state.screenshotWaits = true;
      return;
    case Command::copyCommand:
      actions.copyCommand = true;
      return;
    case Command::openFile:
      actions.openFile = true;
      return;
    case Command::saveAs:
      actions.saveAs = true;
      break;
    case Command::saveSession:
      actions.saveSession = true;
      return;
    case Command::undo:
      if (!undo(state.history, state.settings)) say(state, "there is nothing to undo");
      return;
    case Command::redo:
      if (!redo(state.history, state.settings)) say(state, "there is nothing to redo");
      return;
    case Command::messages:
      state.messagesAsked = true;
      return;
    case Command::help:
      state.helpVisible = !state.helpVisible;
      return;
    case Command::escape:
      return takeEscape(state, actions);
    case Command::quit:
      actions.quit = true;
  }
}

void takeFile(const std::string& path, ViewerState& state, Actions& actions) {
  const Result<FileKind> kind = fileKind(path);
  state.status = {};  // of another file
  if (!kind) {
    state.status = {describe(kind.error()), true};
  } else if (*kind == FileKind::model) {
    actions.model = path;
  } else if (*kind == FileKind::environment) {
    offerEnvironment(state, path);
    state.settings.sources.environment = path;
  } else if (*kind == FileKind::folder) {
    actions.folders.push_back(path);
    say(state, "looking through " + path);
    state.browserVisible = state.panelVisible = true;
  } else {
    chooseBrdf(state, path);
  }
}

}  // namespace

std::vector<Shortcut> shortcuts(const KeyMap& keys) {
  std::vector<Shortcut> rows = {{"Camera", "left drag", "orbit; trackball and 2D as chosen under Camera"},
                                {"Camera", "middle or Shift drag", "pan"},
                                {"Camera", "Ctrl drag", "roll"},
                                {"Camera", "wheel", "nearer, farther, towards the pointer"},
                                {"Camera", "double click", "the target: what is there comes to the middle"},
                                {"Camera", "right drag", "look around"}};
  for (const CommandRow& row : commandRows()) {
    if (rows.back().group == std::string("Camera") && row.group == std::string("Scene"))
      rows.push_back({"Scene", "left click", "select a node, read its values there"});
    if (rows.back().group == std::string("Scene") && row.group == std::string("Window"))
      rows.push_back({"Scene", "drop", ".glb .gltf, .hdr .exr, MERL's .binary, UTIA's .bin, a folder"});
    const std::string chords = keysText(keys, row.command);
    if (rows.back().does == row.does)
      rows.back().keys += (rows.back().keys.empty() || chords.empty() ? "" : "  ") + chords;
    else
      rows.push_back({row.group, chords, row.does});
  }
  std::erase_if(rows, [](const Shortcut& row) { return row.keys.empty(); });
  return rows;
}

bool isAbout(const Shortcut& shortcut, std::string_view query) {
  return hasWords(shortcut.group + " " + shortcut.keys + " " + shortcut.does, query);
}

Actions control(const Input& input, const Flight& flight, const std::optional<scene::View>& view, double windowHeight,
                ViewerState& state) {
  const glm::dvec2 none(0);
  const bool moves = input.orbit != none || input.pan != none || input.look != none || input.wheel != 0 ||
                     input.roll != 0 || flight.rightUpForward != glm::dvec3(0);
  if (moves && view) freeCamera(state, *view);
  if (moves) moveCamera(input, flight, windowHeight, state);
  Actions actions;
  for (const Command command : input.commands) take(command, view, state, actions);
  for (const std::string& path : input.dropped) takeFile(path, state, actions);
  return actions;
}

}  // namespace facet::view
