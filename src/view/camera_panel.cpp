#include "view/camera_panel.hpp"

#include <cmath>
#include <cstdio>
#include <iterator>

#include "base/angle.hpp"
#include "options/camera_text.hpp"
#include "view/bookmarks.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

void cameraChoice(ViewerState& state, PanelResult& result) {
  std::string& chosen = state.settings.viewpoint.camera;
  if (state.shown.cameras.empty()) return;
  if (!beginList("camera", chosen.empty() ? "orbit" : chosen)) {
    hint("orbit: yours; the others are the file's and stand where it puts them, until you move");
    return;
  }
  if (ImGui::Selectable("orbit", chosen.empty())) result.leaveFileCamera = true;
  for (const CameraName& camera : state.shown.cameras) {
    ImGui::PushID(&camera);
    if (ImGui::Selectable(camera.label.c_str(), chosen == camera.option)) chosen = camera.option;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void sceneChoice(ViewerState& state) {
  const std::vector<std::string>& scenes = state.shown.scenes;
  if (scenes.size() < 2) return;
  const auto current = static_cast<size_t>(state.shown.scene);
  if (!beginList("scene", current < scenes.size() ? scenes[current] : "")) return;
  for (size_t i = 0; i < scenes.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::Selectable(scenes[i].c_str(), i == current)) {
      state.settings.placement.scene = static_cast<int>(i);
      state.settings.viewpoint.camera.clear();
    }
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void viewButtons(const KeyMap& keys, PanelResult& result) {
  struct Button {
    const char* label;
    ViewFrom from;
    Command command;
  };
  constexpr Button buttons[] = {
      {"front", ViewFrom::front, Command::viewFront}, {"right", ViewFrom::right, Command::viewRight},
      {"top", ViewFrom::top, Command::viewTop},       {"back", ViewFrom::back, Command::viewBack},
      {"left", ViewFrom::left, Command::viewLeft},    {"bottom", ViewFrom::bottom, Command::viewBottom}};
  const float spacing = ImGui::GetStyle().ItemSpacing.x;
  const float width = (ImGui::GetContentRegionAvail().x - 2 * spacing) / 3;
  for (size_t i = 0; i < std::size(buttons); ++i) {
    if (i % 3 != 0) ImGui::SameLine();
    if (ImGui::Button(buttons[i].label, {width, 0})) result.viewFrom = buttons[i].from;
    hint(withKeys("looks at the target from there", keys, buttons[i].command));
  }
  if (ImGui::Button("frame all", {width, 0})) result.frameAll = true;
  hint(withKeys("brings everything into the picture", keys, Command::frameAll));
  ImGui::SameLine();
  if (ImGui::Button("selection", {width, 0})) result.frameSelection = true;
  hint(withKeys("brings the selected node into the picture", keys, Command::frameSelection));
  ImGui::SameLine();
  if (ImGui::Button("reset", {width, 0})) result.resetCamera = true;
  hint(withKeys("the view that the model came with", keys, Command::resetCamera));
}

std::string upText(const glm::dvec3& up) {
  constexpr const char* names[] = {"X", "Y", "Z"};
  for (int i = 0; i < 3; ++i) {
    glm::dvec3 axis(0);
    axis[i] = 1;
    if (up == axis) return names[i];
    if (up == -axis) return std::string("-") + names[i];
  }
  char text[64];
  std::snprintf(text, sizeof text, "%.3g, %.3g, %.3g", up.x, up.y, up.z);
  return text;
}

void upChoice(scene::OrbitCamera& camera) {
  if (!beginList("up", upText(camera.up))) {
    if (resetAsked()) camera.up = {0, 1, 0};
    return resettableHint("the axis that the camera goes round");
  }
  for (int i = 0; i < 6; ++i) {
    glm::dvec3 axis(0);
    axis[i % 3] = i < 3 ? 1 : -1;
    if (ImGui::Selectable(upText(axis).c_str(), camera.up == axis)) camera.up = axis;
  }
  ImGui::EndCombo();
}

// Of the orbit; a camera of the file has its own.
void lens(scene::OrbitCamera& camera) {
  using frame::Projection;
  Projection projection = camera.orthographic ? Projection::orthographic : Projection::perspective;
  if (chooseEnum("projection", projection, frame::projections, Projection::perspective,
                 "whether what is farther away looks smaller"))
    camera.orthographic = projection == Projection::orthographic;
  if (camera.orthographic) {
    auto height = static_cast<float>(scene::heightAtTarget(camera));
    if (ImGui::DragFloat("height", &height, 0.01f * height, 1e-9f, 1e9f, "%.5g m", ImGuiSliderFlags_AlwaysClamp))
      camera.radius = scene::radiusForHeight(static_cast<double>(height), camera.fovY);
    hint("of what is seen; Ctrl and a click: a number");
  } else {
    auto fovY = static_cast<float>(camera.fovY);
    if (slider("field of view", fovY, 1, 179, "%.5g\xc2\xb0", 45, "vertical; Ctrl and a click: a number"))
      camera.fovY = static_cast<double>(fovY);
  }
  auto roll = static_cast<float>(camera.roll);
  if (slider("roll", roll, -180, 180, "%.5g\xc2\xb0", 0,
             "turns the picture, counterclockwise; Ctrl and a drag in it, too"))
    camera.roll = static_cast<double>(roll);
  upChoice(camera);
}

// What the picture takes in, of whichever camera.
void viewFigures(const ViewerState& state) {
  if (!state.shown.view) return;
  const scene::View& view = *state.shown.view;
  const double x = 1 / view.clipFromView[0][0], y = 1 / view.clipFromView[1][1];
  if (view.orthographic)
    ImGui::TextDisabled("%.5g m high, %.5g m wide", 2 * y, 2 * x);
  else
    ImGui::TextDisabled("%.5g\xc2\xb0 high, %.5g\xc2\xb0 wide", 2 * std::atan(y) / degree, 2 * std::atan(x) / degree);
  if (std::isinf(view.zFar))
    ImGui::TextDisabled("near %.3g m, far infinite", view.zNear);
  else
    ImGui::TextDisabled("near %.3g m, far %.3g m", view.zNear, view.zFar);
  hint("distances from the eye between which something is seen");
}

void bookmarkRows(ViewerState& state, std::vector<Bookmark>& bookmarks) {
  size_t gone = bookmarks.size();
  for (size_t i = 0; i < bookmarks.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    if (ImGui::SmallButton("x")) gone = i;
    hint("forgets it");
    ImGui::SameLine();
    if (ImGui::Selectable(bookmarks[i].name.c_str()))
      if (const Result<void> went = goToCamera(state, bookmarks[i].camera); !went) complain(state, went.error());
    hint("looks from there: " + bookmarks[i].camera);
    ImGui::PopID();
  }
  if (gone < bookmarks.size()) bookmarks.erase(bookmarks.begin() + static_cast<ptrdiff_t>(gone));
}

void bookmarkList(ViewerState& state, PanelResult& result) {
  if (state.shown.model.empty() || !ImGui::TreeNode("bookmarks")) return;
  const std::string key = bookmarkKey(state.shown.model);
  const auto known = state.bookmarks.find(key);
  std::vector<Bookmark> bookmarks = known == state.bookmarks.end() ? std::vector<Bookmark>{} : known->second;
  const size_t before = bookmarks.size();
  bookmarkRows(state, bookmarks);
  const bool entered = enteredField("##name", "name", state.bookmarkName);
  ImGui::SameLine();
  const bool pressed = ImGui::Button("keep");
  hint("this camera, with the model's other ones; for the next time, too");
  if (entered || pressed) {
    keepBookmark(bookmarks, state.bookmarkName, options::cameraText(commandSettings(state).viewpoint));
    state.bookmarkName.clear();
  }
  if (entered || pressed || bookmarks.size() != before) state.bookmarks[key] = bookmarks;
  if (bookmarks.empty()) state.bookmarks.erase(key);
  if (ImGui::Button("copy")) result.copyCamera = true;
  hint(withKeys("this camera as text: what a command needs for it", state.keys, Command::copyCamera));
  ImGui::SameLine();
  if (ImGui::Button("paste")) result.pasteCamera = true;
  hint(withKeys("the camera of a text, or of a whole command", state.keys, Command::pasteCamera));
  ImGui::TreePop();
}

}  // namespace

void cameraSection(ViewerState& state, PanelResult& result) {
  if (!section(state.layout, "Camera")) return;
  sceneChoice(state);
  cameraChoice(state, result);
  viewButtons(state.keys, result);
  const bool orbit = state.settings.viewpoint.camera.empty();
  if (orbit) lens(state.camera);
  if (chooseEnum("mouse", state.preferences.hand, hands, Hand::orbit, "what a drag with the left button does") &&
      state.preferences.hand == Hand::plane)
    state.camera.orthographic = true;
  ImGui::Checkbox("turntable", &state.turntable.on);
  hint(withKeys("the camera goes round the target", state.keys, Command::turntable));
  if (state.turntable.on) {
    auto speed = static_cast<float>(state.turntable.degreesPerSecond);
    if (slider("speed", speed, -180, 180, "%.0f\xc2\xb0/s", 24, "negative: the other way"))
      state.turntable.degreesPerSecond = static_cast<double>(speed);
  }
  bookmarkList(state, result);
  if (orbit)
    ImGui::TextDisabled("theta %.0f\xc2\xb0  phi %.0f\xc2\xb0  radius %.3g m", state.camera.theta, state.camera.phi,
                        state.camera.radius);
  viewFigures(state);
}

}  // namespace facet::view
