#pragma once

// Small letters in pictures of 3 channels.

#include <array>
#include <string>

#include "io/image.hpp"

namespace facet::compare {

void fillRectangle(io::Pixels& picture, int left, int top, int right, int bottom, const std::array<uint8_t, 3>& color);

int lettersWidth(std::string text);
// What other letters than ASCII's there are become question marks.
void writeLetters(io::Pixels& picture, int left, int top, std::string text);
// As much of its end as fits, after "...".
std::string fittedLetters(const std::string& text, int width);

}  // namespace facet::compare
