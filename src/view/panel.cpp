#include "view/panel.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "base/srgb.hpp"
#include "commands/picture_options.hpp"
#include "optics/presets.hpp"
#include "shading/features.hpp"
#include "view/layout.hpp"
#include "view/panel_window.hpp"
#include "view/statistics_panel.hpp"
#include "view/style.hpp"
#include "view/timeline.hpp"

namespace facet::view {

namespace {

bool section(const char* name, bool open = true) {
  return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
}

// Colours are linear inside and chosen as they look.
void editColor(const char* label, glm::vec3& linear) {
  float encoded[3];
  for (int c = 0; c < 3; ++c) encoded[c] = static_cast<float>(srgbFromLinear(linear[c]));
  if (!ImGui::ColorEdit3(label, encoded, ImGuiColorEditFlags_NoInputs)) return;
  for (int c = 0; c < 3; ++c) linear[c] = static_cast<float>(linearFromSrgb(encoded[c]));
}

// Ends with ImGui::EndCombo where true. Escape closes the list.
bool beginList(const char* label, const std::string& chosen) {
  if (!ImGui::BeginCombo(label, chosen.c_str(), ImGuiComboFlags_HeightLarge)) return false;
  if (ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) ImGui::CloseCurrentPopup();
  return true;
}

template <class Enum, size_t N>
void chooseEnum(const char* label, Enum& value, const char* const (&names)[N]) {
  const auto current = static_cast<size_t>(value);
  if (!beginList(label, names[current])) return;
  for (size_t i = 0; i < N; ++i)
    if (ImGui::Selectable(names[i], i == current)) value = static_cast<Enum>(i);
  ImGui::EndCombo();
}

std::string shortName(const std::string& source) {
  if (source.starts_with("builtin:")) return source.substr(8);
  return source.substr(source.find_last_of('/') + 1);
}

void environmentSection(ViewerState& state) {
  if (!section("Environment")) return;
  frame::PictureSettings& settings = state.settings;
  const std::string& wanted = settings.environment.empty() ? state.shown.environment : settings.environment;
  if (beginList("map", shortName(wanted))) {
    for (const std::string& source : state.environments) {
      ImGui::PushID(source.c_str());
      if (ImGui::Selectable(shortName(source).c_str(), source == wanted)) settings.environment = source;
      ImGui::PopID();
    }
    ImGui::EndCombo();
  }
  ImGui::SliderFloat("rotation", &settings.environmentRotationDeg, -180, 180, "%.0f\xc2\xb0");
  ImGui::SliderFloat("strength", &settings.environmentStrength, 0, 10, "%.2f",
                     ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp);
  static constexpr const char* backgrounds[] = {"environment", "transparent", "colour"};
  chooseEnum("background", settings.background, backgrounds);
  if (settings.background == frame::Background::color) editColor("background colour", settings.backgroundColor);
}

void pictureSection(ViewerState& state) {
  if (!section("Picture")) return;
  frame::PictureSettings& settings = state.settings;
  ImGui::SliderFloat("exposure", &settings.exposureStops, -8, 8, "%+.1f stops", ImGuiSliderFlags_AlwaysClamp);
  static constexpr const char* toneMappers[] = {"none (clamp)", "Reinhard", "Uncharted 2",
                                                "ACES fit",     "AgX",      "Khronos PBR Neutral"};
  chooseEnum("tone mapper", settings.toneMapper, toneMappers);
  const int channel = std::max(0, shading::channelIndex(settings.channel));
  const auto label = [](int i) { return i == 0 ? "final picture" : shading::channelNames[i]; };
  if (beginList("show", label(channel))) {
    for (int i = 0; i < static_cast<int>(std::size(shading::channelNames)); ++i)
      if (ImGui::Selectable(label(i), i == channel)) settings.channel = shading::channelNames[i];
    ImGui::EndCombo();
  }
  if (beginList("samples", std::to_string(settings.samples))) {
    for (const int samples : {1, 2, 4, 16, 64, 256, 1024})
      if (ImGui::Selectable(std::to_string(samples).c_str(), samples == settings.samples)) settings.samples = samples;
    ImGui::EndCombo();
  } else if (ImGui::IsItemHovered()) {
    ImGui::SetTooltip("a pixel; more than 4 are gathered while the picture rests, until it has converged");
  }
}

void lightsSection(ViewerState& state) {
  if (!section("Lights")) return;
  static constexpr const char* choices[] = {"the file's", "none", "the file's and four more"};
  chooseEnum("lights", state.settings.lights, choices);
  ImGui::TextDisabled("the file has %d", state.shown.sceneLights);
  ImGui::SliderFloat("occlusion", &state.settings.occlusion, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
}

void modelsSection(ViewerState& state) {
  if (!section("Models", false)) return;
  frame::PictureSettings& settings = state.settings;
  static constexpr const char* diffuse[] = {"Lambert", "Burley", "Frostbite", "Oren-Nayar", "EON", "Call of Duty WWII"};
  static constexpr const char* fresnel[] = {"Schlick", "exact", "F82-tint"};
  static constexpr const char* distributions[] = {"GGX", "Beckmann", "Blinn"};
  static constexpr const char* maskings[] = {"Smith", "approximate", "V-cavities"};
  chooseEnum("diffuse", settings.diffuse, diffuse);
  static constexpr const char* imageLights[] = {"automatic",      "mirror direction", "shifted direction",
                                                "mean direction", "1 fitted tap",     "2 fitted taps",
                                                "3 fitted taps",  "sampled"};
  chooseEnum("environment", settings.imageLight, imageLights);
  ImGui::TextDisabled("of the lights:");
  chooseEnum("Fresnel", settings.fresnel, fresnel);
  chooseEnum("microfacets", settings.distribution, distributions);
  chooseEnum("masking", settings.masking, maskings);
}

// A variant whose name is taken by another, or missing, is called by its index.
void variantChoice(ViewerState& state) {
  const std::vector<std::string>& variants = state.shown.variants;
  if (variants.empty()) return;
  const char* own = "the file's own";
  const auto current = static_cast<size_t>(state.shown.variant);
  if (!beginList("variant", current < variants.size() ? variants[current] : own)) return;
  if (ImGui::Selectable(own, state.shown.variant < 0)) state.settings.variant.clear();
  for (size_t i = 0; i < variants.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const bool first = std::ranges::find(variants, variants[i]) == variants.begin() + static_cast<ptrdiff_t>(i);
    if (ImGui::Selectable(variants[i].c_str(), i == current))
      state.settings.variant = first && variants[i] != "variant " + std::to_string(i) ? variants[i] : std::to_string(i);
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

template <class Preset>
void presetRows(MaterialChoice& material, std::span<const Preset> presets) {
  for (const Preset& preset : presets) {
    const std::string name(preset.name);
    if (ImGui::Selectable(name.c_str(), name == material.preset)) choosePreset(material, name);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", presetText(name).c_str());
  }
}

void presetChoice(MaterialChoice& material) {
  const bool open = beginList("substance", material.preset.empty() ? "none" : material.preset);
  if (open) {
    if (ImGui::Selectable("none", material.preset.empty())) choosePreset(material, {});
    ImGui::TextDisabled("metals");
    presetRows(material, optics::metalPresets());
    ImGui::TextDisabled("dielectrics");
    presetRows(material, optics::dielectricPresets());
    ImGui::EndCombo();
  } else if (ImGui::IsItemHovered() && !material.preset.empty()) {
    ImGui::SetTooltip("%s", presetText(material.preset).c_str());
  }
}

void materialSection(ViewerState& state) {
  if (!section("Material", state.material.on || !state.shown.variants.empty())) return;
  variantChoice(state);
  MaterialChoice& material = state.material;
  ImGui::Checkbox("one for everything", &material.on);
  if (!material.on) return;
  presetChoice(material);
  editColor("base colour", material.baseColor);
  ImGui::SliderFloat("metallic", &material.metallic, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("roughness", &material.perceptualRoughness, 0, 1, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  ImGui::SliderFloat("ior", &material.ior, 1, 3, "%.3f", ImGuiSliderFlags_AlwaysClamp);
}

void cameraChoice(ViewerState& state, PanelResult& result) {
  std::string& chosen = state.settings.camera;
  if (state.shown.cameras.empty()) return;
  if (!beginList("camera", chosen.empty() ? "orbit" : chosen)) return;
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
      state.settings.scene = static_cast<int>(i);
      state.settings.camera.clear();
    }
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void cameraSection(ViewerState& state, PanelResult& result) {
  if (!section("Camera")) return;
  sceneChoice(state);
  cameraChoice(state, result);
  if (state.settings.camera.empty()) {
    auto fovY = static_cast<float>(state.camera.fovY);
    if (ImGui::SliderFloat("field of view", &fovY, 5, 120, "%.0f\xc2\xb0", ImGuiSliderFlags_AlwaysClamp))
      state.camera.fovY = fovY;
    ImGui::TextDisabled("theta %.0f\xc2\xb0  phi %.0f\xc2\xb0  radius %.3g m", state.camera.theta, state.camera.phi,
                        state.camera.radius);
  }
  result.frameAll |= ImGui::Button("frame all");
  ImGui::SameLine();
  result.resetCamera |= ImGui::Button("reset");
}

void notesSection(const ShownScene& shown) {
  if (shown.warnings.empty() && shown.infos.empty()) return;
  const size_t count = shown.warnings.size() + shown.infos.size();
  const std::string title = "Notes (" + std::to_string(count) + ")###notes";
  if (!section(title.c_str(), !shown.warnings.empty())) return;
  const auto list = [](const std::vector<std::string>& lines, ImU32 color) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    for (const std::string& line : lines) ImGui::TextWrapped("%s", line.c_str());
    ImGui::PopStyleColor();
  };
  list(shown.warnings, warningColor);
  list(shown.infos, quietColor);
}

void header(ViewerState& state, PanelResult& result) {
  ImGui::TextUnformatted(state.shown.model.empty() ? "facet" : shortName(state.shown.model).c_str());
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", state.shown.model.c_str());
  ImGui::SameLine();
  if (state.shown.statistics.gpuMs > 0) ImGui::TextDisabled("%s", milliseconds(state.shown.statistics.gpuMs).c_str());
  if (ImGui::Button("copy command")) {
    const std::string command = commands::commandLine(commandSettings(state), state.shown.model);
    ImGui::SetClipboardText(command.c_str());
    state.status = {"copied: " + command, false};
  }
  ImGui::SameLine();
  result.screenshot = ImGui::Button("screenshot");
  ImGui::Spacing();
}

// Below everything; where the panel is hidden only what is under way and what went wrong.
void statusLine(const ViewerState& state, PanelResult& result) {
  const bool loading = !state.loading.empty();
  if (!loading && !state.status.isError && !state.panelVisible) return;
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  const float height = statusHeight();
  ImGui::SetNextWindowPos({0, screen.y - height});
  ImGui::SetNextWindowSize({screen.x, height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {12, 6});
  if (ImGui::Begin("status", nullptr, fixedWindow | ImGuiWindowFlags_NoScrollbar)) {
    if (loading) {
      const int dots = static_cast<int>(ImGui::GetTime() * 3) % 4;
      ImGui::Text("loading %s %.*s", shortName(state.loading).c_str(), dots, "...");
    } else {
      if (state.status.isError) ImGui::PushStyleColor(ImGuiCol_Text, errorColor);
      ImGui::TextUnformatted(state.status.text.c_str());
      if (state.status.isError) ImGui::PopStyleColor();
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", state.status.text.c_str());
    }
    const std::string refined = refinementText(state.refinement);
    if (!refined.empty()) {
      ImGui::SameLine(std::max(0.0f, screen.x - ImGui::CalcTextSize(refined.c_str()).x - 12));
      ImGui::TextDisabled("%s", refined.c_str());
    }
    result.areas.push_back(windowArea());
  }
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace

Area windowArea() {
  const ImVec2 at = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  return {{at.x, at.y}, {at.x + size.x, at.y + size.y}};
}

void drawPanel(ViewerState& state, PanelResult& result) {
  if (state.panelVisible && state.settingsVisible) {
    if (beginSide("settings", Side::right, panelEms, result)) {
      ImGui::PushItemWidth(-7.5f * ImGui::GetFontSize());
      header(state, result);
      environmentSection(state);
      pictureSection(state);
      lightsSection(state);
      materialSection(state);
      modelsSection(state);
      cameraSection(state, result);
      statisticsSection(state);
      notesSection(state.shown);
      ImGui::PopItemWidth();
    }
    ImGui::End();
  }
  drawTimeline(state, result);
  statusLine(state, result);
}

}  // namespace facet::view
