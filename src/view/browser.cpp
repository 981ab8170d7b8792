#include "view/browser.hpp"

#include <imgui.h>

#include "scene/builtin_scenes.hpp"
#include "view/layout.hpp"

namespace facet::view {

void drawBrowser(ViewerState& state, PanelResult& result) {
  if (!state.panelVisible || !state.browserVisible) return;
  if (beginSide("browser", Side::left, 17, result)) {
    if (ImGui::CollapsingHeader("Models", ImGuiTreeNodeFlags_DefaultOpen))
      for (const scene::BuiltinScene& scene : scene::builtinScenes()) {
        const std::string source = "builtin:" + std::string(scene.name);
        if (ImGui::Selectable(source.c_str(), source == state.shown.model)) result.model = source;
      }
    if (ImGui::CollapsingHeader("Environments", ImGuiTreeNodeFlags_DefaultOpen))
      for (const std::string& source : state.environments)
        if (ImGui::Selectable(source.c_str(), source == state.shown.environment)) state.settings.environment = source;
  }
  ImGui::End();
}

}  // namespace facet::view
