#pragma once

// What the panels are made of: controls with a tooltip, which a right click resets.

#include <imgui.h>

#include <glm/glm.hpp>
#include <string>

#include "base/choice.hpp"
#include "view/panel_layout.hpp"

namespace facet::view {

// A header that opens and closes, which the layout remembers once it has been clicked. open: until then. What is before
// "###" in its name may change.
bool section(PanelLayout& layout, const char* name, bool open = true);

// A tooltip on the last item, wrapped; at once, or where the pointer rests.
void hint(const std::string& text);

// The right mouse button on the last item: what it shows goes back to what it was made for. True where it did.
bool resetAsked();

// Its number stands beside it, where its grab does not cover it. One item for hint() and resetAsked().
bool numberedSlider(const char* label, float& value, float low, float high, const char* format,
                    ImGuiSliderFlags flags = 0);

// With `usual`: a right click returns to it, and the tooltip says so.
bool slider(const char* label, float& value, float low, float high, const char* format, float usual,
            const char* explanation, ImGuiSliderFlags flags = 0);
// Colours are linear inside and chosen as they look.
void editColor(const char* label, glm::vec3& linear, const glm::vec3& usual, const char* explanation);

// A field for what is searched. True where it has changed.
bool searchField(const char* id, const char* emptyText, std::string& text);
// A line of text that counts once Enter is pressed: true then.
bool enteredField(const char* label, const char* emptyText, std::string& text);

// A tooltip that says how to reset, too.
void resettableHint(const char* explanation);

// Ends with ImGui::EndCombo where true.
bool beginList(const char* label, const std::string& chosen);

// A list of the rows by their labels, notes as tooltips. True where the index has changed.
template <class T, size_t count>
bool chooseRow(const char* label, size_t& index, const Choice<T> (&rows)[count], size_t usual,
               const char* explanation) {
  bool changed = false;
  if (beginList(label, std::string(rows[index].label))) {
    for (size_t i = 0; i < count; ++i) {
      if (ImGui::Selectable(std::string(rows[i].label).c_str(), i == index)) index = i, changed = true;
      if (!rows[i].note.empty()) hint(std::string(rows[i].note));
    }
    ImGui::EndCombo();
    return changed;
  }
  if (resetAsked()) index = usual, changed = true;
  resettableHint(explanation);
  return changed;
}

// The same of an enumeration's values.
template <class Enum, size_t count>
bool chooseEnum(const char* label, Enum& value, const Choice<Enum> (&rows)[count], Enum usual,
                const char* explanation) {
  auto index = static_cast<size_t>(value);
  const bool changed = chooseRow(label, index, rows, static_cast<size_t>(usual), explanation);
  if (changed) value = static_cast<Enum>(index);
  return changed;
}

float textWidth(std::string_view text);
// Text in the room that is left in the line, wrapped between words and numbers.
void wrappedText(const std::string& text);

// A table of names and values; the names' column as wide as it must be.
bool beginDetails(const char* id);
void detail(const std::string& name, const std::string& value);
void detailName(const std::string& name);  // of a value that is no text

// "models/chair.glb" as "chair.glb", "builtin:poster" as "poster", "chair/scene.gltf" as it is (listing.hpp).
std::string shortName(const std::string& source);

}  // namespace facet::view
