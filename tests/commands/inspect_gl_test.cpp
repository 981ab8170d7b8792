// facet inspect --brdf against what a picture does.

#include <catch2/catch.hpp>
#include <fstream>

#include "support/command.hpp"
#include "support/gltf_builder.hpp"

using namespace facet;

namespace {

// A lit triangle with a base colour and an occlusion texture of their own, and a normal texture without tangents.
test::GltfBuilder textured() {
  test::GltfBuilder builder = test::triangle();
  nlohmann::json& attributes = builder.json["meshes"][0]["primitives"][0]["attributes"];
  attributes["NORMAL"] = builder.add<float>({0, 0, 1, 0, 0, 1, 0, 0, 1}, test::floatType, "VEC3");
  attributes["TEXCOORD_0"] = builder.add<float>({0, 0, 1, 0, 0, 1}, test::floatType, "VEC2");
  for (int i = 0; i < 2; ++i) {
    const std::vector<uint8_t> texel(3, static_cast<uint8_t>(100 + i));
    builder.append("images", {{"uri", test::dataUri(test::pngBytes(1, 1, 3, 8, texel), "image/png")}});
    builder.append("textures", {{"source", i}});
  }
  builder.json["materials"] = {
      {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}, {"occlusionTexture", {{"index", 1}}}}};
  builder.json["meshes"][0]["primitives"][0]["material"] = 0;
  return builder;
}

}  // namespace

TEST_CASE("facet inspect --brdf: the database, the variants, and the images that a picture does without") {
  const test::TemporaryFolder folder;
  const std::string model = folder.write("m.glb", textured().glb()).string();
  const test::Outcome outcome = test::runFacet({"inspect", model, "--brdf", "builtin:utia-satin", "--json"});
  REQUIRE(outcome.status == 0);
  const nlohmann::json out = nlohmann::json::parse(outcome.text);
  CHECK(out["measured"]["name"] == "utia-satin");
  CHECK(out["measured"]["kind"] == "UTIA, anisotropic");
  CHECK(out["measured"]["cells"] == 288 * 288);
  CHECK(out["measured"]["missingCells"] == 0);
  const nlohmann::json& material = out["materials"][0];
  CHECK_THAT(material["variants"][0].get<std::string>(), Catch::Contains("UTIA BRDF"));
  CHECK(material["textures"] == nlohmann::json{"occlusionTexture"});
  CHECK(material["unusedTextures"] == nlohmann::json{"baseColorTexture"});
  CHECK_THAT(out["leftOut"].dump(), Catch::Contains("1 of 2 images are not decoded"));
  CHECK_THAT(out["notes"].dump(), Catch::Contains("1 draws have no tangents"));
  const std::string stats = folder.file("stats.json");
  REQUIRE(test::runFacet({"render", model, "--brdf", "builtin:utia-satin", "--size", "16x16", "-o",
                          folder.file("m.png"), "--stats", stats})
              .status == 0);
  std::ifstream file(stats);
  CHECK(nlohmann::json::parse(file)["imagesDecoded"] == 1);
}

TEST_CASE("facet inspect --brdf: as text, and what is wrong") {
  CHECK_THAT(test::runFacet({"inspect", "builtin:metals", "--brdf", "builtin:lambert"}).text,
             Catch::Contains("in the place of all lit materials: lambert (MERL, isotropic)"));
  const test::Outcome none = test::runFacet({"inspect", "builtin:metals", "--brdf", "builtin:lambart"});
  CHECK(none.status == 2);
  CHECK_THAT(none.text, Catch::Contains("perhaps lambert is meant"));
  CHECK(test::runFacet({"inspect", "builtin:metals", "--variant", "x", "--brdf", "builtin:lambert"}).status == 2);
}

TEST_CASE("facet inspect: what is wrong with a file, as text and as JSON") {
  const test::TemporaryFolder folder;
  test::GltfBuilder builder = textured();
  builder.json["accessors"][0].update({{"min", {0, 0, 0}}, {"max", {1, 2, 0}}});
  const std::string model = folder.write("m.glb", builder.glb()).string();
  const nlohmann::json out = nlohmann::json::parse(test::runFacet({"inspect", model, "--json"}).text)["validation"];
  CHECK(out["errors"] == 1);
  CHECK(out["leftOut"] == 0);
  CHECK(out["findings"][0] == nlohmann::json{{"severity", "error"},
                                             {"code", "ACCESSOR_MAX_MISMATCH"},
                                             {"pointer", "/accessors/0/max/1"},
                                             {"message", "says 2, but it is 1"},
                                             {"remedy", "write max as it is"},
                                             {"node", 0}});
  CHECK(out["texelDensity"][0]["median"] == 1);
  CHECK(out["textureBytes"] == 2 * 16 / 3);
  CHECK(test::runFacet({"inspect", model}).status == 0);
  const test::Outcome strict = test::runFacet({"inspect", model, "--strict"});
  CHECK(strict.status == 2);
  CHECK_THAT(strict.text,
             Catch::Contains("error ACCESSOR_MAX_MISMATCH: /accessors/0/max/1: says 2, but it is 1; write max"));
}

TEST_CASE("facet inspect: many of one kind, and --all of them") {
  const test::TemporaryFolder folder;
  test::GltfBuilder builder = test::triangle();
  for (int i = 0; i < 8; ++i) builder.append("nodes", nlohmann::json::object());
  const std::string model = folder.write("m.glb", builder.glb()).string();
  CHECK_THAT(test::runFacet({"inspect", model}).text, Catch::Contains("and 3 more of NODE_EMPTY: --all lists them"));
  CHECK_THAT(test::runFacet({"inspect", model, "--all"}).text, Catch::Contains("NODE_EMPTY: /nodes/8: holds nothing"));
}

TEST_CASE("facet inspect: a file that is refused is told about, too") {
  const test::TemporaryFolder folder;
  test::GltfBuilder builder = test::triangle();
  builder.json["accessors"][0]["bufferView"] = 7;
  const std::string model = folder.write("m.glb", builder.glb()).string();
  const test::Outcome outcome = test::runFacet({"inspect", model});
  CHECK(outcome.status == 2);
  CHECK_THAT(outcome.text, Catch::Contains("UNRESOLVED_REFERENCE: /accessors/0/bufferView: names 7, but there are 1"));
  CHECK_THAT(outcome.text, Catch::Contains("buffer view 7 does not exist"));
}
