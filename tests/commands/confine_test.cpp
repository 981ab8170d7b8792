// Commands that read what strangers wrote, without OpenGL: they say that they are confined, and what they need is open.

#include <catch2/catch.hpp>
#include <filesystem>

#include "io/image.hpp"
#include "support/command.hpp"

using namespace facet;

TEST_CASE("confined: commands without OpenGL reach what they name, and links in named folders") {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  for (const char* name : {"models", "reference", "pictures", "elsewhere", "out", "brdfs"})
    fs::create_directory(folder.path() / name);
  io::Pixels grey;
  grey.width = grey.height = 16, grey.channels = 3;
  grey.data.assign(16 * 16 * 3, 100);
  REQUIRE(io::writePng(at("elsewhere/a.png"), grey));
  fs::create_symlink("../elsewhere/a.png", at("reference/a.png"));
  fs::copy_file(at("elsewhere/a.png"), at("pictures/a.png"));

  test::checkConfined({"compare", at("reference"), at("pictures")});
  test::checkConfined({"compare", at("reference/a.png"), at("pictures/a.png"), "--diff", at("out/d.png"), "--maps",
                       at("out/d.exr"), "--json"});
  CHECK(io::readImage(at("out/d.png")));
  test::checkConfined({"normalmap", at("reference/a.png"), "-o", at("out/n.png")});
  CHECK(io::readImage(at("out/n.png")));
  REQUIRE(test::runFacet({"brdf", "--synthesize", "ggx-0.35", "-o", at("brdfs/a.binary")}).status == 0);
  folder.write("angles.csv", std::string("thetaV,thetaL,phi\n30,30,180\n"));
  test::checkConfined(
      {"brdf", at("brdfs"), "--eval-from", at("angles.csv"), "--plot", at("out/p.svg"), "--lobes", at("out/l.svg")});
  CHECK(fs::file_size(at("out/p.svg")) > 1000);
  test::checkConfined({"inspect", "builtin:spheres", "--json"});
}

TEST_CASE("confined: inspect reads a model's own folder and the one that was allowed, and no other") {
  namespace fs = std::filesystem;
  const test::TemporaryFolder folder;
  for (const char* name : {"model", "beside"}) fs::create_directory(folder.path() / name);
  folder.write("beside/data.bin", std::string(36, '\0'));
  folder.write("model/a.gltf", std::string(R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
    "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3,
                   "min": [0, 0, 0], "max": [0, 0, 0]}],
    "bufferViews": [{"buffer": 0, "byteLength": 36}], "buffers": [{"byteLength": 36, "uri": "data.bin"}]})"));
  fs::create_symlink("../beside/data.bin", folder.path() / "model/data.bin");
  const std::string model = (folder.path() / "model/a.gltf").string();
  test::checkConfined({"inspect", model, "--allow-outside", (folder.path() / "beside").string()});
  CHECK(test::runFacet({"inspect", model}).status != 0);
  fs::create_directory(folder.path() / "linked");
  fs::create_symlink("../model/a.gltf", folder.path() / "linked/link.gltf");
  folder.write("linked/data.bin", std::string(36, '\0'));
  test::checkConfined({"inspect", (folder.path() / "linked/link.gltf").string()});
  test::checkConfined({"inspect", (folder.path() / "linked/link.gltf").string(), "--allow-outside",
                       (folder.path() / "beside").string()});
}
