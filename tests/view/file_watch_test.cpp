#include "view/file_watch.hpp"

#include <catch2/catch.hpp>

#include "support/temporary_folder.hpp"

using namespace facet;
using namespace std::chrono_literals;

TEST_CASE("file watch: a change is told once, as soon as the file rests") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("a.gltf", std::string("1")), buffer = folder.write("a.bin", std::string("1"));
  auto now = std::chrono::steady_clock::now();
  view::FileWatch watch = view::watchFiles({model, buffer}, now);
  const auto look = [&] { return view::filesChanged(watch, now += 500ms); };
  CHECK_FALSE(look());
  CHECK_FALSE(look());
  folder.write("a.bin", std::string("22"));
  CHECK_FALSE(look());  // may still be being written
  folder.write("a.bin", std::string("333"));
  CHECK_FALSE(look());  // and was
  CHECK(look());
  CHECK_FALSE(look());
  CHECK_FALSE(look());
  std::filesystem::last_write_time(model, std::filesystem::last_write_time(model) + 1s);  // same size
  CHECK_FALSE(view::filesChanged(watch, now + 100ms));                                    // not yet time to look
  CHECK_FALSE(look());
  CHECK(look());
}

TEST_CASE("file watch: a file that goes and comes back changed, and one that comes into being") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("a.gltf", std::string("1"));
  auto now = std::chrono::steady_clock::now();
  view::FileWatch watch = view::watchFiles({model, folder.file("image.png")}, now);
  const auto look = [&] { return view::filesChanged(watch, now += 500ms); };
  std::filesystem::remove(model);
  CHECK_FALSE(look());
  CHECK_FALSE(look());
  CHECK_FALSE(look());
  folder.write("a.gltf", std::string("22"));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK_FALSE(look());
  folder.write("image.png", std::string("1"));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK_FALSE(look());
}

TEST_CASE("file watch: of very many files the first are watched") {
  const std::vector<std::filesystem::path> many(view::watchedFiles + 100, "/nothing/here");
  CHECK(view::watchFiles(many, {}).files.size() == view::watchedFiles);
  view::FileWatch none = view::watchFiles({}, {});
  CHECK_FALSE(view::filesChanged(none, std::chrono::steady_clock::now()));
}
