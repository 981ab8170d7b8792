#include <catch2/catch.hpp>
#include <fstream>
#include <sstream>

#include "io/image.hpp"
#include "support/command.hpp"

using namespace facet;

TEST_CASE("a file manager gets its picture: of that size, transparent around the model, whatever the file is called") {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("no ending");
  const test::Outcome made =
      test::runFacet({"thumbnail", "--log-level", "error", "--size", "64", "--", "builtin:spheres", out});
  CHECK(made.text == "");
  REQUIRE(made.status == 0);
  std::stringstream bytes;
  bytes << std::ifstream(out, std::ios::binary).rdbuf();
  const std::string text = bytes.str();
  const Result<io::Pixels> pixels = io::decodeImage({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, out);
  REQUIRE(pixels);
  CHECK((pixels->width == 64 && pixels->height == 64 && pixels->channels == 4));
  size_t opaque = 0, clear = 0;
  for (size_t i = 3; i < pixels->data.size(); i += 4) opaque += pixels->data[i] == 255, clear += pixels->data[i] == 0;
  CHECK(opaque > 64 * 64 / 4);
  CHECK(clear > 64 * 64 / 8);
}

TEST_CASE("a thumbnail of what is no model is one sentence and no file") {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.png");
  const auto said = [&](const std::string& file) {
    const test::Outcome outcome = test::runFacet({"thumbnail", "--log-level", "error", file, out});
    CHECK(outcome.status == 2);
    CHECK_FALSE(std::filesystem::exists(out));
    return outcome.text;
  };
  const std::string broken = folder.write("broken.glb", "glTF\2"), text = folder.write("text.txt", "text");
  CHECK(said(broken).starts_with("facet: error: " + broken));
  CHECK(said(text).find("neither a model") != std::string::npos);
  CHECK(said(folder.file("none.glb")).starts_with("facet: error: " + folder.file("none.glb")));
  std::filesystem::resize_file(folder.write("large.glb", "glTF"), (uintmax_t{400} << 20) + 1);  // a hole
  CHECK(said(folder.file("large.glb")) ==
        "facet: error: " + folder.file("large.glb") + ": is too large for a thumbnail.\n");
}
