// Triangles without area, texels a metre, memory.

#include "io/validate/validate.hpp"
#include "support/broken_gltf.hpp"

using namespace facet;

namespace {

using Found = std::vector<std::string>;

io::validate::Report reportOf(const std::string& text) {
  return io::validateBytes({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "m.gltf");
}

test::GltfBuilder withFloats(size_t view, const std::vector<float>& values) {
  test::GltfBuilder b = test::everything();
  std::memcpy(&b.bytes[b.json["bufferViews"][view]["byteOffset"].get<size_t>()], values.data(),
              values.size() * sizeof(float));
  return b;
}

}  // namespace

TEST_CASE("Validation: texels a metre and bytes of textures", "[io][validate]") {
  const auto report = reportOf(test::everything().text());
  REQUIRE(report.densities.size() == 1);
  CHECK(report.densities[0].place == "/meshes/0/primitives/0");
  CHECK(report.densities[0].texture == "/materials/0/pbrMetallicRoughness/baseColorTexture");
  CHECK(report.densities[0].middle == Approx(2));  // 2 x 2 texels on a square of one metre
  CHECK(report.textureBytes == (2 * 2 + 4 * 4) * 16 / 3);
}

TEST_CASE("Validation: KHR_texture_transform scales the texels", "[io][validate]") {
  test::GltfBuilder b = test::everything();
  b.json["extensionsUsed"].push_back("KHR_texture_transform");
  b.json["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"] = {
      {"KHR_texture_transform", {{"scale", {3, 12}}}}};
  CHECK(reportOf(b.text()).densities.at(0).middle == Approx(12));  // 2 sqrt(3 * 12)
}

TEST_CASE("Validation: triangles without area", "[io][validate]") {
  test::GltfBuilder b = withFloats(0, {0, 0, 0, 0.5f, 0, 0, 1, 0, 0});
  b.json["accessors"][0]["max"] = {1, 0, 0};
  CHECK(test::findings(b.text()) == Found{"FACET_TRIANGLES_WITHOUT_AREA /meshes/0/primitives/0"});
}

TEST_CASE("Validation: no area on a normal texture, and no tangents", "[io][validate]") {
  test::GltfBuilder b = withFloats(3, {0, 0, 0.5f, 0, 1, 0});
  CHECK(test::findings(b.text()) == Found{});
  b.json["meshes"][0]["primitives"][0]["attributes"].erase("TANGENT");
  const Found found = test::findings(b.text());
  CHECK(std::ranges::count(found, "FACET_TEXCOORDS_WITHOUT_AREA /meshes/0/primitives/0") == 1);
}

TEST_CASE("Validation: uneven texels", "[io][validate]") {
  test::GltfBuilder b = test::everything();
  // Two triangles of one size, of which one has a thousandth of the other's side on the texture.
  const auto add = [&](const std::vector<float>& values, const char* type) {
    return b.add(values, test::floatType, type);
  };
  const int positions = add({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3");
  const int coordinates = add({0, 0, 1, 0, 0, 1, 0, 0, 0.001f, 0, 0, 0.001f}, "VEC2");
  b.json["meshes"][0]["primitives"] = {
      {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", coordinates}}}, {"material", 0}}};
  const auto report = reportOf(b.text());
  REQUIRE(report.densities.size() == 1);
  CHECK(report.densities[0].low == Approx(0.002));
  CHECK(report.densities[0].high == Approx(2));
  const Found found = test::findings(b.text());
  CHECK(std::ranges::count(found, "FACET_TEXEL_DENSITY_UNEVEN /meshes/0/primitives/0") == 1);
}

TEST_CASE("Validation: an accessor that a thousand primitives share is read once", "[io][validate]") {
  test::GltfBuilder b = test::everything();
  for (int i = 0; i < 1000; ++i) b.json["meshes"][0]["primitives"].push_back(b.json["meshes"][0]["primitives"][0]);
  CHECK(test::findings(b.text()) == Found{});
}

TEST_CASE("Validation: only so many findings are kept, and the rest is counted", "[io][validate]") {
  test::GltfBuilder b = test::everything();
  for (size_t i = 0; i < io::validate::mostFindings + 5; ++i) b.json["nodes"].push_back({{"name", 1}});
  const auto report = reportOf(b.text());
  CHECK(report.findings.size() == io::validate::mostFindings);
  CHECK(report.leftOut > 5);
}

TEST_CASE("Validation: built-in scenes and files", "[io][validate]") {
  const auto report = io::validateModel("builtin:spheres");
  REQUIRE(report);
  CHECK(report->count(io::validate::Severity::error) == 0);
  const auto none = io::validateModel("/nowhere/m.glb");
  REQUIRE(!none);
  CHECK(none.error().problem == "no such file");
}

TEST_CASE("Validation: where a finding can be seen", "[io][validate]") {
  const auto shown = [](const std::string& place, const nlohmann::json& edits) {
    nlohmann::json json = nlohmann::json::parse(test::everything().text());
    for (const auto& [pointer, value] : edits.items()) json[nlohmann::json::json_pointer(pointer)] = value;
    const auto report = reportOf(json.dump());
    for (const auto& finding : report.findings)
      if (finding.place == place) return std::pair(finding.node, finding.material);
    return std::pair(-2, -2);
  };
  CHECK(shown("/accessors/0/min/0", {{"/accessors/0/min/0", -1}}) == std::pair(0, -1));
  CHECK(shown("/accessors/16/max/0", {{"/accessors/16/max/0", 3}}) == std::pair(5, -1));
  CHECK(shown("/accessors/14/extra", {{"/accessors/14/extra", 3}}) == std::pair(2, -1));
  CHECK(shown("/bufferViews/9/extra", {{"/bufferViews/9/extra", 3}}) == std::pair(0, -1));
  CHECK(shown("/materials/1/extra", {{"/materials/1/extra", 3}}) == std::pair(5, 1));
  CHECK(shown("/images/1/extra", {{"/images/1/extra", 3}}) == std::pair(0, 0));
  CHECK(shown("/samplers/0/extra", {{"/samplers/0/extra", 3}}) == std::pair(0, 0));
  CHECK(shown("/animations/0/channels/2/target/path", {{"/animations/0/channels/2/target/path", "x"}}) ==
        std::pair(6, -1));
  CHECK(shown("/cameras/1/extra", {{"/cameras/1/extra", 3}}) == std::pair(4, -1));
  CHECK(shown("/extensions/KHR_lights_punctual/lights/0/extra",
              {{"/extensions/KHR_lights_punctual/lights/0/extra", 3}}) == std::pair(7, -1));
  CHECK(shown("/asset/extra", {{"/asset/extra", 3}}) == std::pair(-1, -1));
  CHECK(shown("/nodes/3/extra", {{"/nodes/3/extra", 3}}) == std::pair(3, -1));
}
