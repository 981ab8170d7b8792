#pragma once

namespace facet::view {

// Dark, quiet colours and a readable font: a system's sans serif where one is found, else ImGui's own. scale: the
// monitor's, 1 for 96 dpi.
void applyStyle(float scale);

// Colours of text beside the ordinary one, 0xAABBGGRR.
inline constexpr unsigned errorColor = 0xff7a86ff, warningColor = 0xff6cc4ff, quietColor = 0xffa8a29c;

}  // namespace facet::view
