// facet sheet, as a user runs it.

#include <catch2/catch.hpp>

#include "io/image.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

io::Pixels sheetPicture(const std::string& file) {
  auto read = io::readImage(file);
  if (!read) FAIL(describe(read.error()));
  return std::move(*read);
}

// The part of the sheet is the picture, pixel by pixel.
bool holds(const io::Pixels& sheet, const io::Pixels& part, int left, int top) {
  for (int y = 0; y < part.height; ++y)
    for (int x = 0; x < part.width; ++x)
      for (int c = 0; c < 3; ++c)
        if (sheet.data[static_cast<size_t>(((top + y) * sheet.width + left + x) * 4 + c)] !=
            part.data[static_cast<size_t>((y * part.width + x) * 4 + c)])
          return false;
  return true;
}

const std::vector<std::string> sheetSize = {"--size", "40x24", "--visibility", "none", "--background", "#406080"};

test::Outcome runSheet(std::vector<std::string> words) {
  words.insert(words.end(), sheetSize.begin(), sheetSize.end());
  return test::runFacet(words);
}

}  // namespace

TEST_CASE("facet sheet: each model's picture as render draws it, in rows, folders by name, from below them too") {
  const test::TemporaryFolder folder;
  const std::string a = folder.write("m/a/scene.glb", test::triangle().glb()).string();
  const std::string b = folder.write("m/b/scene.glb", test::triangle().glb()).string();
  folder.write("m/readme.txt", "no model");
  const test::Outcome made =
      runSheet({"sheet", folder.file("m"), "builtin:spheres", "-o", folder.file("s.png"), "--columns", "2"});
  INFO(made.text);
  REQUIRE(made.status == 0);
  CHECK_THAT(made.text, Catch::Contains("s.png: 3 models"));
  const io::Pixels sheet = sheetPicture(folder.file("s.png"));
  // Gaps of 4, titles of 14.
  CHECK(sheet.width == 2 * 40 + 3 * 4);
  CHECK(sheet.height == 2 * (24 + 14 + 4) + 4);
  REQUIRE(runSheet({"render", a, "-o", folder.file("a.png")}).status == 0);
  REQUIRE(runSheet({"render", b, "-o", folder.file("b.png")}).status == 0);
  REQUIRE(runSheet({"render", "builtin:spheres", "-o", folder.file("c.png")}).status == 0);
  CHECK(holds(sheet, sheetPicture(folder.file("a.png")), 4, 18));
  CHECK(holds(sheet, sheetPicture(folder.file("b.png")), 48, 18));
  CHECK(holds(sheet, sheetPicture(folder.file("c.png")), 4, 60));
  CHECK_FALSE(holds(sheet, sheetPicture(folder.file("c.png")), 4, 18));
}

TEST_CASE("facet sheet: a model that cannot be shown has an empty place and a sentence, and the status says so") {
  const test::TemporaryFolder folder;
  const std::string good = folder.write("good.glb", test::triangle().glb()).string();
  const std::string bad = folder.write("bad.glb", "no model").string();
  const test::Outcome made = runSheet({"sheet", bad, good, "-o", folder.file("s.jpg"), "--quality", "100"});
  INFO(made.text);
  CHECK(made.status == 2);
  CHECK_THAT(made.text, Catch::Contains("bad.glb: ") && Catch::Contains("s.jpg: 2 models"));
  const io::Pixels sheet = sheetPicture(folder.file("s.jpg"));
  CHECK(sheet.width == 2 * 40 + 3 * 4);
  const uint8_t* empty = &sheet.data[static_cast<size_t>((30 * sheet.width + 24) * 4)];
  CHECK(empty[0] + empty[1] + empty[2] < 12);
}

TEST_CASE("facet sheet: every way to be wrong has its sentence") {
  const test::TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("none"));
  const auto says = [](std::vector<std::string> words, const std::string& sentence) {
    words.insert(words.begin(), "sheet");
    const test::Outcome outcome = test::runFacet(words);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.text, Catch::Contains(sentence));
  };
  says({folder.file("none"), "-o", folder.file("s.png")}, "none: holds no .gltf and no .glb file; name another folder");
  says({"builtin:spheres", "-o", folder.file("s.exr")}, "-o: a sheet is of what one sees");
  says({"builtin:spheres", "-o", folder.file("s.tif")}, "is no picture's name");
}
