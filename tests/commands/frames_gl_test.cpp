// facet render --frames, as a user runs it.

#include <catch2/catch.hpp>

#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/schema.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

// The triangle rises by 1 m in 1 s.
test::GltfBuilder rising() {
  test::GltfBuilder builder = test::triangle();
  const int times = builder.add<float>({0, 1}, test::floatType, "SCALAR");
  const int places = builder.add<float>({0, 0, 0, 0, 1, 0}, test::floatType, "VEC3");
  builder.json["animations"] = {{{"name", "rise"},
                                 {"samplers", {{{"input", times}, {"output", places}}}},
                                 {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  return builder;
}

std::vector<std::string> render(const std::string& model, const std::vector<std::string>& more) {
  std::vector<std::string> words = {"render", model, "--size", "48x48", "--animation", "rise"};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

bool same(const std::string& a, const std::string& b) {
  return test::runFacet({"compare", a, b, "--metric", "largest", "--max-error", "0"}).status == 0;
}

}  // namespace

TEST_CASE("facet render --frames: each frame is the picture at its time, all from the same camera") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("rise.glb", rising().glb()).string();
  const test::Outcome outcome =
      test::runFacet(render(model, {"--frames", "3", "--fps", "2", "-o", folder.file("f_%02d.png")}));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  CHECK_FALSE(std::filesystem::exists(folder.file("f_03.png")));
  for (const auto& [frame, time] :
       {std::pair("f_00.png", "0"), std::pair("f_01.png", "0.5"), std::pair("f_02.png", "1")}) {
    REQUIRE(test::runFacet(render(model, {"--time", time, "-o", folder.file("single.png")})).status == 0);
    CHECK(same(folder.file(frame), folder.file("single.png")));
  }
  CHECK_FALSE(same(folder.file("f_00.png"), folder.file("f_01.png")));
  CHECK_FALSE(same(folder.file("f_01.png"), folder.file("f_02.png")));
}

TEST_CASE("facet render --frames: statistics are the last picture's, with the time of each") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("rise.glb", rising().glb()).string();
  for (const std::string name : {"f_%02d.png", "film.webp"}) {
    const test::Outcome outcome = test::runFacet(
        render(model, {"--frames", "4", "--fps", "8", "-o", folder.file(name), "--stats", folder.file("stats.json")}));
    INFO(outcome.text);
    REQUIRE(outcome.status == 0);
    const auto json = nlohmann::json::parse(test::runShell("cat " + folder.file("stats.json")).text);
    CHECK(test::schemaProblems(json, "stats") == "");
    CHECK_THAT(json["command"].get<std::string>(), Catch::Contains("--time 0.375"));
    CHECK(json["film"]["pictures"] == 4);
    CHECK(json["film"]["fps"] == 8);
    CHECK(json["film"]["seconds"] == 0.5);
    REQUIRE(json["film"]["pictureMs"].size() == 4);
    double last = 0;
    for (const auto& [stage, times] : json["stages"].items()) last += times["wallMs"].get<double>();
    CHECK(json["film"]["pictureMs"][3].get<double>() == Approx(last));
    CHECK(json["film"]["pictureMs"][0] > 0);
  }
}

TEST_CASE("facet render --frames: every way to be wrong has its sentence") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("rise.glb", rising().glb()).string();
  const auto says = [&](std::vector<std::string> words, const std::string& sentence) {
    words.insert(words.begin(), {"render", model});
    const test::Outcome outcome = test::runFacet(words);
    CHECK(outcome.status == 2);
    CHECK_THAT(outcome.text, Catch::Contains(sentence));
  };
  says({"--frames", "2", "-o", folder.file("f_%02d.png")},
       "--frames: nothing moves without an animation; give --animation NAME or all, --turntable or "
       "--camera-path FILE.");
  says({"--frames", "2", "--animation", "rise", "-o", folder.file("f.png")},
       "does not say where the frame's number goes; give a name like frame_%04d.png.");
  says({"--animation", "fall", "-o", folder.file("f.png")}, "(--animation)");
  const auto moving = [&](const std::string& fps, const std::string& sentence) {
    says({"--frames", "5000", "--animation", "rise", "--fps", fps, "-o", folder.file("f_%02d.png")}, sentence);
  };
  moving("nan", "--fps: 'nan' is not a number; give a number from 0.001 to 1e+06");
  moving("0", "--fps: 0 is out of range; give a number from 0.001 to 1e+06");
  moving("0.001", "--frames: picture 1001 would be of a time beyond a million seconds; take fewer, or more a second");
  const test::Outcome regress = test::runFacet({"regress", folder.path().string(), "--timeout", "nan"});
  CHECK(regress.status == 2);
  CHECK_THAT(regress.text, Catch::Contains("--timeout: 'nan' is not a number"));
  says({"--animation", "fall", "-o", folder.file("f.png")}, "there is no animation");
}
