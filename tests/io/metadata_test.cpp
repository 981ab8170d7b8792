#include "io/metadata.hpp"

#include <catch2/catch.hpp>

#include "io/sources.hpp"
#include "scene/glb_container.hpp"

using namespace facet;

namespace {

std::span<const uint8_t> textBytes(const std::string& text) {
  return {reinterpret_cast<const uint8_t*>(text.data()), text.size()};
}

}  // namespace

TEST_CASE("Metadata: asset and extras by what they are about, in .gltf and .glb alike") {
  const std::string text =
      R"({"asset":{"version":"2.0","generator":"by hand"},"nodes":[{},{"extras":{"b":1,"a":[2]}}],)"
      R"("materials":[{"extras":"a note"}],"meshes":[{"extras":null}],"extras":[1,2]})";
  const auto entries = io::readMetadata(textBytes(text), "a.gltf");
  REQUIRE(entries);
  REQUIRE(entries->size() == 5);
  CHECK((*entries)[0].place == "/asset");
  CHECK((*entries)[0].text.find("\"generator\": \"by hand\"") != std::string::npos);
  CHECK((*entries)[1].place == "/nodes/1");
  CHECK((*entries)[1].kind == "extras");
  CHECK((*entries)[1].text == "{\n  \"b\": 1,\n  \"a\": [\n    2\n  ]\n}");  // in the file's order
  CHECK((*entries)[2].place == "/meshes/0");
  CHECK((*entries)[2].text == "null");
  CHECK((*entries)[3].text == "\"a note\"");
  CHECK((*entries)[4].place.empty());
  const std::vector<uint8_t> glb = scene::glbContainer(text, {});
  const auto binary = io::readMetadata(glb, "a.glb");
  REQUIRE(binary);
  REQUIRE(binary->size() == 5);
  CHECK((*binary)[1].text == (*entries)[1].text);
}

TEST_CASE("Metadata: what is broken, long or of no encoding is told or cut") {
  CHECK(describe(io::readMetadata(textBytes("{\"nodes\": ["), "cut.gltf").error()).starts_with("cut.gltf: "));
  CHECK(
      io::readMetadata(textBytes("{\"asset\": 3, \"nodes\": {\"extras\": 1}, \"scenes\": [4]}"), "odd.gltf")->empty());
  std::string deep = "{\"extras\":";
  for (int i = 0; i < 300; ++i) deep += "[";
  CHECK_FALSE(io::readMetadata(textBytes(deep + std::string(300, ']') + "}"), "deep.gltf"));
  const std::string many(40'000, 'x');
  const auto longer = io::readMetadata(textBytes("{\"extras\":\"" + many + "\"}"), "long.gltf");
  REQUIRE(longer);
  CHECK(longer->front().text.size() < io::longestMetadata + 64);
  CHECK(longer->front().text.ends_with("... and 23618 bytes more"));
  const auto latin = io::readMetadata(textBytes("{\"extras\":\"a\xe9z\"}"), "latin.gltf");
  REQUIRE(latin);
  CHECK(latin->front().text != "");
  CHECK(io::readMetadata("builtin:spheres").value().front().kind == "asset");
  CHECK(describe(io::readMetadata("nowhere.glb").error()).find("nowhere.glb") != std::string::npos);
}
