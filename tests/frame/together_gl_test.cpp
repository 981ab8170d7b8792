#include <catch2/catch.hpp>
#include <cstring>

#include "io/sources.hpp"
#include "support/picture.hpp"

namespace facet {

namespace {

using test::GltfBuilder;

io::LoadedModel togetherOf(const std::string& first, const std::string& other) {
  const std::string with[] = {other};
  Result<io::LoadedModel> loaded = io::loadModels(first, with);
  REQUIRE(loaded);
  return std::move(*loaded);
}

// Objects of each kind, of which nothing is seen.
std::string hidden(test::TemporaryFolder& folder) {
  GltfBuilder b = test::triangle();
  b.json["extensionsUsed"] = {"KHR_node_visibility", "KHR_lights_punctual"};
  const std::vector<uint8_t> texels(4 * 4 * 3, 9);
  const int image = b.append("images", {{"uri", test::dataUri(test::pngBytes(4, 4, 3, 8, texels), "image/png")}});
  const int texture = b.append("textures", {{"source", image}});
  b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", texture}}}}}});
  b.json["meshes"][0]["primitives"][0]["material"] = 0;
  b.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.5}, {"znear", 0.1}}}});
  b.append("skins", {{"joints", nlohmann::json::array({0})}});
  b.json["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 1000}}};
  b.json["nodes"][0]["extensions"] = {{"KHR_node_visibility", {{"visible", false}}},
                                      {"KHR_lights_punctual", {{"light", 0}}}};
  const int times = b.add(std::vector<float>{0, 1}, test::floatType, "SCALAR");
  const int places = b.add(std::vector<float>{0, 0, 0, 1, 0, 0}, test::floatType, "VEC3");
  b.json["animations"] = {{{"samplers", {{{"input", times}, {"output", places}}}},
                           {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}}};
  folder.write("hidden.gltf", b.text());
  return (folder.path() / "hidden.gltf").string();
}

}  // namespace

TEST_CASE("A model together with one that is hidden is drawn as alone, to the last bit, whichever comes first",
          "[gl]") {
  test::TemporaryFolder folder;
  const std::string nothing = hidden(folder);
  const std::string model = GENERATE("builtin:robot", "builtin:tutorial");
  frame::PictureSettings settings;
  settings.frame.width = settings.frame.height = 32;
  settings.sources.environment = "builtin:studio";  // else the first model chooses
  settings.quality.samples = GENERATE(4, 6);
  settings.placement.animation = model == "builtin:robot" ? "all" : "";
  settings.placement.timeSeconds = model == "builtin:robot" ? 7.3 : 0;  // some lamps are on
  settings.viewpoint.orbit = {20, 80, model == "builtin:robot" ? 4.0 : 20.0};
  settings.viewpoint.target = glm::dvec3(0, 1, 0), settings.viewpoint.fovYDeg = 40;  // as above
  test::Studio studio;
  const frame::Picture alone = studio.render(*io::loadModel(model), settings);
  for (const bool first : {true, false}) {
    const frame::Picture both =
        studio.render(first ? togetherOf(model, nothing) : togetherOf(nothing, model), settings);
    INFO(model << ", " << settings.quality.samples << " samples, " << (first ? "first" : "second"));
    REQUIRE(both.radiance.pixels.size() == alone.radiance.pixels.size());
    CHECK(std::memcmp(both.radiance.pixels.data(), alone.radiance.pixels.data(),
                      alone.radiance.pixels.size() * sizeof(glm::vec4)) == 0);
  }
}

TEST_CASE("Two models in one scene: both are seen, each where its file has it", "[gl]") {
  test::TemporaryFolder folder;
  const auto quad = [&](const char* name, const glm::vec4& color, glm::vec2 low, glm::vec2 high, double z) {
    GltfBuilder b = test::emptyScene();
    test::addMeshNode(b, test::addQuad(b, low, high), b.append("materials", test::unlit(color)), test::at(0, 0, z));
    if (z == 0) test::addOrthographicCamera(b, 1, 1);
    folder.write(name, b.text());
    return (folder.path() / name).string();
  };
  const std::string back = quad("back.gltf", {1, 0, 0, 1}, {-1, -1}, {1, 1}, 0);
  const std::string front = quad("front.gltf", {0, 1, 0, 1}, {0, -1}, {1, 1}, 1);
  frame::PictureSettings settings = test::bareSettings(4, 4);
  settings.viewpoint.camera = "0";
  const frame::Picture picture = test::Studio().render(togetherOf(back, front), settings);
  test::checkPixel(test::pixel(picture.radiance, 0, 1), {1, 0, 0, 1});
  test::checkPixel(test::pixel(picture.radiance, 3, 1), {0, 1, 0, 1});
}

}  // namespace facet
