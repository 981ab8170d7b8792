#include "report/sweep.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "commands/sweep_plan.hpp"
#include "io/radiance.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;
using report::SweepPlan, report::SweepRow;

namespace {

// A grey picture with noise of a known deviation: sigma / sqrt(samples) of each sRGB value, independent from seed to
// seed.
constexpr double sigma = 0.4, grey = 0.5;
constexpr int edge = 64;

struct FakeRenderer {
  int drawn = 0;
  report::SweepTools tools(const std::filesystem::path& folder) {
    const auto draw = [this](const std::string&, const frame::PictureSettings& settings,
                             int repeat) -> Result<frame::Picture> {
      ++drawn;
      std::mt19937 random(static_cast<unsigned>(settings.quality.seed * 7919 + settings.quality.samples));
      std::normal_distribution<double> noise(0, sigma / std::sqrt(settings.quality.samples));
      frame::Picture picture;
      picture.radiance.width = settings.frame.width, picture.radiance.height = settings.frame.height;
      for (int i = 0; i < settings.frame.width * settings.frame.height; ++i) {
        glm::vec4 pixel(0, 0, 0, 1);
        for (int c = 0; c < 3; ++c) {
          const double shown = grey + noise(random);
          pixel[c] = static_cast<float>(std::pow((shown + 0.055) / 1.055, 2.4));
        }
        picture.radiance.pixels.push_back(pixel);
      }
      picture.statistics.frameMs.assign(static_cast<size_t>(repeat + 1), settings.quality.samples * 2.0);
      return picture;
    };
    const auto key = [](const std::string& model, const frame::PictureSettings& s) {
      return model + " " + s.sources.environment + " " + std::to_string(s.quality.samples) + " " +
             std::to_string(s.quality.seed) + " " + std::to_string(static_cast<int>(s.quality.visibility));
    };
    return {.draw = draw, .key = key, .folder = folder};
  }
};

SweepPlan planOf(int referenceSamples) {
  SweepPlan plan;
  plan.models = {"a", "b"}, plan.environments = {"e"}, plan.sizes = {{edge, edge}}, plan.samples = {16, 64};
  plan.methods = {{"m", {}}};
  plan.referenceSamples = referenceSamples;
  plan.seeds = 3;
  return plan;
}

}  // namespace

TEST_CASE("sweep: errors are those of the noise, the reference's taken out, and what is there is not drawn again") {
  test::TemporaryFolder folder;
  FakeRenderer renderer;
  const auto rows = report::measureSweep(planOf(256), renderer.tools(folder.path()));
  REQUIRE(rows.has_value());
  REQUIRE(rows->rows.size() == 4);
  CHECK(renderer.drawn == 2 * (2 + 2 * 3));  // two parts of the reference, three seeds of two rows each
  for (const SweepRow& row : rows->rows) {
    CHECK(row.error == Approx(255 * sigma / std::sqrt(row.samples)).epsilon(0.02));
    CHECK(row.floor == Approx(255 * sigma / std::sqrt(256)).epsilon(0.03));
    CHECK(row.deviation < 0.02 * row.error);
    CHECK(row.deviation > 0);
    CHECK(row.milliseconds == 2.0 * row.samples);
  }
  // Again: nothing is drawn, the same comes out.
  renderer.drawn = 0;
  const auto again = report::measureSweep(planOf(256), renderer.tools(folder.path()));
  REQUIRE(again.has_value());
  CHECK(renderer.drawn == 0);
  CHECK(again->rows[3].error == rows->rows[3].error);
  // A reference of twice the samples is extended by its other half.
  const auto longer = report::measureSweep(planOf(512), renderer.tools(folder.path()));
  REQUIRE(longer.has_value());
  CHECK(renderer.drawn == 2 * (2 + 2 * 3));
  CHECK(longer->rows[0].floor == Approx(255 * sigma / std::sqrt(512)).epsilon(0.03));
  // A file that was damaged is measured anew.
  renderer.drawn = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "rows"))
    std::filesystem::resize_file(entry.path(), 7);
  REQUIRE(report::measureSweep(planOf(256), renderer.tools(folder.path())).has_value());
  CHECK(renderer.drawn == 2 * 2 * 3);
}

TEST_CASE(
    "sweep: half a row is none, a reference of another size is drawn again, and what fails is told beside the rest") {
  test::TemporaryFolder folder;
  FakeRenderer renderer;
  SweepPlan plan = planOf(256);
  plan.models = {"a"};
  const auto first = report::measureSweep(plan, renderer.tools(folder.path()));
  REQUIRE(first.has_value());
  for (const auto& entry : std::filesystem::directory_iterator(folder.path() / "rows")) {
    std::ifstream file(entry.path());
    nlohmann::json row = nlohmann::json::parse(file);
    row.erase("rays");
    std::ofstream(entry.path()) << row;
  }
  const auto entry = std::filesystem::directory_iterator(folder.path() / "references")->path();
  REQUIRE(io::writeExr(entry, {4, 4, std::vector<glm::vec4>(16, glm::vec4(1))}).has_value());
  renderer.drawn = 0;
  const auto again = report::measureSweep(plan, renderer.tools(folder.path()));
  REQUIRE(again.has_value());
  CHECK(renderer.drawn == 1 + 2 * 3);
  for (size_t i = 0; i < 2; ++i) CHECK(again->rows[i].error == first->rows[i].error);
  // One model cannot be drawn: the other's figures are there.
  plan.models = {"broken", "a"};
  report::SweepTools tools = renderer.tools(folder.path());
  tools.draw = [draw = tools.draw](const std::string& model, const frame::PictureSettings& settings, int repeat) {
    return model == "broken" ? Result<frame::Picture>(fail({}, {}, "broken")) : draw(model, settings, repeat);
  };
  const auto some = report::measureSweep(plan, tools);
  REQUIRE(some.has_value());
  CHECK(some->rows.size() == 2);
  REQUIRE(some->errors.size() == 1);
  CHECK(some->errors[0].file == "broken under e");
}

TEST_CASE("sweep: one tidy table, plots with slopes") {
  test::TemporaryFolder folder;
  FakeRenderer renderer;
  const SweepPlan plan = planOf(256);
  const auto rows = report::measureSweep(plan, renderer.tools(folder.path()));
  REQUIRE(rows.has_value());
  const report::Report made = report::sweepReport(plan, rows->rows);
  REQUIRE(made.tables.size() == 1);
  CHECK(made.tables[0].rows.size() == 4);
  for (const auto& row : made.tables[0].rows) CHECK(row.size() == made.tables[0].columns.size());
  REQUIRE(made.plots.size() == 2);
  CHECK(made.plots[0].plots[0].series[0].name == "m, slope -0.50");
}

TEST_CASE("sweep: plans are read whole, and what is wrong in them is told") {
  using Json = nlohmann::ordered_json;
  const auto problem = [](const char* text) {
    const auto plan = commands::parseSweepPlan(Json::parse(text), "p.json", "");
    return plan ? std::string() : describe(plan.error());
  };
  const auto plan =
      commands::parseSweepPlan(Json::parse(R"({"models": ["a.glb"], "sizes": ["32x16", [8, 4]], "samples": [4],
        "methods": [{"name": "m", "image-light": "mirror"}], "common": {"exposure": -1},
        "reference": {"samples": 300, "light": "paths"}, "seeds": 1})"),
                               "p.json", "/models");
  REQUIRE(plan.has_value());
  CHECK(plan->models == std::vector<std::string>{"/models/a.glb"});
  CHECK(plan->environments == std::vector<std::string>{"builtin:studio"});
  CHECK(plan->sizes == std::vector<glm::ivec2>{{32, 16}, {8, 4}});
  CHECK(plan->methods[0].settings.look.models.imageLight == optics::ImageLight::mirror);
  CHECK(plan->methods[0].settings.display.exposureStops == -1);
  CHECK(plan->reference.display.exposureStops == -1);
  CHECK(plan->referenceSamples == 256);
  CHECK(problem(R"({"model": ["a"]})").find("perhaps models is meant") != std::string::npos);
  CHECK(problem(R"({"models": []})").find("/models") != std::string::npos);
  CHECK(problem(R"({"models": ["builtin:spheres", "builtin:spheres"]})").find("/models/1") != std::string::npos);
  CHECK(problem(R"({"methods": [{"name": "m"}, {"name": "m"}]})").find("/methods/1/name") != std::string::npos);
  CHECK(problem(R"({"methods": [{"name": "m", "samples": 3}]})").find("the sweep sets this itself") !=
        std::string::npos);
  CHECK(problem(R"({"common": {"exposur": 3}})").find("perhaps exposure is meant") != std::string::npos);
  CHECK(problem(R"({"samples": [4, "x"]})").find("/samples/1") != std::string::npos);
  CHECK(problem(R"({"reference": {"samples": 9}})").find("/reference/samples") != std::string::npos);
  const auto method = commands::sweepMethod("mirror:image-light=mirror,visibility=none");
  REQUIRE(method.has_value());
  CHECK(*method == Json({{"name", "mirror"}, {"image-light", "mirror"}, {"visibility", "none"}}));
  CHECK_FALSE(commands::sweepMethod("mirror").has_value());
  CHECK_FALSE(commands::sweepMethod("m:visibility").has_value());
}
