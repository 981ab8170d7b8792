#include "frame/left_out.hpp"

#include <algorithm>

namespace facet::frame {

namespace {

bool computed(const frame::PictureStatistics& statistics, const char* name) {
  return std::ranges::any_of(statistics.tables, [&](const ibl::TableStatistics& t) { return t.name == name; });
}

void addOnce(std::vector<std::string>& list, const std::string& text) {
  if (std::ranges::find(list, text) == list.end()) list.push_back(text);
}

}  // namespace

std::vector<std::string> leftOut(const scene::Model& model, const frame::PictureStatistics& statistics) {
  std::vector<std::string> out;
  const auto images = static_cast<int>(model.images.size());
  if (statistics.imagesDecoded < images)
    out.push_back(std::to_string(images - statistics.imagesDecoded) + " of " + std::to_string(images) +
                  " images not decoded by this picture: nothing that it draws reads them, or they were there already");
  if (!computed(statistics, "DFG")) out.emplace_back("no DFG table computed: nothing is lit, or it was there already");
  if (!computed(statistics, "LD layers"))
    out.emplace_back("no environment filtered: nothing reflects one, or it was there already");
  const auto textured = [](const scene::Material& m) { return m.occlusion && m.occlusionStrength > 0; };
  if (statistics.visibility.method != "none" && std::ranges::any_of(model.materials, textured))
    out.emplace_back("occlusion textures not read: rays find what they stand for");
  if (statistics.visibility.method == "paths") {
    out.emplace_back("no draws, no vertex buffers: rays meet everything");
    return out;
  }
  if (!statistics.traced) out.emplace_back("no trees for rays: " + statistics.visibility.why);
  for (const char* pass : {"sky", "blend", "resolve"})
    if (std::ranges::find(statistics.frame.passes, pass) == statistics.frame.passes.end())
      out.push_back(std::string("no ") + pass + " pass");
  return out;
}

std::vector<MaterialUsage> materialUsage(const scene::Model& model, const frame::DrawList& list) {
  std::vector<MaterialUsage> out(list.materials.size());
  std::vector<bool> drawn(list.materials.size(), false);
  for (size_t i = 0; i < out.size(); ++i)
    out[i].name = !list.materials[i].name.empty() ? list.materials[i].name
                  : i < model.materials.size()    ? "material " + std::to_string(i)
                                                  : "default material";
  for (const std::vector<frame::Draw>* draws : list.classes())
    for (const frame::Draw& draw : *draws) {
      const auto index = static_cast<size_t>(draw.material);
      const scene::Material& material = list.materials[index];
      drawn[index] = true;
      addOnce(out[index].variants, shading::variantName(draw.key));
      for (const scene::TextureSlot slot : scene::textureSlots)
        if (textureRef(material, slot)) {
          const bool read = shading::samplesSlot({material, *draw.primitive, list.features}, slot);
          addOnce(read ? out[index].textures : out[index].unusedTextures, scene::name(slot));
        }
    }
  for (MaterialUsage& usage : out)
    std::erase_if(usage.unusedTextures, [&](const std::string& name) {
      return std::ranges::find(usage.textures, name) != usage.textures.end();
    });
  std::vector<MaterialUsage> result;
  for (size_t i = 0; i < out.size(); ++i)
    if (drawn[i] || i < model.materials.size()) result.push_back(std::move(out[i]));
  return result;
}

}  // namespace facet::frame
