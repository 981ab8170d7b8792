#pragma once

#include "view/letters.hpp"
#include "view/preferences.hpp"

namespace facet::view {

// Quiet colours and a readable font: a system's sans serif where one is found, else ImGui's own. scale: of letters and
// controls, 1 for 96 dpi. May be called again with others between frames; the texture that the backend made of the
// old fonts has to go then.
// letters: more that names need, from other fonts that are installed; what none has is a question mark.
void applyStyle(Theme theme, float scale, const Letters& letters = {});

// Latin, Greek, Cyrillic, and the signs that the panels use.
bool isUsualLetter(unsigned letter);

// Colours of text beside the ordinary one, 0xAABBGGRR; readable in both themes.
inline constexpr unsigned errorColor = 0xff4d55e0, warningColor = 0xff1e80cf, quietColor = 0xff8c8883;

}  // namespace facet::view
