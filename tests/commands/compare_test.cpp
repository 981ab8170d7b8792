#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "base/srgb.hpp"
#include "compare/flip.hpp"
#include "io/image.hpp"
#include "io/picture_file.hpp"
#include "io/radiance.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/skip.hpp"

using namespace facet;
using test::Outcome;
using test::runFacet;

namespace {

std::string inFolder(const test::TemporaryFolder& folder, const std::string& name) {
  return (folder.path() / name).string();
}

// 8 x 4 pictures of one grey, as PNG and as EXR.
std::string png(const test::TemporaryFolder& folder, const std::string& name, uint8_t value) {
  io::Pixels pixels;
  pixels.width = 8, pixels.height = 4, pixels.channels = 3;
  pixels.data.assign(8 * 4 * 3, value);
  REQUIRE(io::writePng(inFolder(folder, name), pixels));
  return inFolder(folder, name);
}

std::string exr(const test::TemporaryFolder& folder, const std::string& name, float value, int width = 8) {
  const glm::vec4 color(value, value, value, 1);
  const io::RadianceImage image{width, 4, std::vector<glm::vec4>(static_cast<size_t>(width) * 4, color)};
  REQUIRE(io::writeExr(inFolder(folder, name), image));
  return inFolder(folder, name);
}

}  // namespace

TEST_CASE("compare: a PNG and an EXR of the same radiance do not differ") {
  const test::TemporaryFolder folder;
  const std::string a = png(folder, "a.png", 128),
                    b = exr(folder, "b.exr", static_cast<float>(linearFromSrgb(128 / 255.)));
  const Outcome outcome = runFacet({"compare", a, b, "--max-error", "0.001"});
  CHECK(outcome.text ==
        "dRMSE 0.00/255  relRMSE 0.0000  bias +0.00% +0.00% +0.00%  FLIP 0.0000  SSIM 1.0000  largest 0.0000 at 0,0  "
        "above 0.01: 0.000%  (32 px)\n"
        "within: drmse 0 <= 0.001\n");
  CHECK(outcome.status == 0);
}

TEST_CASE("compare: each metric is limited by --max-error") {
  const test::TemporaryFolder folder;
  const std::string a = exr(folder, "a.exr", 0.5f), b = exr(folder, "b.exr", 0.4f);
  const double shown = srgbFromLinear(0.5) - srgbFromLinear(0.4);
  const double p = srgbFromLinear(0.5), q = srgbFromLinear(0.4), c1 = 1e-4;
  const double flip = compare::flipColorDifference(glm::dvec3(0.5), glm::dvec3(0.4f));
  struct Row {
    std::string metric;
    double value;
  };
  const Row row = GENERATE_COPY(Row{"drmse", 255 * shown}, Row{"rel-rmse", 0.2}, Row{"rel-mse", 0.01 / 0.26},
                                Row{"trimmed", 255 * shown}, Row{"p99", shown}, Row{"bias", 0.2}, Row{"largest", shown},
                                Row{"above", 1}, Row{"flip", flip}, Row{"flip-largest", flip}, Row{"noticeable", 1},
                                Row{"ssim", 1 - (2 * p * q + c1) / (p * p + q * q + c1)});
  const auto statusAt = [&](double limit) {
    return runFacet({"compare", a, b, "--metric", row.metric, "--max-error", std::to_string(limit)}).status;
  };
  CAPTURE(row.metric);
  CHECK(statusAt(row.value * 1.001 + 2e-6) == 0);
  CHECK(statusAt(row.value * 0.999 - 2e-6) == 1);
}

TEST_CASE("compare: a picture that lacks what only covers differs") {
  const test::TemporaryFolder folder;
  io::Pixels pixels;
  pixels.width = 8, pixels.height = 4, pixels.channels = 4;
  pixels.data.assign(8 * 4 * 4, 0);
  const std::string empty = inFolder(folder, "empty.png"), disc = inFolder(folder, "disc.png");
  REQUIRE(io::writePng(empty, pixels));
  for (size_t i = 0; i < 8; ++i) pixels.data[4 * i + 3] = 255;
  REQUIRE(io::writePng(disc, pixels));
  for (const char* metric : {"drmse", "flip", "noticeable", "alpha", "ssim", "largest", "above", "bias"}) {
    INFO(metric);
    CHECK(runFacet({"compare", disc, empty, "--metric", metric, "--max-error", "0.01"}).status == 1);
    CHECK(runFacet({"compare", disc, disc, "--metric", metric, "--max-error", "0.01"}).status == 0);
  }
}

TEST_CASE("compare: JSON holds the figures") {
  const test::TemporaryFolder folder;
  const std::string a = exr(folder, "a.exr", 0.5f), b = exr(folder, "b.exr", 0.25f);
  const Outcome outcome = runFacet({"compare", a, b, "--json", "--max-error", "3", "--tolerance", "0.5"});
  CHECK(outcome.status == 1);
  const nlohmann::json json = nlohmann::json::parse(outcome.text);
  CHECK(json["reference"] == a);
  CHECK(json["picture"] == b);
  CHECK(json["pixels"] == 32);
  CHECK(json["relRmse"] == 0.5);
  CHECK(json["bias"] == nlohmann::json{-0.5, -0.5, -0.5});
  CHECK(json["largest"]["difference"].get<double>() == Approx(srgbFromLinear(0.5) - srgbFromLinear(0.25)));
  CHECK(json["shareAbove"] == 0);
  CHECK(json["tolerance"] == 0.5);
  CHECK(json["nonFinite"] == nlohmann::json{{"reference", 0}, {"picture", 0}});
  CHECK(json["metric"] == "drmse");
  CHECK(json["error"] == json["displayRmse"]);
  CHECK(json["maxError"] == 3);
  CHECK(json["passed"] == false);
}

TEST_CASE("compare: NaN fails whatever the limit, even without one") {
  const test::TemporaryFolder folder;
  const std::string a = exr(folder, "a.exr", 0.5f), b = exr(folder, "b.exr", std::numeric_limits<float>::quiet_NaN());
  CHECK(runFacet({"compare", a, b}).status == 1);
  const Outcome outcome = runFacet({"compare", b, b, "--max-error", "1000"});
  CHECK(outcome.status == 1);
  CHECK(outcome.text.find("differ: not finite are 32 pixels of the reference and 32 of the picture\n") !=
        std::string::npos);
}

TEST_CASE("compare: the heat map is a PNG of the same size") {
  const test::TemporaryFolder folder;
  const std::string a = exr(folder, "a.exr", 0), b = exr(folder, "b.exr", 1);
  CHECK(runFacet({"compare", a, b, "--diff", inFolder(folder, "d.png")}).status == 0);
  const Result<io::Pixels> map = io::readImage(inFolder(folder, "d.png"));
  REQUIRE(map);
  CHECK(map->width == 8);
  CHECK(map->height == 4);
  CHECK(map->data[0] == 255);
  const Outcome outcome = runFacet({"compare", a, b, "--diff", inFolder(folder, "none/d.png")});
  CHECK(outcome.status == 2);
  CHECK(outcome.text.find("none/d.png") != std::string::npos);
}

TEST_CASE("compare: bad input is told in a sentence, exit status 2") {
  const test::TemporaryFolder folder;
  const std::string a = exr(folder, "a.exr", 0.5f), wide = exr(folder, "wide.exr", 0.5f, 9);
  const auto text = [](const std::vector<std::string>& words) {
    const Outcome outcome = runFacet(words);
    CHECK(outcome.status == 2);
    return outcome.text;
  };
  CHECK(text({"compare", a, wide}) ==
        "facet: error: " + a + " and " + wide + ": the sizes differ, 8x4 and 9x4; compare pictures of one size.\n");
  CHECK(text({"compare", a, a, "--metric", "rmse"}) ==
        "facet: error: --metric: 'rmse' is not known; perhaps drmse is meant.\n");
  CHECK(text({"compare", a, a, "--max-error", "much"}) ==
        "facet: error: --max-error: 'much' is not a number; give a number from 0 to 1e+09.\n");
  CHECK(text({"compare", a, a, "--tolerance", "-1"}) ==
        "facet: error: --tolerance: -1 is out of range; give a number from 0 to 1.\n");
  CHECK(text({"compare", inFolder(folder, "no.png"), a}).find(inFolder(folder, "no.png")) != std::string::npos);
  CHECK(text({"compare", a, folder.write("text.png", std::string("hello")).string()}).find("text.png") !=
        std::string::npos);
  CHECK(text({"compare", a, folder.path().string()}).find(folder.path().string()) != std::string::npos);
}

TEST_CASE("compare: figures of path-traced references agree with those of an independent script") {
  const std::string plain = test::sharedFile("truth/plain/WaterBottle.vestibule_1k.exr");
  const std::string full = test::sharedFile("truth/full/WaterBottle.vestibule_1k.exr");
  if (plain.empty() || full.empty()) return;
  const nlohmann::json json =
      nlohmann::json::parse(runFacet({"compare", plain, full, "--mask-from-alpha", "--json"}).text);
  CHECK(json["pixels"] == 34861);
  CHECK(json["relRmse"].get<double>() == Approx(0.2252965278).epsilon(1e-4));
  CHECK(json["bias"][0].get<double>() == Approx(-0.0158680766).epsilon(1e-4));
  CHECK(json["bias"][1].get<double>() == Approx(-0.0142215380).epsilon(1e-4));
  CHECK(json["bias"][2].get<double>() == Approx(-0.0131402710).epsilon(1e-4));
  CHECK(json["ssim"].get<double>() == Approx(0.9175742721).epsilon(1e-5));
  CHECK(json["displayRmse"].get<double>() == Approx(7.9610494352).epsilon(1e-4));
}

TEST_CASE("compare: whatever facet writes is a picture of a folder, and nothing else") {
  test::TemporaryFolder folder;
  io::Pixels grey;
  grey.width = grey.height = 8, grey.channels = 3;
  grey.data.assign(192, 100);
  for (const char* name : {"ref", "img"}) {
    std::filesystem::create_directories(folder.path() / name);
    for (const auto& [ending, format] : {std::pair(".webp", io::PictureFormat::webp),
                                         {".JPG", io::PictureFormat::jpeg},
                                         {".png", io::PictureFormat::png}}) {
      const auto bytes = io::encodePicture(format, grey, 100, "grey");
      REQUIRE(bytes);
      std::ofstream(folder.path() / name / ("a" + std::string(ending)), std::ios::binary)
          .write(reinterpret_cast<const char*>(bytes->data()), static_cast<std::streamsize>(bytes->size()));
    }
    std::ofstream(folder.path() / name / "notes.txt") << "no picture";
  }
  const Outcome outcome = runFacet({"compare", folder.file("ref"), folder.file("img"), "--csv"});
  CHECK(outcome.status == 0);
  CHECK(std::ranges::count(outcome.text, '\n') == 4);
}

TEST_CASE("compare: folders are compared picture by picture, maps hold signed differences") {
  test::TemporaryFolder folder;
  for (const char* name : {"ref", "ref/sub", "img", "img/sub"})
    std::filesystem::create_directories(folder.path() / name);
  png(folder, "ref/a.png", 128), png(folder, "img/a.png", 128);
  exr(folder, "ref/sub/b.exr", 0.5f), exr(folder, "img/sub/b.exr", 0.4f);
  const std::string reference = folder.file("ref"), picture = folder.file("img");
  const Outcome outcome = runFacet({"compare", reference, picture, "--max-error", "1", "--csv"});
  CHECK(outcome.status == 1);
  std::vector<std::string> lines;
  std::istringstream stream(outcome.text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  REQUIRE(lines.size() == 3);
  CHECK(lines[0].starts_with("reference,picture,drmse,rel-rmse,"));
  CHECK(lines[1].starts_with(reference + "/a.png," + picture + "/a.png,0,0,"));
  CHECK(lines[2].find("/sub/b.exr") != std::string::npos);
  CHECK(lines[2].find(",no,") != std::string::npos);
  CHECK(runFacet({"compare", reference, picture, "--json"}).status == 0);
  std::filesystem::remove(folder.path() / "img/a.png");
  const Outcome missing = runFacet({"compare", reference, picture});
  CHECK(missing.status == 2);
  CHECK(missing.text.find("img/a.png: there is no such picture") != std::string::npos);
  CHECK(
      runFacet({"compare", reference, folder.file("img/sub/b.exr")}).text.find("is no folder, and the other is one") !=
      std::string::npos);
  const std::string maps = folder.file("maps.exr");
  REQUIRE(runFacet({"compare", folder.file("ref/sub/b.exr"), folder.file("img/sub/b.exr"), "--maps", maps}).status ==
          0);
  const auto difference = io::readRadiance(maps);
  REQUIRE(difference.has_value());
  CHECK(difference->pixels[3].y == Approx(-0.1f));
  const auto relative = io::readRadiance(maps, {}, "relative");
  REQUIRE(relative.has_value());
  CHECK(relative->pixels[3].x == Approx(-0.2f));
}
