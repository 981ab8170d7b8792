#include "view/widgets.hpp"

#include <imgui/imgui_internal.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "base/srgb.hpp"
#include "view/listing.hpp"
#include "view/text_fit.hpp"

namespace facet::view {

bool section(PanelLayout& layout, const char* name, bool open) {
  const std::string_view whole = name;
  const size_t mark = whole.find("###");
  const std::string key(mark == std::string_view::npos ? whole : whole.substr(mark + 3));
  const auto known = layout.sections.find(key);
  if (known != layout.sections.end()) ImGui::SetNextItemOpen(known->second);
  const bool isOpen = ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
  if (ImGui::IsItemToggledOpen()) layout.sections[key] = isOpen;
  return isOpen;
}

void hint(const std::string& text) {
  if (text.empty() || !ImGui::IsItemHovered()) return;
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(24 * ImGui::GetFontSize());
  ImGui::TextUnformatted(text.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void resettableHint(const char* explanation) {
  std::string text = explanation ? explanation : "";
  text += text.empty() ? "right click: reset" : "\nright click: reset";
  hint(text);
}

bool resetAsked() { return ImGui::IsItemHovered() && ImGui::IsMouseClicked(ImGuiMouseButton_Right); }

bool numberedSlider(const char* label, float& value, float low, float high, const char* format,
                    ImGuiSliderFlags flags) {
  const auto text = [&](float number) {
    char out[64];
    std::snprintf(out, sizeof out, format, static_cast<double>(number));
    return std::string(out);
  };
  const float gap = ImGui::GetStyle().ItemInnerSpacing.x, em = ImGui::GetFontSize(), width = ImGui::CalcItemWidth();
  const float number =
      std::max({2.6f * em, ImGui::CalcTextSize(text(low).c_str()).x, ImGui::CalcTextSize(text(high).c_str()).x,
                ImGui::CalcTextSize(text(value).c_str()).x});
  ImGui::BeginGroup();
  ImGui::PushID(label);
  const bool typing = ImGui::TempInputIsActive(ImGui::GetID("##slider"));
  ImGui::SetNextItemWidth(std::max(2 * em, width - number - gap));
  const float left = ImGui::GetCursorPosX();
  // The format rounds; what it writes is written beside.
  if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(0, 0, 0, 0));
  const bool changed = ImGui::SliderFloat("##slider", &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
  if (!typing) ImGui::PopStyleColor();
  const std::string written = text(value);
  const float end = left + std::max(width, 2 * em + gap + number);
  ImGui::SameLine(0, 0);
  ImGui::SetCursorPosX(end - ImGui::CalcTextSize(written.c_str()).x);
  ImGui::TextUnformatted(written.c_str());
  const std::string_view shown = std::string_view(label).substr(0, std::string_view(label).find("##"));
  if (!shown.empty()) {
    ImGui::SameLine(0, gap);
    ImGui::TextUnformatted(shown.data(), shown.data() + shown.size());
  }
  ImGui::PopID();
  ImGui::EndGroup();
  return changed;
}

bool slider(const char* label, float& value, float low, float high, const char* format, float usual,
            const char* explanation, ImGuiSliderFlags flags) {
  bool changed = numberedSlider(label, value, low, high, format, flags);
  if (resetAsked()) value = usual, changed = true;
  resettableHint(explanation);
  return changed;
}

void editColor(const char* label, glm::vec3& linear, const glm::vec3& usual, const char* explanation) {
  float encoded[3];
  for (int c = 0; c < 3; ++c) encoded[c] = static_cast<float>(srgbFromLinear(linear[c]));
  if (ImGui::ColorEdit3(label, encoded, ImGuiColorEditFlags_NoInputs | ImGuiColorEditFlags_NoOptions))
    for (int c = 0; c < 3; ++c) linear[c] = static_cast<float>(linearFromSrgb(encoded[c]));
  if (resetAsked()) linear = usual;
  resettableHint(explanation);
}

bool searchField(const char* id, const char* emptyText, std::string& text) {
  char typed[128] = "";
  std::strncpy(typed, text.c_str(), sizeof typed - 1);
  if (!ImGui::InputTextWithHint(id, emptyText, typed, sizeof typed)) return false;
  text = typed;
  return true;
}

bool enteredField(const char* label, const char* emptyText, std::string& text) {
  char typed[128] = "";
  std::strncpy(typed, text.c_str(), sizeof typed - 1);
  if (!ImGui::InputTextWithHint(label, emptyText, typed, sizeof typed, ImGuiInputTextFlags_EnterReturnsTrue))
    return false;
  text = typed;
  return true;
}

bool beginList(const char* label, const std::string& chosen) {
  return ImGui::BeginCombo(label, chosen.c_str(), ImGuiComboFlags_HeightLarge);
}

bool beginDetails(const char* id) {
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 7.5f * ImGui::GetFontSize());
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

float textWidth(std::string_view text) { return ImGui::CalcTextSize(text.data(), text.data() + text.size()).x; }

void wrappedText(const std::string& text) {
  ImGui::BeginGroup();
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 0});
  for (const std::string& line : wrapped(text, ImGui::GetContentRegionAvail().x, textWidth))
    ImGui::TextUnformatted(line.data(), line.data() + line.size());
  ImGui::PopStyleVar();
  ImGui::EndGroup();
}

void detailName(const std::string& name) {
  ImGui::TableNextColumn();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  wrappedText(name);
  ImGui::PopStyleColor();
}

void detail(const std::string& name, const std::string& value) {
  detailName(name);
  ImGui::TableNextColumn();
  wrappedText(value);
}

std::string shortName(const std::string& source) {
  return source.starts_with("builtin:") ? source.substr(8) : fileName(source);
}

}  // namespace facet::view
