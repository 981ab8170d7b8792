#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "commands/option_text.hpp"
#include "commands/picture_options.hpp"
#include "io/image.hpp"
#include "support/command.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"
#include "view/viewer.hpp"

using namespace facet;

namespace {

using test::Viewer;

// A triangle that covers the middle of the picture, unlit, with this texture.
std::vector<uint8_t> texturedTriangle(const std::vector<uint8_t>& rgb) {
  test::GltfBuilder b = test::triangle();
  const std::vector<uint8_t> png = test::pngBytes(1, 1, 3, 8, rgb);
  b.append("images", {{"uri", test::dataUri(png, "image/png")}});
  b.append("textures", {{"source", 0}});
  b.append("materials", {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}},
                         {"doubleSided", true},
                         {"extensions", {{"KHR_materials_unlit", nlohmann::json::object()}}}});
  b.json["extensionsUsed"] = {"KHR_materials_unlit"};
  const std::vector<float> uv = {0, 0, 1, 0, 0, 1}, normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  nlohmann::json& primitive = b.json["meshes"][0]["primitives"][0];
  primitive["attributes"]["NORMAL"] = b.add(normals, test::floatType, "VEC3");
  primitive["attributes"]["TEXCOORD_0"] = b.add(uv, test::floatType, "VEC2");
  primitive["material"] = 0;
  return b.glb();
}

}  // namespace

TEST_CASE("viewport: a model comes up with its images, a failed one changes nothing", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  REQUIRE(viewer.viewport.scene);
  CHECK(viewer.state.shown.environment == "none");  // nothing in it could be lit
  CHECK(viewer.state.shown.statistics.images == 1);
  viewer.state.camera.target = {0.3, 0.3, 0};
  viewer.state.settings.toneMapper = frame::ToneMapper::none;
  CHECK(viewer.middle() == glm::ivec3(255, 0, 0));
  CHECK(viewer.state.shown.statistics.imagesDecoded == 1);
  CHECK(viewer.state.shown.statistics.frame.triangles == 1);
  const scene::OrbitCamera camera = viewer.state.camera;

  viewer.load(folder.file("missing.glb"));
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find("missing.glb") != std::string::npos);
  CHECK(viewer.state.shown.model == folder.file("red.glb"));
  CHECK(viewer.state.camera == camera);
  CHECK(viewer.middle() == glm::ivec3(255, 0, 0));

  viewer.load(folder.write("blue.glb", texturedTriangle({0, 0, 255})));
  CHECK(viewer.state.shown.model == folder.file("blue.glb"));
  viewer.state.camera.target = {0.3, 0.3, 0};
  CHECK(viewer.middle() == glm::ivec3(0, 0, 255));
}

TEST_CASE("viewport: the newest of several loads is shown", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string red = folder.write("red.glb", texturedTriangle({255, 0, 0}));
  const std::string blue = folder.write("blue.glb", texturedTriangle({0, 0, 255}));
  Viewer viewer;
  for (const std::string& source : {red, blue, red, blue}) view::startModel(viewer.loader, source);
  viewer.settle();
  CHECK(viewer.state.shown.model == blue);
}

TEST_CASE("viewport: a frame is drawn only where something has changed", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
  viewer.state.camera.theta += 1;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  viewer.state.settings.exposureStops = 1;
  CHECK_FALSE(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  viewer.state.settings.width = 80;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.viewport.targets.width == 80);
  viewer.state.settings.channel = "baseColor";
  CHECK(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
}

TEST_CASE("viewport: what a setting needs is fetched when it is set, a failed environment is taken back", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  viewer.state.settings.environment = folder.file("missing.hdr");
  view::offerEnvironment(viewer.state, viewer.state.settings.environment);
  view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  viewer.settle();
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.settings.environment == "none");
  CHECK(viewer.state.environments == view::builtinEnvironmentSources());

  viewer.state.settings.material.on = true;  // lit, and without the file's image
  viewer.state.settings.environment = "builtin:white";
  viewer.settle();
  CHECK(viewer.state.shown.environment == "builtin:white");
  CHECK(viewer.viewport.environments.shown->onGpu.tables.dfg);
  CHECK(viewer.viewport.environments.shown->onGpu.tables.irradiance);
  CHECK(viewer.viewport.environments.shown->onGpu.tables.background);
}

TEST_CASE("viewport: the copied command renders the picture on the screen, byte by byte", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("red triangle.glb", texturedTriangle({255, 40, 10}));
  struct Row {
    std::string model;  // empty: the file
    void (*set)(view::ViewerState&);
  };
  const Row row = GENERATE(values<Row>({
      {"builtin:spheres",
       [](view::ViewerState& s) {
         s.settings.material.on = true;
         view::choosePreset(s.settings.material, "gold");
         s.settings.material.perceptualRoughness = 1.0f / 3;
         s.settings.fresnel = optics::FresnelModel::exact;
         s.camera.theta = 12.3456789, s.camera.fovY = 33.3;
       }},
      {"builtin:spheres",
       [](view::ViewerState& s) {
         s.settings.material = {true, {0.1f, 0.2f, 0.7f}, 0.5f, 0.15f, 1.9f, {}};
         s.settings.lights = frame::Lights::demo;
         s.settings.background = frame::Background::color;
         s.settings.backgroundColor = {0.123f, 1.0f / 3, 0.01f};
         s.settings.samples = 5;
         s.settings.environment = "builtin:sky";
         s.settings.environmentRotationDeg = 33.3f, s.settings.environmentStrength = 0.7f;
       }},
      {"builtin:metals",
       [](view::ViewerState& s) {
         s.settings.diffuse = optics::DiffuseModel::eon, s.settings.toneMapper = frame::ToneMapper::agx;
         s.settings.exposureStops = -0.3f, s.settings.occlusion = 0.25f;
         s.camera.target = {0.1, -0.2, 0.3}, s.camera.phi = 77.7;
       }},
      {"",
       [](view::ViewerState& s) {
         s.camera.target = {0.3, 0.3, 0};
         s.settings.toneMapper = frame::ToneMapper::aces;
       }},
  }));
  Viewer viewer;
  viewer.load(row.model.empty() ? file : row.model);
  row.set(viewer.state);
  viewer.settle();
  viewer.converge();
  REQUIRE(io::writePng(folder.file("window.png"), viewer.display()));

  const std::string line =
      commands::commandLine(view::commandSettings(viewer.state), viewer.state.shown.model, folder.file("command.png"));
  INFO(line);
  REQUIRE(line.starts_with("facet render "));
  const test::Outcome outcome = test::runShell(commands::shellWord(test::facetPath()) + line.substr(5));
  INFO(outcome.text);
  REQUIRE(outcome.status == 0);
  const auto bytes = [&](const char* name) {
    std::ifstream stream(folder.file(name), std::ios::binary);
    return std::vector<char>(std::istreambuf_iterator<char>(stream), {});
  };
  CHECK(bytes("window.png").size() > 200);
  CHECK(bytes("command.png") == bytes("window.png"));
}
