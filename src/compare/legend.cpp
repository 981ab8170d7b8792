#include "compare/legend.hpp"

#include <algorithm>
#include <cmath>

#include "compare/compare.hpp"
#include "compare/letters.hpp"

namespace facet::compare {

namespace {

constexpr int leastWidth = 160, margin = 4, barHeight = 10, lineHeight = 12;

}  // namespace

io::Pixels withLegend(io::Pixels map) {
  if (map.width < leastWidth) return map;
  const int top = map.height + margin, across = map.width - 2 * margin;
  map.height += 2 * margin + barHeight + 2 * lineHeight;
  map.data.resize(static_cast<size_t>(map.width) * static_cast<size_t>(map.height) * 3, 32);
  for (int x = 0; x < across; ++x) {  // the scale is that of the square root
    const double place = (x + 0.5) / across;
    fillRectangle(map, margin + x, top, margin + x + 1, top + barHeight, heatColor(place * place));
  }
  constexpr const char* numbers[] = {"0", "1/16", "1/4", "9/16", "1"};
  for (int i = 0; i < 5; ++i) {
    const int wide = lettersWidth(numbers[i]), middle = margin + across * i / 4 - wide / 2;
    writeLetters(map, std::clamp(middle, margin, map.width - margin - wide), top + barHeight + 3, numbers[i]);
  }
  writeLetters(map, margin, top + barHeight + 3 + lineHeight, "of display values");
  return map;
}

}  // namespace facet::compare
