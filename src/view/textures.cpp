#include "view/textures.hpp"

#include <imgui.h>

#include <algorithm>
#include <cstdint>

#include "frame/gpu_scene.hpp"
#include "scene/usage.hpp"
#include "view/listing.hpp"
#include "view/scene_tree.hpp"
#include "view/statistics_panel.hpp"
#include "view/text_fit.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace {

std::string formatText(const frame::TextureUse& use, GLenum format) {
  constexpr const char* names[] = {"red", "green", "blue", "alpha"};
  constexpr GLenum wide[] = {GL_R16, GL_RG16, GL_RGB16, GL_RGBA16};
  std::string text = use.srgb ? "sRGB, " : "linear, ";
  text += std::ranges::find(wide, format) != std::end(wide) ? "16 bits," : "8 bits,";
  for (int c = 0; c < 4; ++c)
    if (use.channels >> c & 1) text += std::string(" ") + names[c];
  return text;
}

std::string usersOf(const scene::Model& model, int image) {
  constexpr int most = 6;
  std::string users;
  int count = 0;
  for (size_t m = 0; m < model.materials.size(); ++m) {
    const bool uses = std::ranges::any_of(scene::textureSlots, [&](scene::TextureSlot slot) {
      const scene::TextureRef& ref = scene::textureRef(model.materials[m], slot);
      return ref && model.textures[static_cast<size_t>(ref.texture)].image == image;
    });
    if (uses && count++ < most) users += (users.empty() ? "" : ", ") + materialName(model, static_cast<int>(m));
  }
  return count > most ? users + " and " + std::to_string(count - most) + " more" : users;
}

}  // namespace

std::vector<ShownTexture> shownTextures(const scene::Model& model, const frame::GpuScene& gpu) {
  std::vector<ShownTexture> textures;
  for (const auto& [use, texture] : gpu.textures) {
    if (use.image < 0 || static_cast<size_t>(use.image) >= model.images.size()) continue;
    const gl::TextureDescription& is = texture.description();
    textures.push_back({use.image, model.images[static_cast<size_t>(use.image)].name, texture.id(), is.width, is.height,
                        is.levels, formatText(use, is.format), texture.bytes(), usersOf(model, use.image)});
  }
  return textures;
}

void textureHint(const ShownTexture& texture) {
  if (!ImGui::IsItemHovered()) return;
  const float em = ImGui::GetFontSize(), most = 18 * em;
  const auto width = static_cast<float>(texture.width), height = static_cast<float>(texture.height);
  const float scale = most / std::max({width, height, 1.0f});
  ImGui::BeginTooltip();
  ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture.id)), {width * scale, height * scale});
  ImGui::PushTextWrapPos(most);
  ImGui::Text("%s", texture.name.c_str());
  ImGui::Text("%d x %d, %d levels, %s", texture.width, texture.height, texture.levels, byteText(texture.bytes).c_str());
  ImGui::Text("%s", texture.format.c_str());
  if (!texture.users.empty()) ImGui::Text("of %s", texture.users.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void textureList(const std::vector<ShownTexture>& textures, const std::string& filter) {
  const float em = ImGui::GetFontSize(), size = 2.4f * em;
  if (textures.empty()) ImGui::TextDisabled("none is loaded");
  for (const ShownTexture& texture : textures) {
    if (!hasWords(texture.name, filter)) continue;
    ImGui::PushID(&texture);
    ImGui::BeginGroup();
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<intptr_t>(texture.id)), {size, size});
    ImGui::SameLine();
    ImGui::BeginGroup();
    ImGui::TextUnformatted(middleCut(texture.name, ImGui::GetContentRegionAvail().x, textWidth).c_str());
    ImGui::TextDisabled("%d x %d, %s", texture.width, texture.height, byteText(texture.bytes).c_str());
    ImGui::EndGroup();
    ImGui::EndGroup();
    textureHint(texture);
    ImGui::PopID();
  }
}

}  // namespace facet::view
