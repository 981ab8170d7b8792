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
  ImGui_ImplOpenGL3_Init("#version 450 core");
}

ImGuiSession::~ImGuiSession() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplGlfw_Shutdown();
  ImGui::DestroyContext();
}

bool followStyle(ImGuiSession& imgui, const Preferences& preferences) {
  const float scale = contentScale(imgui.window, preferences);
  if (scale == imgui.scale && preferences.theme == imgui.theme) return false;
  applyStyle(preferences.theme, scale);
  ImGui_ImplOpenGL3_DestroyFontsTexture();  // made anew by the next frame
  imgui.scale = scale;
  imgui.theme = preferences.theme;
  return true;
}

}  // namespace facet::view
