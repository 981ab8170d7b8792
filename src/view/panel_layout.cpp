#include "view/panel_layout.hpp"

#include <algorithm>

namespace facet::view {

SideWidths sideWidths(const PanelLayout& wished, bool leftShown, bool rightShown, float width, float em) {
  const float leastLeft = leastLeftEms * em, leastRight = leastRightEms * em, strip = foldedEms * em;
  SideWidths out;
  if (leftShown && rightShown && width < leastLeft + leastRight + leastPictureEms * em)
    out.folded = wished.last == Side::left ? Side::right : Side::left;
  const bool left = leftShown && out.folded != Side::left, right = rightShown && out.folded != Side::right;
  out.left = left ? std::max(leastLeft, wished.leftEms * em) : 0;
  out.right = right ? std::max(leastRight, wished.rightEms * em) : 0;
  // What lacks comes off what both have above their least widths.
  const float room = width - leastPictureEms * em - (out.folded ? strip : 0);
  const float spareLeft = left ? out.left - leastLeft : 0, spareRight = right ? out.right - leastRight : 0;
  const float lacking = std::max(0.0f, out.left + out.right - room), spare = spareLeft + spareRight;
  const float share = spare > 0 ? std::min(1.0f, lacking / spare) : 0;
  const float most = std::max(0.0f, width - (out.folded ? strip : 0));
  out.left = std::min(out.left - share * spareLeft, most);
  out.right = std::min(out.right - share * spareRight, most);
  if (out.folded == Side::left) out.left = std::min(strip, width);
  if (out.folded == Side::right) out.right = std::min(strip, width);
  return out;
}

}  // namespace facet::view
