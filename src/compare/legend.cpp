#include "compare/legend.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "compare/compare.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_easy_font.h>
#pragma GCC diagnostic pop

namespace facet::compare {

namespace {

constexpr int leastWidth = 160, margin = 4, barHeight = 10, lineHeight = 12;

void fill(io::Pixels& picture, int left, int top, int right, int bottom, const std::array<uint8_t, 3>& color) {
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y)
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x)
      std::ranges::copy(color, picture.data.begin() + (static_cast<std::ptrdiff_t>(y) * picture.width + x) * 3);
}

int widthOf(std::string text) { return stb_easy_font_width(text.data()); }

void write(io::Pixels& picture, int left, int top, std::string text) {
  struct Vertex {
    float x, y, z;
    uint8_t color[4];
  };
  std::vector<Vertex> vertices(text.size() * 80);  // some 20 quads a letter at most
  const int quads = stb_easy_font_print(static_cast<float>(left), static_cast<float>(top), text.data(), nullptr,
                                        vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
  for (size_t i = 0; i < static_cast<size_t>(quads) * 4; i += 4) {
    const Vertex &a = vertices[i], &b = vertices[i + 2];  // opposite corners
    fill(picture, static_cast<int>(a.x), static_cast<int>(a.y), static_cast<int>(b.x), static_cast<int>(b.y),
         {220, 220, 220});
  }
}

}  // namespace

io::Pixels withLegend(io::Pixels map) {
  if (map.width < leastWidth) return map;
  const int top = map.height + margin, across = map.width - 2 * margin;
  map.height += 2 * margin + barHeight + 2 * lineHeight;
  map.data.resize(static_cast<size_t>(map.width) * static_cast<size_t>(map.height) * 3, 32);
  for (int x = 0; x < across; ++x) {  // the scale is that of the square root
    const double place = (x + 0.5) / across;
    fill(map, margin + x, top, margin + x + 1, top + barHeight, heatColor(place * place));
  }
  constexpr const char* numbers[] = {"0", "1/16", "1/4", "9/16", "1"};
  for (int i = 0; i < 5; ++i) {
    const int wide = widthOf(numbers[i]), middle = margin + across * i / 4 - wide / 2;
    write(map, std::clamp(middle, margin, map.width - margin - wide), top + barHeight + 3, numbers[i]);
  }
  write(map, margin, top + barHeight + 3 + lineHeight, "of display values");
  return map;
}

}  // namespace facet::compare
