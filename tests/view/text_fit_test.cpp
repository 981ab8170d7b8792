#include "view/text_fit.hpp"

#include <catch2/catch.hpp>

using namespace facet;

namespace {

// Each sign is one wide.
float width(std::string_view text) {
  float count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0) != 0x80 ? 1 : 0;
  return count;
}

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("text fit: a name keeps its end, and is cut in its middle") {
  CHECK(view::middleCut("aristea_wreck_1k.hdr", 20, width) == "aristea_wreck_1k.hdr");
  CHECK(view::middleCut("aristea_wreck_1k.hdr", 11, width) == "arist\xe2\x80\xa6k.hdr");
  CHECK(view::middleCut("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\xa4\xc3\xb6\xc3\xbc", 4, width) ==
        "\xc3\xa4\xe2\x80\xa6\xc3\xb6\xc3\xbc");
  CHECK(view::middleCut("chair", 1, width) == "\xe2\x80\xa6");
  CHECK(view::middleCut("chair", 0, width) == "\xe2\x80\xa6");
  CHECK(view::middleCut("", 0, width).empty());
}

TEST_CASE("text fit: no line breaks a number, nor a word that a line has room for") {
  CHECK(view::wrapped("0.1234  -0.5678  9.0123", 16, width) == Lines{"0.1234  -0.5678", "9.0123"});
  CHECK(view::wrapped("0.1234  -0.5678  9.0123", 7, width) == Lines{"0.1234", "-0.5678", "9.0123"});
  CHECK(view::wrapped("a b\nc", 10, width) == Lines{"a b", "c"});
  CHECK(view::wrapped("", 10, width) == Lines{""});
  CHECK(view::wrapped("a\n\nb", 10, width) == Lines{"a", "", "b"});
  CHECK(view::wrapped("models/chairs/a.glb is", 9, width) == Lines{"models/", "chairs/", "a.glb is"});
  CHECK(view::wrapped("wooden", 4, width) == Lines{"wood", "en"});
  CHECK(view::wrapped("wooden", 0, width) == Lines{"w", "o", "o", "d", "e", "n"});
}
