#include "compare/side_by_side.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "compare/letters.hpp"

namespace facet::compare {

namespace {

constexpr int gap = 4, titleHeight = 14;
constexpr std::array<uint8_t, 3> ground = {32, 32, 32}, below = {128, 128, 128};

std::array<uint8_t, 3> colorAt(const io::Pixels& picture, int x, int y) {
  const auto channels = static_cast<size_t>(picture.channels);
  const uint8_t* const pixel =
      &picture.data[(static_cast<size_t>(y) * static_cast<size_t>(picture.width) + static_cast<size_t>(x)) * channels];
  const double alpha = channels % 2 == 0 ? pixel[channels - 1] / 255.0 : 1;
  std::array<uint8_t, 3> color{};
  for (size_t c = 0; c < 3; ++c)
    color[c] = static_cast<uint8_t>(std::lround(alpha * pixel[channels < 3 ? 0 : c] + (1 - alpha) * below[c]));
  return color;
}

}  // namespace

io::Pixels sideBySide(std::span<const Titled> pictures, int columns) {
  columns = std::max(1, std::min(columns, static_cast<int>(pictures.size())));
  int width = 1, height = 1;
  for (const Titled& titled : pictures)
    width = std::max(width, titled.picture.width), height = std::max(height, titled.picture.height);
  const int rows = (static_cast<int>(pictures.size()) + columns - 1) / columns;
  io::Pixels all;
  all.width = columns * width + (columns + 1) * gap, all.height = rows * (height + titleHeight + gap) + gap;
  all.channels = 3;
  all.data.assign(static_cast<size_t>(all.width) * static_cast<size_t>(all.height) * 3, ground[0]);
  for (size_t i = 0; i < pictures.size(); ++i) {
    const int left = gap + (static_cast<int>(i) % columns) * (width + gap);
    const int top = gap + (static_cast<int>(i) / columns) * (height + titleHeight + gap);
    writeLetters(all, left, top + 2, fittedLetters(pictures[i].title, width));
    const io::Pixels& picture = pictures[i].picture;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        std::ranges::copy(
            colorAt(picture, x, y),
            all.data.begin() + (static_cast<std::ptrdiff_t>(top + titleHeight + y) * all.width + left + x) * 3);
  }
  return all;
}

}  // namespace facet::compare
