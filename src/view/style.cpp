#include "view/style.hpp"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

namespace facet::view {

namespace {

// Debian, Fedora, Arch; the first that exists.
constexpr const char* fonts[] = {"/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
                                 "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
                                 "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
                                 "/usr/share/fonts/noto/NotoSans-Regular.ttf",
                                 "/usr/share/fonts/TTF/DejaVuSans.ttf",
                                 "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf"};

// Of other scripts; all that are there are asked, in this order, for what those before lack. The last ones are large.
constexpr const char* furtherFolders[] = {
    "/usr/share/fonts/truetype/dejavu/", "/usr/share/fonts/TTF/",  "/usr/share/fonts/truetype/noto/",
    "/usr/share/fonts/opentype/noto/",   "/usr/share/fonts/noto/", "/usr/share/fonts/noto-cjk/",
    "/usr/share/fonts/truetype/droid/",  "/usr/share/fonts/droid/"};
constexpr const char* furtherFonts[] = {"DejaVuSans.ttf",
                                        "NotoSansArabic-Regular.ttf",
                                        "NotoSansHebrew-Regular.ttf",
                                        "NotoSansThai-Regular.ttf",
                                        "NotoSansDevanagari-Regular.ttf",
                                        "NotoSansBengali-Regular.ttf",
                                        "NotoSansTamil-Regular.ttf",
                                        "NotoSansArmenian-Regular.ttf",
                                        "NotoSansGeorgian-Regular.ttf",
                                        "NotoSansEthiopic-Regular.ttf",
                                        "NotoSansSymbols2-Regular.ttf",
                                        "NotoSansMath-Regular.ttf",
                                        "NotoSansCJK-Regular.ttc",
                                        "DroidSansFallbackFull.ttf"};

ImVec4 grey(float value, float alpha = 1) { return {value, value, std::min(value * 1.04f, 1.0f), alpha}; }

void darkColors(ImGuiStyle& style) {
  ImGui::StyleColorsDark(&style);
  const ImVec4 accent(0.33f, 0.55f, 0.74f, 1), strong(0.42f, 0.66f, 0.86f, 1);
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = grey(0.90f);
  c[ImGuiCol_TextDisabled] = grey(0.52f);
  c[ImGuiCol_WindowBg] = grey(0.095f, 0.93f);
  c[ImGuiCol_PopupBg] = grey(0.11f, 0.98f);
  c[ImGuiCol_Border] = grey(0.26f, 0.6f);
  c[ImGuiCol_FrameBg] = grey(0.18f);
  c[ImGuiCol_FrameBgHovered] = grey(0.24f);
  c[ImGuiCol_FrameBgActive] = grey(0.28f);
  c[ImGuiCol_Button] = grey(0.22f);
  c[ImGuiCol_ButtonHovered] = grey(0.30f);
  c[ImGuiCol_ButtonActive] = accent;
  c[ImGuiCol_Header] = grey(0.155f);
  c[ImGuiCol_HeaderHovered] = grey(0.22f);
  c[ImGuiCol_HeaderActive] = grey(0.26f);
  c[ImGuiCol_SliderGrab] = {accent.x, accent.y, accent.z, 0.75f};
  c[ImGuiCol_SliderGrabActive] = strong;
  c[ImGuiCol_CheckMark] = strong;
  c[ImGuiCol_Separator] = grey(0.24f);
  c[ImGuiCol_ScrollbarBg] = grey(0.095f, 0);
  c[ImGuiCol_ScrollbarGrab] = grey(0.26f);
  c[ImGuiCol_ScrollbarGrabHovered] = grey(0.34f);
  c[ImGuiCol_ScrollbarGrabActive] = grey(0.40f);
  c[ImGuiCol_Tab] = grey(0.13f);
  c[ImGuiCol_TabHovered] = grey(0.30f);
  c[ImGuiCol_TabActive] = grey(0.24f);
  c[ImGuiCol_TabUnfocused] = c[ImGuiCol_Tab];
  c[ImGuiCol_TabUnfocusedActive] = c[ImGuiCol_TabActive];
}

void lightColors(ImGuiStyle& style) {
  ImGui::StyleColorsLight(&style);
  const ImVec4 accent(0.20f, 0.45f, 0.68f, 1), strong(0.12f, 0.36f, 0.60f, 1);
  ImVec4* c = style.Colors;
  c[ImGuiCol_Text] = grey(0.12f);
  c[ImGuiCol_TextDisabled] = grey(0.43f);
  c[ImGuiCol_WindowBg] = grey(0.94f, 0.96f);
  c[ImGuiCol_PopupBg] = grey(0.97f, 0.99f);
  c[ImGuiCol_Border] = grey(0.70f, 0.6f);
  c[ImGuiCol_FrameBg] = grey(0.86f);
  c[ImGuiCol_FrameBgHovered] = grey(0.81f);
  c[ImGuiCol_FrameBgActive] = grey(0.77f);
  c[ImGuiCol_Button] = grey(0.83f);
  c[ImGuiCol_ButtonHovered] = grey(0.76f);
  c[ImGuiCol_ButtonActive] = {0.55f, 0.72f, 0.86f, 1};
  c[ImGuiCol_Header] = grey(0.87f);
  c[ImGuiCol_HeaderHovered] = grey(0.81f);
  c[ImGuiCol_HeaderActive] = grey(0.77f);
  c[ImGuiCol_SliderGrab] = {accent.x, accent.y, accent.z, 0.75f};
  c[ImGuiCol_SliderGrabActive] = strong;
  c[ImGuiCol_CheckMark] = strong;
  c[ImGuiCol_Separator] = grey(0.78f);
  c[ImGuiCol_ScrollbarBg] = grey(0.94f, 0);
  c[ImGuiCol_ScrollbarGrab] = grey(0.76f);
  c[ImGuiCol_ScrollbarGrabHovered] = grey(0.68f);
  c[ImGuiCol_ScrollbarGrabActive] = grey(0.60f);
  c[ImGuiCol_Tab] = grey(0.89f);
  c[ImGuiCol_TabHovered] = grey(0.78f);
  c[ImGuiCol_TabActive] = grey(0.81f);
  c[ImGuiCol_TabUnfocused] = c[ImGuiCol_Tab];
  c[ImGuiCol_TabUnfocusedActive] = c[ImGuiCol_TabActive];
}

// What names in files are written in, and the signs that the panels use.
constexpr ImWchar glyphRanges[] = {0x0020, 0x052f, 0x1e00, 0x1eff, 0x2010, 0x2044, 0x2190, 0x2193, 0};

// Into the font that there is.
void mergeLetters(ImFontAtlas& atlas, float pixels, const Letters& letters) {
  if (letters.empty()) return;
  std::vector<ImWchar> ranges;
  for (const uint16_t letter : letters) ranges.insert(ranges.end(), {letter, letter});
  ranges.push_back(0);
  std::error_code ignored;
  for (const std::string font : furtherFonts)
    for (const std::string folder : furtherFolders) {
      const std::string file = folder + font;
      if (!std::filesystem::is_regular_file(file, ignored)) continue;
      ImFontConfig config;
      config.MergeMode = true;
      atlas.AddFontFromFileTTF(file.c_str(), pixels, &config, ranges.data());
    }
  atlas.Build();  // as long as the ranges are there
}

}  // namespace

bool isUsualLetter(unsigned letter) {
  for (const ImWchar* range = glyphRanges; *range; range += 2)
    if (letter >= range[0] && letter <= range[1]) return true;
  return false;
}

void applyStyle(Theme theme, float scale, const Letters& letters) {
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  theme == Theme::light ? lightColors(style) : darkColors(style);
  style.WindowRounding = 0;
  style.WindowBorderSize = 0;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = style.TabRounding = 3;
  style.GrabMinSize = 7;
  style.ScrollbarRounding = 3;
  style.ScrollbarSize = 10;
  style.WindowPadding = {12, 10};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {7, 5};
  style.ItemInnerSpacing = {6, 4};
  style.ScaleAllSizes(scale);
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  std::error_code ignored;
  const float pixels = std::round(14 * scale);
  for (const char* font : fonts)
    if (std::filesystem::is_regular_file(font, ignored) && atlas.AddFontFromFileTTF(font, pixels, nullptr, glyphRanges))
      return mergeLetters(atlas, pixels, letters);
  ImFontConfig config;
  config.SizePixels = 13 * scale;
  atlas.AddFontDefault(&config);
  mergeLetters(atlas, config.SizePixels, letters);
}

}  // namespace facet::view
