// The files of facet render, as a user runs it: formats, layers, standard input and output.

#include <catch2/catch.hpp>
#include <cmath>

#include "io/image.hpp"
#include "io/radiance.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

const std::vector<std::string> ball = {"render", "builtin:spheres", "--size", "40x24", "--visibility", "none"};

test::Outcome draw(const std::string& output, const std::vector<std::string>& more = {}) {
  std::vector<std::string> words = ball;
  words.insert(words.end(), more.begin(), more.end());
  words.insert(words.end(), {"-o", output});
  return test::runFacet(words);
}

io::RadianceImage radiance(const std::string& file, const std::string& layer = {}) {
  auto read = io::readRadiance(file, {}, layer);
  if (!read) FAIL(describe(read.error()));
  return std::move(*read);
}

std::string bytesOf(const std::string& file) { return test::runShell("cat " + file).text; }

}  // namespace

TEST_CASE("facet render writes PNG, JPEG, WebP and AVIF of one picture") {
  const test::TemporaryFolder folder;
  REQUIRE(draw(folder.file("a.png")).status == 0);
  for (const char* lossless : {"a.webp", "a.avif"}) {
    REQUIRE(draw(folder.file(lossless), {"--quality", "100"}).status == 0);
    CHECK(test::runFacet(
              {"compare", folder.file("a.png"), folder.file(lossless), "--metric", "largest", "--max-error", "0"})
              .status == 0);
  }
  // WebP has half the resolution for colours, whatever its quality.
  for (const auto& [lossy, most] : {std::pair("b.jpg", "6"), {"b.webp", "22"}, {"b.avif", "6"}}) {
    REQUIRE(draw(folder.file(lossy), {"--quality", "95"}).status == 0);
    const test::Outcome outcome =
        test::runFacet({"compare", folder.file("a.png"), folder.file(lossy), "--metric", "drmse", "--max-error", most});
    INFO(outcome.text);
    CHECK(outcome.status == 0);
  }
}

TEST_CASE("facet render --bits 16: what is shown, to the 65535th") {
  const test::TemporaryFolder folder;
  const std::vector<std::string> plain = {"--tonemap", "none", "--background", "#204060", "--samples", "1"};
  auto deep = plain;
  deep.insert(deep.end(), {"--bits", "16", "--overlay", "grid"});
  REQUIRE(draw(folder.file("lines.png"), deep).status == 0);
  deep.resize(plain.size() + 2);
  REQUIRE(draw(folder.file("a.png"), deep).status == 0);
  REQUIRE(draw(folder.file("a.exr"), plain).status == 0);
  const auto bytes = test::runShell("cat " + folder.file("a.png")).text;
  const auto picture = io::decodeImage({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()}, "a.png");
  REQUIRE(picture);
  REQUIRE(picture->bytesPerSample == 2);
  const io::RadianceImage light = radiance(folder.file("a.exr"));
  const auto* samples = reinterpret_cast<const uint16_t*>(picture->data.data());
  double worst = 0;
  for (size_t i = 0; i < light.pixels.size(); ++i)
    for (size_t c = 0; c < 3; ++c) {
      const double v = std::min(1.0, double(light.pixels[i][static_cast<int>(c)]));
      const double shown = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
      worst = std::max(worst, std::abs(samples[3 * i + c] - 65535 * shown));
    }
  CHECK(worst < 1.5);
  CHECK(test::runFacet({"compare", folder.file("a.png"), folder.file("lines.png"), "--max-error", "0"}).status == 1);
}

TEST_CASE("facet render --layers: each is what its channel draws, beside the same picture") {
  const test::TemporaryFolder folder;
  REQUIRE(draw(folder.file("all.exr"), {"--layers", "baseColor,normal,depth,node"}).status == 0);
  REQUIRE(draw(folder.file("picture.exr")).status == 0);
  const auto same = [](const io::RadianceImage& a, const io::RadianceImage& b, int components) {
    REQUIRE(a.pixels.size() == b.pixels.size());
    for (size_t i = 0; i < a.pixels.size(); ++i)
      for (int c = 0; c < components; ++c)
        if (a.pixels[i][c] != b.pixels[i][c]) return false;
    return true;
  };
  CHECK(same(radiance(folder.file("all.exr")), radiance(folder.file("picture.exr")), 4));
  for (const char* channel : {"baseColor", "normal", "depth", "node"}) {
    CAPTURE(channel);
    const std::string single = folder.file(std::string(channel) + ".exr");
    REQUIRE(draw(single, {"--channel", channel}).status == 0);
    const bool several = channel == std::string("baseColor");
    if (several) CHECK(same(radiance(folder.file("all.exr"), channel), radiance(single), 3));
  }
  const std::string header = bytesOf(folder.file("all.exr")).substr(0, 2000);
  for (const char* name : {"baseColor.R", "normal.X", "normal.Z", "depth.Z", "node.X"})
    CHECK(header.find(name) != std::string::npos);
  CHECK(header.find("node.Y") == std::string::npos);
}

TEST_CASE("facet render - -o -: standard input and output, the bytes of the files") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("t.glb", test::triangle().glb()).string(), facet = test::facetPath();
  const std::string options = " --size 24x24 --visibility none -o ";
  for (const auto& [name, format] :
       {std::pair("a.png", ""), std::pair("a.jpg", " --format jpg"), std::pair("a.exr", " --format exr")}) {
    CAPTURE(name);
    REQUIRE(test::runShell(facet + " render " + model + options + folder.file(name)).status == 0);
    const std::string out = folder.file(std::string("out_") + name);
    REQUIRE(test::runShell(facet + " render -" + options + "-" + format + " < " + model + " 2>/dev/null | cat > " + out)
                .status == 0);
    if (std::string(name) != "a.exr") CHECK(bytesOf(out) == bytesOf(folder.file(name)));  // an EXR names its model
    CHECK(test::runFacet({"compare", folder.file(name), out, "--metric", "largest", "--max-error", "0"}).status == 0);
  }
  const test::Outcome inspected = test::runShell(facet + " inspect - < " + model);
  CHECK(inspected.status == 0);
  CHECK_THAT(inspected.text, Catch::Contains("triangles"));
  REQUIRE(test::runShell(facet + " export - -o - < " + model + " 2>/dev/null > " + folder.file("e.glb")).status == 0);
  CHECK(test::runFacet({"inspect", folder.file("e.glb")}).status == 0);
  const test::Outcome empty = test::runShell(facet + " inspect - < /dev/null");
  CHECK(empty.status == 2);
  CHECK_THAT(empty.text, Catch::Contains("standard input: is empty"));
  CHECK(test::runShell(facet + " inspect - < " + folder.path().string()).status == 2);
}

TEST_CASE("facet render: what a format cannot hold is said before anything is drawn") {
  const test::TemporaryFolder folder;
  const auto says = [&](const std::string& file, const std::vector<std::string>& more, const std::string& sentence) {
    const test::Outcome outcome = draw(file == "-" ? file : folder.file(file), more);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.text, Catch::Contains(sentence));
  };
  says("a.tif", {}, "is no picture's name; end it in .png, .jpg, .webp or .avif (after tone mapping) or .exr");
  says("a.jpg", {"--background", "transparent"}, "--background: JPEG has no transparency");
  says("a.jpg", {"--bits", "16"}, "--bits: JPEG holds 8 bits a channel");
  says("a.exr", {"--bits", "16"}, "--bits: OpenEXR holds 32 bits a channel");
  says("a.png", {"--layers", "depth"}, "--layers: only an EXR holds layers");
  says("a.exr", {"--layers", "dept"}, "--layers: 'dept' is no channel");
  says("a.exr", {"--layers", "depth,depth"}, "--layers: 'depth' is named twice");
  says("a.exr", {"--layers", "depth", "--channel", "uv"}, "--layers: is of a picture");
  says("a.png", {"--format", "png"}, "--format: is for standard output");
  says("-", {"--format", "gif"}, "--format: 'gif' is none");
  const test::Outcome wide =
      test::runFacet({"render", "builtin:spheres", "--size", "16384x16", "-o", folder.file("a.webp")});
  CHECK(wide.status == 2);
  CHECK_THAT(wide.text, Catch::Contains("WebP holds pictures of up to 16383 pixels"));
}
