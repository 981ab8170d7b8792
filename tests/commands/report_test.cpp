#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "io/image.hpp"
#include "support/command.hpp"

using namespace facet;

TEST_CASE("facet report: a topic as Markdown, CSV, JSON, to a file, what is wrong is told") {
  const test::Outcome markdown = test::runFacet({"report", "fresnel"});
  CHECK(markdown.status == 0);
  CHECK(markdown.text.find("### Schlick's approximation of dielectrics") == 0);
  CHECK(markdown.text.find("| gold ") != std::string::npos);
  CHECK(markdown.text.find("Made by facet `") != std::string::npos);
  CHECK(markdown.text.find("command `facet report fresnel`") != std::string::npos);
  // A CSV is one table.
  const test::Outcome several = test::runFacet({"report", "fresnel", "--format", "csv"});
  CHECK(several.status == 2);
  CHECK(several.text.find("choose one by --table: fresnel-dielectric, fresnel-metal") != std::string::npos);
  const test::Outcome csv = test::runFacet({"report", "fresnel", "--format", "csv", "--table", "fresnel-dielectric"});
  CHECK(csv.text.find("ior,F0,largest error,") == 0);
  const test::Outcome unknown = test::runFacet({"report", "fresnel", "--table", "fresnel-dielektric"});
  CHECK(unknown.status == 2);
  CHECK(unknown.text.find("fresnel-dielectric") != std::string::npos);
  // A table's wrong name costs no measurement, its right one those of its topic alone.
  const test::Outcome mistyped = test::runFacet({"report", "--table", "visibilty"});
  CHECK(mistyped.status == 2);
  CHECK(mistyped.text.find("there is no table 'visibilty'") != std::string::npos);
  CHECK(mistyped.text.find("visibility") != std::string::npos);
  CHECK(mistyped.text.find("OpenGL") == std::string::npos);
  CHECK(test::runFacet({"report", "--table", "masking"}).text.find("### Approximations of Smith's masking G1") == 0);
  test::TemporaryFolder folder;
  const std::string file = folder.file("fresnel.json");
  const test::Outcome json = test::runFacet({"report", "fresnel", "--format", "json", "-o", file});
  CHECK(json.status == 0);
  CHECK(json.text.empty());
  std::ifstream stream(file);
  CHECK(nlohmann::json::parse(stream)["tables"].size() == 2);
  // A file by its ending, a folder without one; nothing is made of what is neither.
  CHECK(test::runFacet({"report", "diffuse", "-o", folder.file("a.csv")}).status == 0);
  CHECK(test::runShell("head -c 16 " + folder.file("a.csv")).text == "model,roughness,");
  CHECK(test::runFacet({"report", "fresnel", "-o", folder.file("b.csv")}).status == 2);
  CHECK(test::runFacet({"report", "fresnel", "-o", folder.file("all")}).status == 0);
  for (const char* name : {"report.json", "fresnel-metal.csv", "fresnel-dielectric.csv", "fresnel-metal.svg"})
    CHECK(std::filesystem::exists(folder.file(std::string("all/") + name)));
  CHECK(test::runFacet({"report", "fresnel", "-o", folder.file("v1.2/")}).status == 0);
  CHECK(std::filesystem::exists(folder.file("v1.2/report.md")));
  CHECK(test::runFacet({"report", "fresnel", "-o", folder.file("v1.2")}).status == 0);  // is a folder by now
  for (const char* name : {"f.svg", "f.txt", "f.CSV"}) {
    const test::Outcome refused = test::runFacet({"report", "fresnel", "-o", folder.file(name)});
    CHECK(refused.status == 2);
    CHECK(refused.text.find("a report is no ." + std::string(name).substr(2) + " file") != std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder.file(name)));
  }
  CHECK(test::runFacet({"report", "diffuse", "--format", "csv", "-o", folder.file("f.txt")}).status == 0);
  CHECK(std::filesystem::is_regular_file(folder.file("f.txt")));
  CHECK(test::runFacet({"report", "fresnel", "--format", "csv", "-o", folder.file("all")}).status == 2);
  CHECK(test::runFacet({"brdf", "builtin:lambert", "--plot", folder.file("p.png")}).status == 2);
  CHECK_FALSE(std::filesystem::exists(folder.file("p.png")));
  const test::Outcome topic = test::runFacet({"report", "fresnal"});
  CHECK(topic.status == 2);
  CHECK(topic.text.find("'fresnal': there is no such topic") != std::string::npos);
  CHECK(topic.text.find("fresnel") != std::string::npos);
  CHECK(test::runFacet({"report", "fresnel", "--format", "xls"}).status == 2);
  CHECK(test::runFacet({"report", "fresnel", "-o", "/nowhere/at/all.md"}).status == 2);
}

TEST_CASE("facet materials: presets with their indices, what is built in, what is wrong is told") {
  const test::Outcome metals = test::runFacet({"materials", "--table", "metals", "--format", "json"});
  REQUIRE(metals.status == 0);
  const auto table = nlohmann::json::parse(metals.text)["tables"][0];
  const auto row = std::ranges::find_if(table["rows"], [](const auto& r) { return r["name"] == "gold"; });
  REQUIRE(row != table["rows"].end());
  const double eta = (*row)["eta red"], k = (*row)["k red"], f0 = (*row)["f0 red"];
  CHECK(f0 == Approx(((eta - 1) * (eta - 1) + k * k) / ((eta + 1) * (eta + 1) + k * k)));
  CHECK(f0 > 0.9);
  const test::Outcome both = test::runFacet({"materials"});
  CHECK(both.text.find("| diamond ") != std::string::npos);
  const test::Outcome builtin = test::runFacet({"materials", "--list"});
  CHECK(builtin.status == 0);
  for (const char* name : {"builtin:spheres", "builtin:poster", "builtin:studio", "builtin:utia-brushed"})
    CHECK(builtin.text.find(std::string("| ") + name + " ") != std::string::npos);
  const test::Outcome wrong = test::runFacet({"materials", "--table", "metal"});
  CHECK(wrong.status == 2);
  CHECK(wrong.text.find("metals") != std::string::npos);
}

TEST_CASE("facet export: a built-in scene as a file that is what it was, what is wrong is told") {
  test::TemporaryFolder folder;
  const std::string file = folder.file("robot.glb");
  CHECK(test::runFacet({"export", "builtin:robot", "-o", file}).status == 0);
  const test::Outcome inspected = test::runFacet({"inspect", file, "--json"});
  CHECK(inspected.status == 0);
  const auto json = nlohmann::json::parse(inspected.text);
  CHECK(json["validation"]["errors"] == 0);
  CHECK(json["counts"]["lights"] == 8);
  CHECK(test::runFacet({"export", "robot", "-o", file}).text.find("no such file") != std::string::npos);
  CHECK(test::runFacet({"export", "builtin:robt", "-o", file}).text.find("robot") != std::string::npos);
  CHECK(test::runFacet({"export", "builtin:robot", "-o", folder.file("a.gltf")}).status == 2);
}

TEST_CASE("facet normalmap: a flat picture becomes a level normal map, what is wrong is told") {
  test::TemporaryFolder folder;
  const std::string grey = folder.file("grey.png"), normal = folder.file("normal.png");
  REQUIRE(io::writePng(grey, {.width = 3, .height = 2, .channels = 1, .data = {9, 9, 9, 9, 9, 9}}).has_value());
  const test::Outcome good = test::runFacet({"normalmap", grey, "-o", normal, "--scale", "0.5", "--wrap"});
  CHECK(good.status == 0);
  CHECK(good.text.empty());
  const Result<io::Pixels> pixels = io::readImage(normal);
  REQUIRE(pixels.has_value());
  CHECK(pixels->width == 3);
  CHECK(pixels->data[0] == 128);
  CHECK(pixels->data[1] == 128);
  CHECK(pixels->data[2] == 255);
  CHECK(test::runFacet({"normalmap", grey}).status == 2);
  CHECK(test::runFacet({"normalmap", folder.file("none.png"), "-o", normal}).status == 2);
  const test::Outcome scale = test::runFacet({"normalmap", grey, "-o", normal, "--scale", "steep"});
  CHECK(scale.status == 2);
  CHECK(scale.text.find("--scale") != std::string::npos);
}
