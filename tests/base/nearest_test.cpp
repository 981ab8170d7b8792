#include "base/nearest.hpp"

#include <catch2/catch.hpp>
#include <vector>

TEST_CASE("the nearest name is found, a far one is not suggested") {
  struct Row {
    std::string_view typed, expected;
  };
  const Row row = GENERATE(Row{"neutral", "neutral"}, Row{"niutral", "neutral"}, Row{"NEUTRAL", "neutral"},
                           Row{"nuetral", "neutral"},  // swapped neighbours are one slip
                           Row{"agc", "agx"}, Row{"xga", ""}, Row{"", ""}, Row{"filmic", ""}, Row{"ace", "aces"},
                           Row{"rheinhard", "reinhard"}, Row{"unchrated", "uncharted2"});
  const std::vector<std::string_view> names = {"none", "reinhard", "uncharted2", "aces", "agx", "neutral"};
  CAPTURE(row.typed);
  CHECK(facet::nearest(row.typed, names) == row.expected);
}

TEST_CASE("of equally near names the first is taken, of none none") {
  const std::vector<std::string_view> names = {"cat", "bat"};
  CHECK(facet::nearest("rat", names) == "cat");
  CHECK(facet::nearest("rat", {}) == "");
  CHECK(facet::nearest(std::string(100'000, 'x'), names) == "");
}

TEST_CASE("a suggestion names the nearest or lists them all") {
  const std::vector<std::string_view> names = {"scene", "none", "demo"};
  CHECK(facet::suggestion("dmeo", names) == "perhaps demo is meant");
  CHECK(facet::suggestion("everything", names) == "choose one of scene, none, demo");
}
