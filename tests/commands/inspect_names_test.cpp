// facet inspect --list.

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/schema.hpp"

using namespace facet;

TEST_CASE("facet inspect --list: names that other commands take, a line each") {
  test::GltfBuilder b = test::triangle();
  b.json["scenes"][0]["name"] = "all";
  b.append("scenes", {{"name", "none"}});
  b.append("cameras", {{"name", "gate"}, {"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}});
  b.append("cameras",
           {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}});
  b.append("nodes", {{"camera", 1}, {"name", "the\tside"}});
  b.append("materials", {{"name", "brass"}});
  b.append("materials", nlohmann::json::object());
  const std::vector<float> times = {0, 2.5f}, heights = {0, 0, 0, 0, 1, 0};
  b.append(
      "animations",
      {{"name", "rise"},
       {"samplers",
        {{{"input", b.add(times, test::floatType, "SCALAR")}, {"output", b.add(heights, test::floatType, "VEC3")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  b.json["extensions"]["KHR_materials_variants"]["variants"] = {{{"name", "sea"}}, {{"name", "land"}}};
  b.json["extensionsUsed"] = {"KHR_materials_variants"};
  const test::TemporaryFolder folder;
  const std::string file = folder.write("names.glb", b.glb()).string();
  const test::Outcome text = test::runFacet({"inspect", file, "--list"});
  CHECK(text.status == 0);
  CHECK(text.text ==
        "scene\t0\tall\tdefault\nscene\t1\tnone\ncamera\t0\tgate\tperspective\ncamera\t1\tthe side\torthographic\n"
        "animation\t0\trise\t2.5 s\nvariant\t0\tsea\nvariant\t1\tland\nmaterial\t0\tbrass\nmaterial\t1\t\n");
  const nlohmann::json json = nlohmann::json::parse(test::runFacet({"inspect", file, "--list", "--json"}).text);
  CHECK(test::schemaProblems(json, "names") == "");
  CHECK(json["cameras"][1] == nlohmann::json{{"index", 1}, {"name", "the\tside"}, {"projection", "orthographic"}});
  CHECK(json["animations"][0]["seconds"] == 2.5);
  CHECK(test::runFacet({"inspect", folder.file("no.glb"), "--list"}).status == 2);
}
