#include "view/letters.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include "view/style.hpp"

namespace facet::view {

void addLetters(std::string_view text, Letters& letters) {
  const char* at = text.data();
  const char* end = at + text.size();
  while (at < end) {
    if (static_cast<unsigned char>(*at) < 0x80) {
      ++at;
      continue;
    }
    unsigned letter = 0;
    at += ImTextCharFromUtf8(&letter, at, end);
    if (letter <= 0xffff && letter != 0xfffd && !isUsualLetter(letter)) letters.insert(static_cast<uint16_t>(letter));
  }
}

void addLetters(const scene::Model& model, Letters& letters) {
  const auto named = [&](const auto& list) {
    for (const auto& object : list) addLetters(object.name, letters);
  };
  named(model.scenes), named(model.nodes), named(model.meshes), named(model.materials), named(model.textures);
  named(model.images), named(model.lights), named(model.cameras), named(model.skins), named(model.animations);
  for (const std::string& variant : model.variants) addLetters(variant, letters);
  addLetters(model.name, letters);
}

}  // namespace facet::view
