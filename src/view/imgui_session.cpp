#include "view/imgui_session.hpp"

#include <imgui.h>
#include <imgui/backends/imgui_impl_glfw.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>

#include "view/layout.hpp"
#include "view/style.hpp"

namespace facet::view {

namespace {

constexpr const char* glslVersion = "#version 450 core";

// The user's, else the monitor's.
float contentScale(GLFWwindow* window, const Preferences& preferences) {
  if (preferences.scale > 0) return preferences.scale;
  float x = 1, y = 1;
  glfwGetWindowContentScale(window, &x, &y);
  return std::clamp(std::max(x, y), 1.0f, 4.0f);
}

}  // namespace

ImGuiSession::ImGuiSession(GLFWwindow* shown, ViewerState& state)
    : window(shown), scale(contentScale(shown, state.preferences)), theme(state.preferences.theme) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  if (const std::filesystem::path folder = userConfigFolder(); !folder.empty()) {
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    layoutFile = (folder / "imgui.ini").string();
  }
  ImGui::GetIO().IniFilename = layoutFile.empty() ? nullptr : layoutFile.c_str();
  rememberLayout(state);
  applyStyle(theme, scale);
  ImGui_ImplGlfw_InitForOpenGL(shown, true);
  ImGui_ImplOpenGL3_Init(glslVersion);
}

ImGuiSession::~ImGuiSession() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

void restyle(Theme theme, float scale, const Letters& letters) {
  applyStyle(theme, scale, letters);
  // The fonts' texture has to be made anew. ImGui 1.86 makes it only together with its shader, and forgets when it
  // destroys both that its buffers have no storage any more: the whole backend begins anew.
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplOpenGL3_Init(glslVersion);
}

namespace {

// Ctrl+A of a text field is where A is written, too; later ImGuis see to that themselves.
int labelledKey(const HandEvent& event) {
  const std::string& label = event.label;
  const bool letter = label.size() == 1 && label[0] >= 'a' && label[0] <= 'z';
  return letter && IMGUI_VERSION_NUM < 18700 ? GLFW_KEY_A + (label[0] - 'a') : event.key;
}

}  // namespace

void beginFrame(ImGuiSession& imgui, const std::vector<HandEvent>& hands) {
  using Kind = HandEvent::Kind;
  const HandEvent* button = nullptr;
  for (const HandEvent& event : hands) {
    if (event.kind == Kind::press || event.kind == Kind::release)
      ImGui_ImplGlfw_KeyCallback(imgui.window, labelledKey(event), event.scancode,
                                 event.kind == Kind::press ? GLFW_PRESS : GLFW_RELEASE, event.modifiers);
    else if (event.kind == Kind::character)
      ImGui_ImplGlfw_CharCallback(imgui.window, event.character);
    else if (event.key >= 0 && event.key < static_cast<int>(imgui.buttons.size()))
      imgui.buttons[static_cast<size_t>(event.key)] = event.kind == Kind::buttonDown, button = &event;
  }
  ImGui_ImplOpenGL3_NewFrame();
  ImGui_ImplGlfw_NewFrame();
  ImGuiIO& io = ImGui::GetIO();
  for (size_t i = 0; i < imgui.buttons.size(); ++i) io.MouseDown[i] = imgui.buttons[i];
  if (button) io.MousePos = {static_cast<float>(button->at.x), static_cast<float>(button->at.y)};
  ImGui::NewFrame();
  // Below what panels draw behind themselves (a divider, a legend) there is room for pictures: present().
  ImGui::GetBackgroundDrawList()->ChannelsSplit(2);
  ImGui::GetBackgroundDrawList()->ChannelsSetCurrent(1);
}

bool followStyle(ImGuiSession& imgui, const Preferences& preferences, const Letters& letters) {
  const float scale = contentScale(imgui.window, preferences);
  if (scale == imgui.scale && preferences.theme == imgui.theme && letters == imgui.letters) return false;
  restyle(preferences.theme, scale, letters);
  imgui.scale = scale;
  imgui.theme = preferences.theme;
  imgui.letters = letters;
  return true;
}

}  // namespace facet::view
