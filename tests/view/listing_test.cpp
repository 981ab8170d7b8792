#include "view/listing.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "support/temporary_folder.hpp"

using namespace facet;
using view::FileKind;

namespace {

std::vector<std::string> names(const view::FolderListing& listing) {
  std::vector<std::string> out;
  for (const view::Entry& entry : listing.entries) out.push_back(entry.name);
  return out;
}

}  // namespace

TEST_CASE("listing: the kinds of files, by name and by size") {
  const test::TemporaryFolder folder;
  CHECK(view::fileKind("a.GLB").value() == FileKind::model);
  CHECK(view::fileKind("a.b/c.gltf").value() == FileKind::model);
  CHECK(view::fileKind("sky.exr").value() == FileKind::environment);
  CHECK(view::fileKind("gold.binary").value() == FileKind::brdf);
  CHECK(view::fileKind("wood.bin").value() == FileKind::brdf);
  CHECK(view::fileKind(folder.path().string()).value() == FileKind::folder);
  CHECK_FALSE(view::fileKind("a.txt"));
  CHECK_FALSE(view::fileKind("glb"));

  folder.write("scene.bin", std::string(100, 'x'));  // a model's buffer
  std::ofstream(folder.file("wood.bin")).close();
  std::filesystem::resize_file(folder.file("wood.bin"), 288 * 288 * 3 * 8);
  folder.write("gold.binary", std::string("x"));
  CHECK(names(view::scanFolder(folder.path())) == std::vector<std::string>{"gold.binary", "wood.bin"});
}

TEST_CASE("listing: a folder is listed with all below it, hidden ones and other files left out") {
  const test::TemporaryFolder folder;
  folder.write("b/Boat.glb", std::string("x"));
  folder.write("a/deep/er/Apple.gltf", std::string("x"));
  folder.write("a/sky.hdr", std::string("x"));
  folder.write("a/readme.md", std::string("x"));
  folder.write(".hidden/secret.glb", std::string("x"));
  folder.write(".also.glb", std::string("x"));
  const view::FolderListing listing = view::scanFolder(folder.path().string() + "/");
  CHECK(listing.folder == folder.path());
  CHECK(listing.problem.empty());
  CHECK(names(listing) == std::vector<std::string>{"sky.hdr", "Apple.gltf", "Boat.glb"});
  CHECK(listing.entries[0].kind == FileKind::environment);
  CHECK(listing.entries[1].source == folder.file("a/deep/er/Apple.gltf"));
  CHECK(listing.entries[1].place == (folder.path().filename() / "a/deep/er").string());
  CHECK(names(view::scanFolder(folder.path(), {.depth = 0})).empty());
  CHECK(names(view::scanFolder(folder.path(), {.depth = 1})) == std::vector<std::string>{"sky.hdr", "Boat.glb"});
}

TEST_CASE("listing: links that lead in a circle end, bounds are told") {
  const test::TemporaryFolder folder;
  folder.write("a/one.glb", std::string("x"));
  folder.write("a/two.glb", std::string("x"));
  std::filesystem::create_directory_symlink(folder.path(), folder.file("a/up"));
  std::filesystem::create_directory_symlink(folder.file("a"), folder.file("again"));
  std::filesystem::create_symlink(folder.file("nothing.glb"), folder.file("dangling.glb"));
  view::FolderListing listing = view::scanFolder(folder.path());
  CHECK(listing.entries.size() == 2);
  CHECK(listing.problem.empty());
  listing = view::scanFolder(folder.path(), {.listed = 1});
  CHECK(listing.entries.size() == 1);
  CHECK(listing.problem == "only the first 1 are listed");
  listing = view::scanFolder(folder.path(), {.visited = 1});
  CHECK(listing.problem == "only the first 1 files were looked at");
  listing = view::scanFolder(folder.path() / "missing");
  CHECK(listing.entries.empty());
  CHECK(listing.problem.starts_with("cannot be read: "));
  std::stop_source stop;
  stop.request_stop();
  CHECK(view::scanFolder(folder.path(), {}, stop.get_token()).entries.empty());
}

TEST_CASE("listing: the search takes every word, in any case, from name and place") {
  const std::vector<view::Entry> entries = {{FileKind::model, "/m/Helmet/scene.gltf", "scene.gltf", "m/Helmet"},
                                            {FileKind::model, "/m/Boat.glb", "Boat.glb", "m"},
                                            {FileKind::environment, "/m/helmet.hdr", "helmet.hdr", "m"},
                                            {FileKind::model, "/m/Boat.glb", "Boat.glb", "recent"}};
  CHECK(view::filtered(entries, FileKind::model, "") == std::vector<int>{0, 1});
  CHECK(view::filtered(entries, FileKind::model, "HELM") == std::vector<int>{0});
  CHECK(view::filtered(entries, FileKind::model, "gltf  helmet") == std::vector<int>{0});
  CHECK(view::filtered(entries, FileKind::model, "helmet boat").empty());
  CHECK(view::filtered(entries, FileKind::environment, "helmet") == std::vector<int>{2});
  CHECK(view::filtered(entries, FileKind::brdf, "").empty());
  const std::vector<view::Entry> builtin = view::builtinEntries();
  CHECK(view::filtered(builtin, FileKind::model, "spheres").size() == 1);
  CHECK(view::filtered(builtin, FileKind::environment, "").size() == 4);  // studio, sky, white, none
  const std::vector<int> brdfs = view::filtered(builtin, FileKind::brdf, "built-in brushed");
  REQUIRE(brdfs.size() == 1);
  CHECK(builtin[static_cast<size_t>(brdfs[0])].source == "builtin:utia-brushed");
}

TEST_CASE("listing: a name that says nothing comes with its folder's") {
  CHECK(view::fileName("/models/chair.glb") == "chair.glb");
  CHECK(view::fileName("/models/chair/scene.gltf") == "chair/scene.gltf");
  CHECK(view::fileName("/models/chair/glTF/Model.gltf") == "chair/glTF/Model.gltf");
  CHECK(view::fileName("scene.gltf") == "scene.gltf");
  CHECK(view::fileName("/scene.gltf") == "scene.gltf");
  CHECK(view::fileEntry(FileKind::model, "/models/chair/scene.gltf").name == "chair/scene.gltf");
}
