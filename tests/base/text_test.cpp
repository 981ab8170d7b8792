#include "base/text.hpp"

#include <catch2/catch.hpp>

using namespace facet;

TEST_CASE("What strangers wrote is printable in a message, whatever it holds", "[base]") {
  CHECK(printable("caf\xc3\xa9") == "caf\xc3\xa9");
  CHECK(printable("caf\xe9") == "caf\xef\xbf\xbd");
  CHECK(printable("a\x1b[31mb\nc\td\x7f") == "a?[31mb?c d?");
  CHECK(printable(std::string_view("a\0b", 3)) == "a?b");
  CHECK(printable("abcdef", 6) == "abcdef");
  CHECK(printable("abcdef", 5) == "abcde...");
  CHECK(printable("caf\xc3\xa9", 4) == "caf...");  // not half of a character
  CHECK(inQuotes(std::string(100, 'x')) == "'" + std::string(80, 'x') + "...'");
}

TEST_CASE("A sentence of an error is printable, and the lines of a log stay lines", "[base]") {
  CHECK(describe({"a\x1b.glb", "/no\nde", "is \xff\nand more", "mend\tit"}) ==
        "a?.glb: /no?de: is \xef\xbf\xbd\nand more; mend it.");
  const std::string text = describe({"f", std::string(5000, 'k'), "p", ""});
  CHECK(text.size() < 500);
  CHECK(text.ends_with("...: p."));
}
