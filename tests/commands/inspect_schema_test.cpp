// What inspect prints against the schema that it is published by.

#include <catch2/catch.hpp>

#include "io/validate/findings.hpp"
#include "support/broken_gltf.hpp"
#include "support/command.hpp"
#include "support/schema.hpp"

using namespace facet;
using Json = nlohmann::json;

TEST_CASE("facet inspect --json is as its schema says") {
  const test::TemporaryFolder folder;
  Json json = Json::parse(test::everything().text());
  json["accessors"][0]["min"][0] = -1;
  json["materials"][1]["extra"] = 1;
  json["nodes"].push_back(Json::object());
  Json shown = Json::parse(test::runFacet({"inspect", folder.write("m.gltf", json.dump()).string(), "--json"}).text);
  CHECK(test::schemaProblems(shown, "inspect") == "");
  CHECK(shown["validation"]["findings"].size() >= 4);
  CHECK_FALSE(shown["validation"]["texelDensity"].empty());
  for (const char* severity : io::validate::severityNames) {
    shown["validation"]["findings"][0]["severity"] = severity;
    CHECK(test::schemaProblems(shown, "inspect") == "");
  }
  shown["validation"]["findings"][0]["severity"] = "fatal";
  CHECK(test::schemaProblems(shown, "inspect") != "");
  json["accessors"][0]["bufferView"] = 99;
  const std::string text = test::runFacet({"inspect", folder.write("n.gltf", json.dump()).string(), "--json"}).text;
  const Json refused = Json::parse(text.substr(0, text.rfind('}') + 1));
  CHECK(test::schemaProblems(refused, "inspect") == "");
  CHECK((refused.contains("refused") && refused.contains("origin")));
}
