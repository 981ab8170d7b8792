#include "view/bookmarks.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;
using view::Bookmark;
using view::Bookmarks;

TEST_CASE("bookmarks: what is kept is read again, by model") {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "deep" / "bookmarks.json";
  CHECK(view::readBookmarks(file).value().empty());
  Bookmarks bookmarks;
  std::vector<Bookmark>& chair = bookmarks["/models/chair.glb"];
  view::keepBookmark(chair, "front", "--orbit 0,90,3");
  view::keepBookmark(chair, "", "--orbit 10,90,3");
  view::keepBookmark(chair, "front", "--orbit 0,80,3");  // takes the place of the first
  view::keepBookmark(chair, "", "--roll 3");
  view::keepBookmark(bookmarks["builtin:poster"], "a/b ~", "--up z");
  CHECK(chair ==
        std::vector<Bookmark>{{"front", "--orbit 0,80,3"}, {"camera 2", "--orbit 10,90,3"}, {"camera 3", "--roll 3"}});
  REQUIRE(view::writeBookmarks(file, bookmarks));
  CHECK(view::readBookmarks(file).value() == bookmarks);
  view::keepBookmark(chair, std::string(500, 'x') + "\n", "");
  CHECK(chair.back().name.size() <= 63);
  CHECK_FALSE(view::writeBookmarks(file / "deeper" / "bookmarks.json", bookmarks));
  CHECK(view::bookmarkKey("builtin:poster") == "builtin:poster");
  CHECK(view::bookmarkKey("a/../b.glb") == (std::filesystem::current_path() / "b.glb").string());
}

TEST_CASE("bookmarks: what is wrong in the file is told with its place") {
  const test::TemporaryFolder folder;
  const auto place = [&](const char* text) {
    return view::readBookmarks(folder.write("bookmarks.json", text)).error().place;
  };
  CHECK(place("[]") == "");
  CHECK(place("{") == "");
  CHECK(place(R"({"a/b": 3})") == "/a~1b");
  CHECK(place(R"({"a": {"n": 1}})") == "/a/n");
}
