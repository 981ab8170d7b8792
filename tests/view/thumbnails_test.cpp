#include "view/thumbnails.hpp"

#include <catch2/catch.hpp>
#include <chrono>

#include "support/temporary_folder.hpp"

using namespace facet;
using namespace std::chrono_literals;
using view::FileKind;

namespace {

// Waits for one; at most 20 s.
std::optional<view::ThumbnailMade> await(view::ThumbnailMaker& maker) {
  for (int i = 0; i < 2000; ++i) {
    std::vector<view::ThumbnailMade> made = maker.take();
    if (!made.empty()) return std::move(made.front());
    std::this_thread::sleep_for(10ms);
  }
  return std::nullopt;
}

// A program that answers in place of "facet render SOURCE -o PICTURE ...": `script` sees the picture as $OUT.
std::string program(const test::TemporaryFolder& folder, const std::string& name, const std::string& script) {
  const std::string path =
      folder.write(name, "#!/bin/sh\nOUT=$4\necho run >>" + folder.file("runs") + "\n" + script + "\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  return path;
}

size_t runs(const test::TemporaryFolder& folder) {
  std::error_code none;
  const uintmax_t bytes = std::filesystem::file_size(folder.file("runs"), none);
  return none ? 0 : bytes / 4;
}

}  // namespace

TEST_CASE("thumbnails: the key changes with path, time and size") {
  const test::TemporaryFolder folder;
  const std::string a = folder.write("a.glb", std::string("1")), b = folder.write("b.glb", std::string("1"));
  const auto key = [](const std::string& source) { return view::thumbnailKey({FileKind::model, source}); };
  const std::string before = key(a);
  CHECK(before == key(a));
  CHECK(before != key(b));
  const auto time = std::filesystem::last_write_time(a);
  folder.write("a.glb", std::string("22"));
  std::filesystem::last_write_time(a, time);
  const std::string longer = key(a);
  CHECK(longer != before);
  std::filesystem::last_write_time(a, time + 1s);
  CHECK(key(a) != longer);
  CHECK(key("builtin:poster") != key("builtin:spheres"));
}

TEST_CASE("thumbnails: the arguments are those of a small picture") {
  const auto model = view::thumbnailArguments({FileKind::model, "/a b.glb"}, "/o.png");
  CHECK(model == std::vector<std::string>{"render", "/a b.glb", "-o", "/o.png", "--size", "96x96", "--env",
                                          "builtin:studio", "--background", "transparent", "--visibility", "none"});
  const auto map = view::thumbnailArguments({FileKind::environment, "/sky.hdr"}, "/o.png");
  CHECK(map == std::vector<std::string>{"render", "builtin:furnace", "-o", "/o.png", "--size", "96x96", "--orbit",
                                        "0,90,2.2", "--target", "-5,0.5,0", "--fov-y", "27", "--env", "/sky.hdr",
                                        "--lights", "none", "--visibility", "none"});
  const auto brdf = view::thumbnailArguments({FileKind::brdf, "/gold.binary"}, "/o.png");
  CHECK(std::ranges::search(brdf, std::vector<std::string>{"--brdf", "/gold.binary"}).size() == 2);
}

TEST_CASE("thumbnails: made once, then read from the disk, a changed file is made anew") {
  const test::TemporaryFolder folder;
  const std::string source = folder.write("a.glb", std::string("1"));
  io::Pixels red{2, 1, 3, 1, {255, 0, 0, 255, 0, 0}};
  REQUIRE(io::writePng(folder.file("red.png"), red));
  const std::string copies = program(folder, "copies", "cp " + folder.file("red.png") + " $OUT");
  const DiskCache cache{folder.path() / "cache", 1 << 20};
  const std::vector<view::ThumbnailRequest> request = {{FileKind::model, source}};
  {
    view::ThumbnailMaker maker(copies, cache, [] {});
    maker.want(request);
    const auto made = await(maker);
    REQUIRE(made);
    CHECK(made->source == source);
    REQUIRE(made->pixels);
    CHECK(made->pixels->width == 2);
    CHECK(made->pixels->data[0] == 255);
    CHECK(runs(folder) == 1);
    maker.want(request);  // nothing new
    std::this_thread::sleep_for(50ms);
    CHECK(maker.take().empty());
    folder.write("a.glb", std::string("22"));
    maker.want(request);
    REQUIRE(await(maker));
    CHECK(runs(folder) == 2);
  }
  view::ThumbnailMaker again(folder.file("missing"), cache, [] {});
  again.want(request);
  const auto kept = await(again);
  REQUIRE(kept);
  CHECK(kept->pixels);
}

TEST_CASE("thumbnails: why one could not be made is told, and it is tried again after a while") {
  const test::TemporaryFolder folder;
  const std::string source = folder.write("a.glb", std::string("1"));
  const std::string fails = program(folder, "fails", "echo 'facet: error: a.glb: is broken.' >&2; exit 2");
  view::ThumbnailMaker maker(fails, {}, [] {});
  maker.want({{FileKind::model, source}});
  const auto made = await(maker);
  REQUIRE(made);
  REQUIRE_FALSE(made->pixels);
  CHECK(made->pixels.error().problem.find("a.glb: is broken") != std::string::npos);
  maker.want({{FileKind::model, source}});
  std::this_thread::sleep_for(50ms);
  CHECK(runs(folder) == 1);
  view::ThumbnailMaker soon(
      fails, {}, [] {}, 1ms);
  for (size_t run = 2; run < 4; ++run) {
    soon.want({{FileKind::model, source}});
    REQUIRE(await(soon));
    CHECK(runs(folder) == run);
    std::this_thread::sleep_for(5ms);
  }

  view::ThumbnailMaker missing(folder.file("missing"), {}, [] {});
  missing.want({{FileKind::model, source}});
  const auto none = await(missing);
  REQUIRE(none);
  CHECK_FALSE(none->pixels);
}

TEST_CASE("thumbnails: the end does not wait for the one that is being made") {
  const test::TemporaryFolder folder;
  const std::string source = folder.write("a.glb", std::string("1"));
  const std::string slow = program(folder, "slow", "exec sleep 60");
  view::ThumbnailMaker* maker = new view::ThumbnailMaker(slow, {}, [] {});
  maker->want({{FileKind::model, source}});
  for (int i = 0; i < 1000 && runs(folder) == 0; ++i) std::this_thread::sleep_for(10ms);
  CHECK(maker->busy());
  delete maker;  // a test that hangs here has failed
  CHECK(runs(folder) == 1);
}
