#include "view/widgets.hpp"

#include <cstring>

#include "base/srgb.hpp"

namespace facet::view {

bool section(const char* name, bool open) {
  return ImGui::CollapsingHeader(name, open ? ImGuiTreeNodeFlags_DefaultOpen : 0);
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

bool slider(const char* label, float& value, float low, float high, const char* format, float usual,
            const char* explanation, ImGuiSliderFlags flags) {
  bool changed = ImGui::SliderFloat(label, &value, low, high, format, flags | ImGuiSliderFlags_AlwaysClamp);
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

bool beginList(const char* label, const std::string& chosen) {
  return ImGui::BeginCombo(label, chosen.c_str(), ImGuiComboFlags_HeightLarge);
}

bool beginDetails(const char* id) {
  if (!ImGui::BeginTable(id, 2)) return false;
  ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, 7.5f * ImGui::GetFontSize());
  ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
  return true;
}

void detail(const std::string& name, const std::string& value) {
  ImGui::TableNextColumn();
  ImGui::TextDisabled("%s", name.c_str());
  if (ImGui::CalcTextSize(name.c_str()).x > 7.5f * ImGui::GetFontSize()) hint(name);
  ImGui::TableNextColumn();
  ImGui::TextWrapped("%s", value.c_str());
}

std::string shortName(const std::string& source) {
  if (source.starts_with("builtin:")) return source.substr(8);
  return source.substr(source.find_last_of('/') + 1);
}

}  // namespace facet::view
