#include <imgui.h>
#include <imgui/backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <glm/gtc/type_precision.hpp>
#include <vector>

#include "gl/texture.hpp"
#include "support/gpu.hpp"
#include "view/imgui_session.hpp"
#include "view/style.hpp"

using namespace facet;

namespace {

// A frame with text; how many of its pixels are not black.
int drawText() {
  constexpr int width = 64, height = 48;
  const gl::Texture color({.format = GL_RGBA8, .width = width, .height = height}, "panels");
  gl::Framebuffer target("panels");
  target.attach(GL_COLOR_ATTACHMENT0, color);
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  const glm::vec4 black(0, 0, 0, 1);
  glClearNamedFramebufferfv(target.id(), GL_COLOR, 0, &black.x);
  ImGui::GetIO().DisplaySize = {width, height};
  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  ImGui::GetForegroundDrawList()->AddText({1, 1}, IM_COL32_WHITE, "facet");
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
  std::vector<glm::u8vec4> pixels(size_t{width} * height);
  glGetTextureImage(color.id(), 0, GL_RGBA, GL_UNSIGNED_BYTE, static_cast<GLsizei>(pixels.size() * 4), pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  return static_cast<int>(std::ranges::count_if(pixels, [](const glm::u8vec4& p) { return p.r > 128; }));
}

}  // namespace

TEST_CASE("Window: theme and size of letters change between frames, again and again", "[gl]") {
  test::contextInfo();  // a current context
  glUseProgram(0);      // ImGui would return to what an earlier test may have deleted
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  view::applyStyle(view::Theme::dark, 1);
  REQUIRE(ImGui_ImplOpenGL3_Init("#version 450 core"));
  const int lit = drawText();
  CHECK(lit > 20);
  const float letters = ImGui::GetFontSize();
  for (const float scale : {1.0f, 2.0f, 1.5f, 1.0f})
    for (const view::Theme theme : {view::Theme::light, view::Theme::dark}) {
      view::restyle(theme, scale);
      CHECK(drawText() >= lit);
      CHECK(ImGui::GetIO().Fonts->IsBuilt());
      CHECK(ImGui::GetFontSize() == Approx(letters * scale).margin(1));
      CHECK((ImGui::GetStyle().Colors[ImGuiCol_WindowBg].x > 0.5f) == (theme == view::Theme::light));
    }
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

TEST_CASE("Window: letters of other scripts come from other fonts, where names need them", "[gl]") {
  view::Letters letters;
  view::addLetters(
      "Stra\xc3\x9f"
      "e, \xd7\xa9\xd7\x9c\xd7\x95\xd7\x9d, \xe4\xb8\xad\xe6\x96\x87, \xff bad",
      letters);
  CHECK(letters == view::Letters{0x05d5, 0x05dc, 0x05dd, 0x05e9, 0x4e2d, 0x6587});
  scene::Model model;
  model.nodes.resize(1), model.nodes[0].name = "\xe0\xb8\x81", model.variants = {"\xe2\x98\x85"};
  view::Letters named;
  view::addLetters(model, named);
  CHECK(named == view::Letters{0x0e01, 0x2605});

  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;
  view::applyStyle(view::Theme::dark, 1);
  const auto has = [](ImWchar letter) {
    return ImGui::GetIO().Fonts->Fonts[0]->FindGlyphNoFallback(letter) != nullptr;
  };
  ImGui::GetIO().Fonts->Build();
  CHECK(has('A'));
  CHECK_FALSE(has(0x05d0));
  CHECK_FALSE(has(0x4e2d));
  view::applyStyle(view::Theme::dark, 1, {0x05d0, 0x4e2d});
  CHECK(ImGui::GetIO().Fonts->IsBuilt());
  CHECK(has('A'));
  const auto there = [](const char* file) { return std::filesystem::exists(std::string("/usr/share/fonts/") + file); };
  if (there("truetype/dejavu/DejaVuSans.ttf")) CHECK(has(0x05d0));
  if (there("truetype/droid/DroidSansFallbackFull.ttf") || there("opentype/noto/NotoSansCJK-Regular.ttc"))
    CHECK(has(0x4e2d));
  CHECK_FALSE(has(0x05d1));  // nobody asked for it
  ImGui::DestroyContext();
}
