#include "compare/side_by_side.hpp"

#include <catch2/catch.hpp>

#include "compare/letters.hpp"

using namespace facet;
using compare::Titled;

TEST_CASE("side by side: each picture is whole, below its title, over grey where it lets shine through") {
  io::Pixels red{.width = 3, .height = 2, .channels = 3, .data = {}},
      grey{.width = 2, .height = 2, .channels = 2, .data = {}};
  for (int i = 0; i < 6; ++i) red.data.insert(red.data.end(), {200, 10, 20});
  for (int i = 0; i < 4; ++i) grey.data.insert(grey.data.end(), {uint8_t{200}, static_cast<uint8_t>(i < 2 ? 255 : 0)});
  const Titled three[] = {{"A", red}, {"", grey}, {"C", red}};
  const io::Pixels all = compare::sideBySide(three, 2);
  CHECK(all.width == 2 * 3 + 3 * 4);
  CHECK(all.height == 2 * (2 + 14 + 4) + 4);
  const auto at = [&](int x, int y) {
    const auto i = static_cast<size_t>((y * all.width + x) * 3);
    return std::array<int, 3>{all.data[i], all.data[i + 1], all.data[i + 2]};
  };
  const std::array<int, 3> color = {200, 10, 20}, ground = {32, 32, 32};
  CHECK(at(4, 18) == color);
  CHECK(at(6, 19) == color);
  CHECK(at(7, 18) == ground);
  CHECK(at(11, 18) == std::array<int, 3>{200, 200, 200});
  CHECK(at(11, 19) == std::array<int, 3>{128, 128, 128});
  CHECK(at(13, 19) == ground);  // it is narrower
  CHECK(at(4, 38) == color);
  CHECK(at(11, 38) == ground);  // there is no fourth
  int letters = 0;
  for (int y = 4; y < 18; ++y)
    for (int x = 0; x < 8; ++x) letters += at(x, y)[0] == 220;
  CHECK(letters > 0);
}

TEST_CASE("letters: what does not fit keeps its end") {
  CHECK(compare::fittedLetters("chair.glb", 1000) == "chair.glb");
  const std::string cut = compare::fittedLetters("/a/very/long/folder/chair.glb", 80);
  CHECK(cut.starts_with("..."));
  CHECK(cut.ends_with("chair.glb"));
  CHECK(compare::lettersWidth(cut) <= 80);
  CHECK(compare::fittedLetters("Stühle", 1000) == "St?hle");
}
