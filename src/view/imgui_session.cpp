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

void restyle(Theme theme, float scale) {
  applyStyle(theme, scale);
  // The fonts' texture has to be made anew. ImGui 1.86 makes it only together with its shader, and forgets when it
  // destroys both that its buffers have no storage any more: the whole backend begins anew.
  ImGui_ImplOpenGL3_Shutdown();
  ImGui_ImplOpenGL3_Init(glslVersion);
}

bool followStyle(ImGuiSession& imgui, const Preferences& preferences) {
  const float scale = contentScale(imgui.window, preferences);
  if (scale == imgui.scale && preferences.theme == imgui.theme) return false;
  restyle(preferences.theme, scale);
  imgui.scale = scale;
  imgui.theme = preferences.theme;
  return true;
}

}  // namespace facet::view
