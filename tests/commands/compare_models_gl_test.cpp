// facet compare of two models, as a user runs it.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "io/image.hpp"
#include "support/command.hpp"
#include "support/picture.hpp"
#include "support/schema.hpp"

using namespace facet;
using test::runFacet;

namespace {

// A ball of that roughness and size.
std::string ball(const test::TemporaryFolder& folder, const std::string& name, double roughness, double radius) {
  test::GltfBuilder builder = test::emptyScene();
  nlohmann::json material = test::material({0.9f, 0.6f, 0.2f, 1}, 1, roughness);
  material["name"] = "brass";
  builder.append("materials", material);
  test::addMeshNode(builder, test::addSphere(builder, radius, 12, 24), 0);
  return folder.write(name, builder.glb()).string();
}

nlohmann::json parsed(const test::Outcome& outcome) {
  INFO(outcome.text);
  return nlohmann::json::parse(outcome.text.substr(outcome.text.find('{')));
}

}  // namespace

TEST_CASE("facet compare: two models are drawn alike, and what changed is told") {
  const test::TemporaryFolder folder;
  const std::string a = ball(folder, "a.glb", 0.3, 1), b = ball(folder, "b.glb", 0.5, 1);
  const std::vector<std::string> how = {"--size", "48x32", "--samples", "1", "--visibility", "none"};
  const auto compared = [&](const std::string& first, const std::string& second, std::vector<std::string> more = {}) {
    std::vector<std::string> words = {"compare", first, second};
    words.insert(words.end(), how.begin(), how.end());
    words.insert(words.end(), more.begin(), more.end());
    return runFacet(words);
  };
  const nlohmann::json same = parsed(compared(a, a, {"--json"}));
  CHECK(same["changes"].empty());
  CHECK(same["displayRmse"] == 0);
  const std::string sheet = folder.file("sheet.png");
  const test::Outcome outcome = compared(a, b, {"--json", "--max-error", "0.01", "-o", sheet});
  CHECK(outcome.status == 1);
  const nlohmann::json other = parsed(outcome);
  CHECK(test::schemaProblems(other, "compare") == "");
  CHECK(other["changes"] == nlohmann::json{"material 'brass': roughnessFactor 0.3 -> 0.5"});
  CHECK(other["displayRmse"] > 1);
  CHECK(other["origin"]["renderer"].is_string());

  // The figures are those of the pictures that render writes from the same place.
  for (const std::string& model : {a, b}) {
    std::vector<std::string> words = {"render", model, "-o", model + ".png"};
    words.insert(words.end(), how.begin(), how.end());
    REQUIRE(runFacet(words).status == 0);
  }
  const nlohmann::json pictures = parsed(runFacet({"compare", a + ".png", b + ".png", "--json"}));
  CHECK(pictures["displayRmse"] == other["displayRmse"]);
  CHECK(pictures["flip"] == other["flip"]);
  const test::Outcome beside = runFacet({"compare", a + ".png", b + ".png", "-o", folder.file("beside.png")});
  CHECK(beside.status == 0);

  // Both fit, though the other is larger; text says it, too.
  const std::string large = ball(folder, "large.glb", 0.3, 3);
  const test::Outcome grown = compared(a, large);
  CHECK(grown.status == 0);
  CHECK(grown.text.find("size: 2 x 2 x 2 m -> 6 x 6 x 6 m\n") != std::string::npos);
  CHECK(grown.text.find("dRMSE ") != std::string::npos);
  CHECK(grown.text.find("material") == std::string::npos);
}

TEST_CASE("facet compare: models and pictures are not mixed") {
  const test::TemporaryFolder folder;
  const std::string a = ball(folder, "a.glb", 0.3, 1);
  REQUIRE(io::writePng(folder.file("a.png"), {.width = 2, .height = 1, .channels = 1, .data = {9, 9}}).has_value());
  const test::Outcome mixed = runFacet({"compare", a, folder.file("a.png")});
  CHECK(mixed.status == 2);
  CHECK(mixed.text.find("a.png: is no model, and the other is one; name two pictures, two folders or two models.") !=
        std::string::npos);
  const test::Outcome drawn = runFacet({"compare", folder.file("a.png"), folder.file("a.png"), "--env", "none"});
  CHECK(drawn.status == 2);
  CHECK(drawn.text.find("--env: is for models, which are drawn; name two models.") != std::string::npos);
  const test::Outcome missing = runFacet({"compare", a, folder.file("b.glb"), "--size", "8x8"});
  CHECK(missing.status == 2);
  CHECK(missing.text.find("b.glb: ") != std::string::npos);
}
