#include "view/last.hpp"

#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>

#include "options/picture_options.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

TEST_CASE("What was shown last is kept as a job's options, flags among them", "[view]") {
  test::TemporaryFolder folder;
  frame::PictureSettings settings;
  settings.frame.ground = true;
  settings.frame.width = 640;  // the window's own
  settings.display.exposureStops = -1.5f;
  settings.quality.samples = 64;
  settings.placement.arrangement.edits = {{"/materials/0/alphaCutoff", {0.25}}, {"/nodes/1/scale", {1, 2, 3}}};
  const std::filesystem::path file = folder.path() / "last.json";
  REQUIRE(view::writeLast(file, "a.glb", "b.glb", settings));
  std::ifstream in(file);
  const auto kept = nlohmann::json::parse(in);
  CHECK(kept["model"] == "a.glb");
  CHECK(kept["second"] == "b.glb");
  const nlohmann::json wanted = {{"ground", true},
                                 {"exposure", "-1.5"},
                                 {"samples", "64"},
                                 {"set", "/materials/0/alphaCutoff=0.25;/nodes/1/scale=1,2,3"}};
  CHECK(kept["picture"] == wanted);
}
