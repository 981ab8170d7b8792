// Commands that draw what strangers wrote: they say that they are confined, and what they need is open to them: models
// with files beside them, environments in other folders, outputs, and nothing else.

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "io/radiance.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"

using namespace facet;

namespace {

namespace fs = std::filesystem;

// model/a.gltf with its buffer beside it, light/light.gltf with six images beside it, light/grey.hdr, an empty out/.
struct Files {
  test::TemporaryFolder folder;
  std::string model = at("model/a.gltf"), light = at("light/light.gltf"), grey = at("light/grey.hdr");

  std::string at(const std::string& name) const { return (folder.path() / name).string(); }
  Files() {
    fs::create_directory(folder.path() / "out");
    test::GltfBuilder b = test::triangle();
    const std::vector<uint8_t> data = b.bytes;
    folder.write("model/a.bin", data);
    b.bytes.clear();
    b.json["buffers"] = {{{"byteLength", data.size()}, {"uri", "a.bin"}}};
    folder.write("model/a.gltf", b.json.dump());

    test::GltfBuilder l = test::triangle();
    nlohmann::json level = nlohmann::json::array();
    for (int face = 0; face < 6; ++face) {
      const std::string name = std::to_string(face) + ".png";
      folder.write("light/" + name, test::pngBytes(2, 2, 3, 8, std::vector<uint8_t>(12, 200)));
      level.push_back(l.append("images", {{"uri", name}}));
    }
    l.json["extensions"]["EXT_lights_image_based"]["lights"] = {{{"specularImages", {level}}}};
    l.json["extensionsUsed"] = {"EXT_lights_image_based"};
    l.json["buffers"] = {{{"byteLength", l.bytes.size()}, {"uri", test::dataUri(l.bytes)}}};
    folder.write("light/light.gltf", l.json.dump());
    std::string hdr = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n";
    for (int i = 0; i < 2; ++i) hdr += "\x80\x80\x80\x81";
    folder.write("light/grey.hdr", hdr);
  }
};

}  // namespace

TEST_CASE("confined: render and a file manager's preview read what they draw and no more", "[gl]") {
  const Files files;
  const std::vector<std::string> render = {"render",     files.model, "--size",       "16x16",
                                           "--samples",  "1",         "--visibility", "none",
                                           "--no-cache", "--strict",  "-o",           files.at("out/a.png")};
  for (const std::string& environment : {files.grey, files.light}) {
    std::vector<std::string> words = render;
    words.insert(words.end(), {"--env", environment});
    test::checkConfined(words);
    CHECK(io::readImage(files.at("out/a.png")));
  }
  // Beside the model only through a link, whose target was not named.
  fs::create_directory(files.folder.path() / "elsewhere");
  fs::rename(files.folder.path() / "model/a.bin", files.folder.path() / "elsewhere/a.bin");
  fs::create_symlink("../elsewhere/a.bin", files.folder.path() / "model/a.bin");
  CHECK(test::runFacet(render).status == 2);
  std::vector<std::string> allowed = render;
  allowed.insert(allowed.end(), {"--allow-outside", files.at("elsewhere")});
  test::checkConfined(allowed);
}

TEST_CASE("confined: regress's processes read the suite's files, other suites' models and environments", "[gl]") {
  const Files files;
  files.folder.write("suite/suite.json",
                     nlohmann::json({{"defaults", {{"size", "16x16"}, {"samples", 1}}},
                                     {"jobs",
                                      {{{"name", "a"}, {"model", files.model}, {"env", files.grey}},
                                       {{"name", "b"}, {"model", files.model}, {"env", files.light}}}}})
                         .dump());
  const std::string regress = test::facetPath() + " regress " + files.at("suite") + " --accept";
  const test::Outcome usual = test::runShell(regress);
  INFO(usual.text);
  CHECK(usual.status == 0);
  CHECK(usual.text.find("cannot be") == std::string::npos);
  const auto picture = [&](const char* name) {
    std::ifstream in(files.at("suite/baselines") + "/" + name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {});
  };
  const std::string a = picture("a.png"), b = picture("b.png");
  CHECK(a.size() > 100);
  CHECK(b.size() > 100);
  const test::Outcome open = test::runShell(regress + " --no-sandbox");
  INFO(open.text);
  CHECK(open.status == 0);
  CHECK(picture("a.png") == a);
  CHECK(picture("b.png") == b);
}

TEST_CASE("confined: report, sweep and tables reach models, environments and their folders", "[gl]") {
  const Files files;
  files.folder.write("plan.json", nlohmann::json({{"models", {files.model}},
                                                  {"environments", {files.grey, files.light}},
                                                  {"sizes", {"8x8"}},
                                                  {"samples", {1}},
                                                  {"seeds", 1},
                                                  {"repeat", 0},
                                                  {"methods", {{{"name", "tables"}, {"visibility", "none"}}}},
                                                  {"reference", {{"samples", 256}}}})
                                      .dump());
  test::checkConfined({"sweep", files.at("plan.json"), "-o", files.at("swept")});
  CHECK(fs::exists(files.at("swept/sweep.csv")));
  test::checkConfined({"report", "frame", files.model, "--env", files.light, "--size", "16", "--samples", "2",
                       "--repeat", "1", "-o", files.at("reported")});
  CHECK(fs::exists(files.at("reported/report.json")));
  test::checkConfined({"report", "fresnel", "-o", files.at("out/fresnel.md")});
  test::checkConfined({"tables", "--env", files.light, "-o", files.at("tables")});
  CHECK(io::readRadiance(files.at("tables/irradiance.exr")));
}
