#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numeric>

#include "frame/pass_clock.hpp"
#include "support/command.hpp"
#include "support/gpu.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("pass clock: what follows each other adds up, by name, and what is between passes counts for none") {
  frame::PassClock clock;
  CHECK(clock.empty());
  CHECK(clock.take().empty());
  for (int i = 0; i < 3; ++i) {
    clock.begin("a");
    clock.begin("b");
    clock.end();
    clock.end();  // nothing runs: no further stamp
  }
  glFinish();
  CHECK(clock.ready());
  const std::vector<frame::PassTime> times = clock.take();
  REQUIRE(times.size() == 2);
  CHECK(times[0].name == "a");
  CHECK(times[1].name == "b");
  for (const frame::PassTime& time : times) {
    CHECK(time.runs == 3);
    CHECK(time.gpuMs >= 0);
  }
  CHECK(times[0].startMs == 0);
  CHECK(times[1].startMs >= 0);
  CHECK(clock.empty());
}

TEST_CASE("facet render --pass-times: each pass of the frame is timed, and the picture is the same") {
  const test::TemporaryFolder folder;
  const std::string light = GENERATE("direct", "paths");
  const std::string samples = GENERATE("4", "18");
  CAPTURE(light, samples);
  std::vector<std::string> words = {"render",       "builtin:poster", "--size",  "64x48",
                                    "--visibility", "none",           "--light", light,
                                    "--samples",    samples,          "--stats", folder.file("s.json")};
  words.insert(words.end(), {"-o", folder.file("plain.png")});
  REQUIRE(test::runFacet(words).status == 0);
  words.back() = folder.file("timed.png");
  words.insert(words.end(), {"--pass-times", "--repeat", "1"});
  REQUIRE(test::runFacet(words).status == 0);
  CHECK(test::runFacet(
            {"compare", folder.file("plain.png"), folder.file("timed.png"), "--metric", "largest", "--max-error", "0"})
            .status == 0);
  const auto stats = nlohmann::json::parse(test::runShell("cat " + folder.file("s.json")).text);
  REQUIRE(stats.contains("passTimes"));
  double sum = 0;
  std::vector<std::string> names;
  for (const auto& pass : stats["passTimes"]) {
    names.push_back(pass["name"]);
    sum += pass["gpuMs"].get<double>();
    CHECK(pass["gpuMs"].get<double>() > 0);
    if (pass["name"] == "opaque" || pass["name"] == "paths")
      CHECK(pass["runs"] == (samples == "18" || light == "paths" ? std::stoi(samples) : 1));
  }
  for (const auto& pass : stats["frame"]["passes"])
    if (const std::string name = pass; !name.starts_with("gather x"))
      CHECK(std::ranges::find(names, name) != names.end());
  // Parts of the frame that was waited for.
  CHECK(sum <= stats["frameMs"].back().get<double>() * 1.01);
}

TEST_CASE("facet render --pass-times alone is a sentence") {
  const test::Outcome outcome = test::runFacet({"render", "builtin:spheres", "--pass-times", "-o", "/dev/null.png"});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.text, Catch::Contains("--pass-times: is told in statistics; give --stats FILE, too."));
}
