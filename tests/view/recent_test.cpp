#include "view/recent.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("recent files: the newest comes first, once, those that have gone are dropped, the number is bounded") {
  const test::TemporaryFolder folder;
  const std::filesystem::path list = folder.path() / "state/facet/recent";
  CHECK(view::readRecent(list).empty());
  const std::string a = folder.write("a.glb", std::string("x")), b = folder.write("b.glb", std::string("x"));
  view::noteRecent(list, a);
  view::noteRecent(list, b);
  CHECK(view::readRecent(list) == std::vector<std::string>{b, a});
  view::noteRecent(list, folder.file("./a.glb"));
  CHECK(view::readRecent(list) == std::vector<std::string>{a, b});
  view::noteRecent(list, "builtin:spheres");
  view::noteRecent(list, folder.file("missing.glb"));
  view::noteRecent({}, a);
  CHECK(view::readRecent(list) == std::vector<std::string>{a, b});
  std::filesystem::remove(a);
  CHECK(view::readRecent(list) == std::vector<std::string>{b});

  for (size_t i = 0; i < view::keptRecent + 5; ++i)
    view::noteRecent(list, folder.write(std::to_string(i) + ".glb", std::string("x")));
  const std::vector<std::string> kept = view::readRecent(list);
  CHECK(kept.size() == view::keptRecent);
  CHECK(kept.front() == folder.file(std::to_string(view::keptRecent + 4) + ".glb"));
  // Nothing is left of the writing.
  CHECK(std::distance(std::filesystem::directory_iterator(list.parent_path()), {}) == 1);
}

TEST_CASE("recent files: a list that holds rubbish is none") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("recent", std::string("relative.glb\n\n/\n\0\xff\n/missing.glb\n", 31));
  CHECK(view::readRecent(file).empty());
}
