#include "shading/choices.hpp"

#include <cctype>

#include "optics/color.hpp"
#include "optics/models.hpp"
#include "shading/features.hpp"

namespace facet::shading {

std::string defineName(std::string_view word) {
  std::string name;
  for (const char c : word) {
    const auto letter = static_cast<unsigned char>(c);
    if (std::isupper(letter)) name += '_';
    name += c == '-' ? '_' : static_cast<char>(std::toupper(letter));
  }
  return name;
}

std::string choicesText() {
  std::string text;
  const auto define = [&](const std::string& name, int value) {
    text += "#define " + name + " " + std::to_string(value) + "\n";
  };
  const auto add = [&](const char* prefix, const auto& rows) {
    for (const auto& row : rows) define(prefix + defineName(row.word), static_cast<int>(row.value));
  };
  add("DIFFUSE_", optics::diffuseModels);
  add("FRESNEL_", optics::fresnelModels);
  add("NDF_", optics::distributions);
  add("MASKING_", optics::maskings);
  add("IMAGE_LIGHT_", optics::imageLights);
  define("IMAGE_LIGHT_USUAL", static_cast<int>(optics::usualLookUp));
  add("ENERGY_", optics::energyModels);
  add("CHANNEL_", channels);
  add("TONE_", optics::toneMappers);
  return text;
}

}  // namespace facet::shading
