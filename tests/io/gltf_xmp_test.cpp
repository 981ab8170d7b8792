#include <catch2/catch.hpp>

#include "support/gltf_load.hpp"

namespace {

using namespace facet;
using namespace facet::test;
using Json = nlohmann::json;

Json packet(const Json& index) { return {{"extensions", {{"KHR_xmp_json_ld", {{"packet", index}}}}}}; }

}  // namespace

TEST_CASE("KHR_xmp_json_ld: packets as text, and what refers to them", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["extensionsRequired"] = b.json["extensionsUsed"] = {"KHR_xmp_json_ld"};
  b.json["extensions"]["KHR_xmp_json_ld"]["packets"] = {{{"dc:title", "a"}}, {{"dc:creator", {"b", 3}}}};
  b.json["asset"].update(packet(1));
  b.json["nodes"][0].update(packet(0));
  b.json["materials"] = {Json::object(), packet(1)};
  const auto model = loaded(b);
  CHECK(notes(model) == "");
  const scene::Metadata& xmp = model.model.xmp;
  CHECK(xmp.packets == std::vector<std::string>{R"({"dc:title":"a"})", R"({"dc:creator":["b",3]})"});
  REQUIRE(xmp.references.size() == 3);
  CHECK(xmp.references[0].object == "/asset");
  CHECK(xmp.references[0].packet == 1);
  CHECK(xmp.references[1].object == "/nodes/0");
  CHECK(xmp.references[1].packet == 0);
  CHECK(xmp.references[2].object == "/materials/1");
}

TEST_CASE("KHR_xmp_json_ld: faults are warnings, for the picture is the same", "[io][gltf]") {
  GltfBuilder b = triangle();
  b.json["extensions"]["KHR_xmp_json_ld"]["packets"] = {Json::object()};
  b.json["nodes"][0].update(packet(1));
  b.json["meshes"][0].update(packet("0"));
  const auto model = loaded(b);
  CHECK(model.model.xmp.references.empty());
  CHECK(notes(model) ==
        "! /nodes/0/extensions/KHR_xmp_json_ld/packet: packet 1 does not exist; there are 1: ignored\n"
        "! /meshes/0/extensions/KHR_xmp_json_ld/packet: is not a whole number: ignored\n");
  b.json["extensions"]["KHR_xmp_json_ld"] = Json::object();
  CHECK(notes(loaded(b)).starts_with("! /extensions/KHR_xmp_json_ld/packets: is not a list of packets: ignored\n"));
}
