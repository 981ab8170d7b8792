#include "base/whole_number.hpp"

#include <catch2/catch.hpp>

using facet::wholeNumber;

TEST_CASE("A whole number is all of the text or none of it") {
  CHECK(wholeNumber("0") == 0);
  CHECK(wholeNumber("-12") == -12);
  CHECK(wholeNumber("2147483647") == 2147483647);
  for (const char* text : {"", "1 ", " 1", "+1", "1.5", "0x1", "2147483648", "one"}) {
    INFO(text);
    CHECK_FALSE(wholeNumber(text));
  }
}
