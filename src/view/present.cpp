#include "view/present.hpp"

#include <epoxy/gl.h>
#include <imgui.h>
#include <imgui/backends/imgui_impl_opengl3.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace facet::view {

namespace {

// The display picture has been through the sRGB curve already: it is copied as it is.
// A smaller one as large as the whole one.
void copyToWindow(const frame::Targets& targets, const frame::Targets& whole) {
  glDisable(GL_FRAMEBUFFER_SRGB);
  const bool smaller = targets.width != whole.width || targets.height != whole.height;
  glBlitNamedFramebuffer(targets.shown.id(), 0, 0, 0, targets.width, targets.height, 0, 0, whole.width, whole.height,
                         GL_COLOR_BUFFER_BIT, smaller ? GL_LINEAR : GL_NEAREST);
}

// A picture of the window's size, blended by its straight alpha.
void layOver(const gl::Texture& picture) {
  const auto name = static_cast<uintptr_t>(picture.id());
  ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(name), {0, 0}, ImGui::GetIO().DisplaySize,
                                           {0, 1}, {1, 0});
}

// The same of one whose colours are times its alpha.
void layOverPremultiplied(const gl::Texture& picture) {
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  draw.AddCallback([](const ImDrawList*, const ImDrawCmd*) { glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA); }, nullptr);
  layOver(picture);
  draw.AddCallback(ImDrawCallback_ResetRenderState, nullptr);
}

// Behind a transparent picture: checks, over which ImGui blends the display picture's straight alpha.
void drawOverChecks(const frame::Targets& targets) {
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  constexpr float step = 16;
  draw.AddRectFilled({0, 0}, size, IM_COL32(92, 92, 92, 255));
  for (int y = 0; static_cast<float>(y) * step < size.y; ++y)
    for (int x = y % 2; static_cast<float>(x) * step < size.x; x += 2) {
      const ImVec2 at(static_cast<float>(x) * step, static_cast<float>(y) * step);
      draw.AddRectFilled(at, {at.x + step, at.y + step}, IM_COL32(112, 112, 112, 255));
    }
  layOver(targets.display);
}

}  // namespace

void present(GLFWwindow* window, const Viewport& viewport, const ViewerState& state) {
  const bool transparent = state.settings.frame.background == frame::Background::transparent;
  ImGui::GetBackgroundDrawList()->ChannelsSetCurrent(0);
  const frame::Targets& shown = viewport.moving.showsSmall ? viewport.moving.small : viewport.targets;
  if (shown.shown && transparent) drawOverChecks(shown);
  if (viewport.truthView.pair.shown && viewport.refinement.shown) layOver(viewport.truthView.pair.picture);
  if (viewport.second.pair.shown && !viewport.moving.showsSmall) layOver(viewport.second.pair.picture);
  if (viewport.errorView.shown && viewport.refinement.shown) layOver(viewport.errorView.picture);
  if (viewport.overlay.shown) layOverPremultiplied(viewport.overlay.targets.color);
  if (viewport.outline.shown) layOver(viewport.outline.line);
  ImGui::GetBackgroundDrawList()->ChannelsMerge();
  ImGui::Render();
  int width = 0, height = 0;
  glfwGetFramebufferSize(window, &width, &height);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, width, height);
  constexpr float grey[] = {0.1f, 0.1f, 0.1f, 1};
  glClearNamedFramebufferfv(0, GL_COLOR, 0, grey);
  if (shown.shown && !transparent) copyToWindow(shown, viewport.targets);
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  glfwSwapBuffers(window);
}

}  // namespace facet::view
