#include "compare/letters.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb_easy_font.h>
#pragma GCC diagnostic pop

namespace facet::compare {

namespace {

std::string inAscii(const std::string& text) {
  std::string ascii;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xc0) == 0x80) continue;  // of the sign before
    ascii += byte >= 32 && byte < 127 ? c : '?';
  }
  return ascii;
}

}  // namespace

void fillRectangle(io::Pixels& picture, int left, int top, int right, int bottom, const std::array<uint8_t, 3>& color) {
  for (int y = std::max(top, 0); y < std::min(bottom, picture.height); ++y)
    for (int x = std::max(left, 0); x < std::min(right, picture.width); ++x)
      std::ranges::copy(color, picture.data.begin() + (static_cast<std::ptrdiff_t>(y) * picture.width + x) * 3);
}

int lettersWidth(std::string text) {
  text = inAscii(text);
  return stb_easy_font_width(text.data());
}

void writeLetters(io::Pixels& picture, int left, int top, std::string text) {
  struct Vertex {
    float x, y, z;
    uint8_t color[4];
  };
  text = inAscii(text);
  std::vector<Vertex> vertices(text.size() * 80);  // some 20 quads a letter at most
  const int quads = stb_easy_font_print(static_cast<float>(left), static_cast<float>(top), text.data(), nullptr,
                                        vertices.data(), static_cast<int>(vertices.size() * sizeof(Vertex)));
  for (size_t i = 0; i < static_cast<size_t>(quads) * 4; i += 4) {
    const Vertex &a = vertices[i], &b = vertices[i + 2];  // opposite corners
    fillRectangle(picture, static_cast<int>(a.x), static_cast<int>(a.y), static_cast<int>(b.x), static_cast<int>(b.y),
                  {220, 220, 220});
  }
}

std::string fittedLetters(const std::string& text, int width) {
  std::string whole = inAscii(text);
  if (lettersWidth(whole) <= width) return whole;
  while (!whole.empty() && lettersWidth("..." + whole) > width) whole.erase(0, 1);
  return "..." + whole;
}

}  // namespace facet::compare
