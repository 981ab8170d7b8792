#include <catch2/catch.hpp>
#include <cmath>
#include <set>

#include "io/image.hpp"
#include "io/radiance.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"
#include "view/copied_command.hpp"
#include "view/follow.hpp"
#include "view/textured_triangle.hpp"
#include "view/viewer.hpp"

using namespace facet;

using test::texturedTriangle;
using test::Viewer;

TEST_CASE("viewport: a model comes up with its images, a failed one changes nothing", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  REQUIRE(viewer.viewport.scene);
  CHECK(viewer.state.shown.environment == "none");  // nothing in it could be lit
  CHECK(viewer.state.shown.statistics.images == 1);
  viewer.state.camera.target = {0.3, 0.3, 0};
  viewer.state.settings.display.toneMapper = frame::ToneMapper::none;
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
  viewer.state.settings.display.exposureStops = 1;
  CHECK_FALSE(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  viewer.state.settings.frame.width = 80;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.viewport.targets.width == 80);
  viewer.state.settings.look.channel = "baseColor";
  const int list = viewer.viewport.listNumber;
  viewer.settle();
  CHECK(viewer.viewport.listNumber == list + 1);
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));
}

TEST_CASE("viewport: what a setting needs is fetched when it is set, a failed environment is taken back", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  viewer.state.settings.sources.environment = folder.file("missing.hdr");
  view::offerEnvironment(viewer.state, viewer.state.settings.sources.environment);
  view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  viewer.settle();
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.settings.sources.environment == "none");
  CHECK(viewer.state.environments == view::builtinEnvironmentSources());

  viewer.state.settings.look.material.on = true;  // lit, and without the file's image
  viewer.state.settings.sources.environment = "builtin:white";
  viewer.settle();
  CHECK(viewer.state.shown.environment == "builtin:white");
  CHECK(viewer.viewport.environments.shown->tables.dfg);
  CHECK(viewer.viewport.environments.shown->tables.irradiance);
  CHECK(viewer.viewport.environments.shown->tables.background);
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
         s.settings.look.material.on = true;
         view::choosePreset(s.settings.look.material, "gold");
         s.settings.look.material.perceptualRoughness = 1.0f / 3;
         s.settings.look.models.fresnel = optics::FresnelModel::exact;
         s.camera.theta = 12.3456789, s.camera.fovY = 33.3;
       }},
      {"builtin:spheres",
       [](view::ViewerState& s) {
         s.settings.look.material = {true, {0.1f, 0.2f, 0.7f}, 0.5f, 0.15f, 1.9f, {}, {}};
         s.settings.look.lights = frame::Lights::demo;
         s.settings.frame.background = frame::Background::color;
         s.settings.frame.backgroundColor = {0.123f, 1.0f / 3, 0.01f};
         s.settings.quality.samples = 5;
         s.settings.sources.environment = "builtin:sky";
         s.settings.frame.environmentRotationDeg = 33.3f, s.settings.frame.environmentStrength = 0.7f;
       }},
      {"builtin:metals",
       [](view::ViewerState& s) {
         s.settings.look.models.diffuse = optics::DiffuseModel::eon,
         s.settings.display.toneMapper = frame::ToneMapper::agx;
         s.settings.display.exposureStops = -0.3f, s.settings.frame.occlusion = 0.25f;
         s.camera.target = {0.1, -0.2, 0.3}, s.camera.phi = 77.7;
       }},
      {"",
       [](view::ViewerState& s) {
         s.camera.target = {0.3, 0.3, 0};
         s.settings.display.toneMapper = frame::ToneMapper::aces;
       }},
  }));
  Viewer viewer;
  viewer.load(row.model.empty() ? file : row.model);
  row.set(viewer.state);
  viewer.settle();
  viewer.converge();
  test::checkCopiedCommand(viewer, folder);
}

TEST_CASE("viewport: what goes on the GPU in slices is shown when all of it is there", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.viewport.slice = std::chrono::milliseconds(0);  // one object a turn
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  CHECK(viewer.state.shown.model == folder.file("red.glb"));
  view::startModel(viewer.loader, "builtin:spheres");
  int turns = 0;
  while (viewer.loader.running() || viewer.viewport.comingUp) {
    if (auto model = viewer.loader.model.take()) view::takeModel(viewer.viewport, viewer.state, std::move(*model));
    if (auto map = viewer.loader.environment.take())
      view::takeEnvironment(viewer.viewport, viewer.state, std::move(*map));
    view::bringUp(viewer.viewport, viewer.state, viewer.loader);
    if (!viewer.viewport.comingUp) continue;
    ++turns;
    CHECK(viewer.state.shown.model == folder.file("red.glb"));
    REQUIRE(turns < 1000);
  }
  CHECK(viewer.state.shown.model == "builtin:spheres");
  CHECK(turns >= 2);  // the geometry, then at least one program
}

TEST_CASE("viewport: what is large goes on the GPU piece by piece, to the same picture", "[gl]") {
  // A square of 450 x 450 vertices (positions, normals and indices are cut: above frame::uploadPiece) with noise of
  // 1024 x 1024 on it, read in three channels and in two.
  constexpr int side = 450, texels = 1024;
  std::vector<float> positions, normals, uvs;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const float u = static_cast<float>(x) / (side - 1), v = static_cast<float>(y) / (side - 1);
      for (const float p : {2 * u - 1, 2 * v - 1, 0.2f * std::sin(9 * u) * std::cos(7 * v)}) positions.push_back(p);
      for (const float n : {0.0f, 0.0f, 1.0f}) normals.push_back(n);
      for (const float t : {u, v}) uvs.push_back(t);
    }
  std::vector<uint32_t> indices;
  for (uint32_t y = 0; y + 1 < side; ++y)
    for (uint32_t x = 0; x + 1 < side; ++x)
      for (const uint32_t corner : {0, 1, side, 1, side + 1, side}) indices.push_back(y * side + x + corner);
  std::vector<uint8_t> noise(3 * texels * texels);
  uint32_t random = 1;
  for (uint8_t& value : noise) value = static_cast<uint8_t>((random = random * 1664525u + 1013904223u) >> 24);
  test::GltfBuilder b;
  b.append("images", {{"uri", test::dataUri(test::pngBytes(texels, texels, 3, 8, noise), "image/png")}});
  b.append("textures", {{"source", 0}});
  b.append("materials", {{"pbrMetallicRoughness",
                          {{"baseColorTexture", {{"index", 0}}}, {"metallicRoughnessTexture", {{"index", 0}}}}}});
  const int primitive = b.append("meshes", {{"primitives",
                                             {{{"attributes",
                                                {{"POSITION", b.add(positions, test::floatType, "VEC3")},
                                                 {"NORMAL", b.add(normals, test::floatType, "VEC3")},
                                                 {"TEXCOORD_0", b.add(uvs, test::floatType, "VEC2")}}},
                                               {"indices", b.add(indices, test::uintType, "SCALAR")},
                                               {"material", 0}}}}});
  b.json["nodes"] = {{{"mesh", primitive}}};
  b.json["scenes"] = {{{"nodes", {0}}}};
  b.json["scene"] = 0;
  const test::TemporaryFolder folder;
  const std::string file = folder.write("large.glb", b.glb());

  Viewer atOnce, sliced;
  atOnce.viewport.slice = std::chrono::minutes(1);
  sliced.viewport.slice = std::chrono::milliseconds(0);  // one piece a turn
  for (Viewer* viewer : {&atOnce, &sliced}) {
    view::startModel(viewer->loader, file, view::Opening::first);
    int turns = 0;
    for (; viewer->loader.running() || viewer->viewport.comingUp; ++turns) {
      if (auto model = viewer->loader.model.take(true))
        view::takeModel(viewer->viewport, viewer->state, std::move(*model));
      if (auto map = viewer->loader.environment.take(true))
        view::takeEnvironment(viewer->viewport, viewer->state, std::move(*map));
      if (auto images = viewer->loader.images.take(true))
        view::takeImages(viewer->viewport, viewer->state, std::move(*images));
      view::bringUp(viewer->viewport, viewer->state, viewer->loader);
      REQUIRE(turns < 1000);
    }
    REQUIRE(viewer->viewport.scene);
    view::drawViewport(viewer->viewport, viewer->state);
    if (viewer == &sliced) CHECK(turns > 2 * 10 + 5);  // two textures of eleven levels; the pieces of the rest
  }
  CHECK(sliced.display().data == atOnce.display().data);
  const std::vector<uint8_t>& bytes = sliced.display().data;
  CHECK(std::set<uint8_t>(bytes.begin(), bytes.end()).size() > 32);  // something is there to be compared
}

TEST_CASE("viewport: loading is cancelled, what is shown stays", "[gl]") {
  const test::TemporaryFolder folder;
  Viewer viewer;
  viewer.load(folder.write("red.glb", texturedTriangle({255, 0, 0})));
  viewer.state.camera.theta = 12;
  view::startModel(viewer.loader, folder.write("blue.glb", texturedTriangle({0, 0, 255})));
  viewer.state.settings.sources.environment = "builtin:white";
  view::bringUp(viewer.viewport, viewer.state, viewer.loader);
  view::cancelLoading(viewer.viewport, viewer.state, viewer.loader);
  viewer.settle();
  CHECK(viewer.state.shown.model == folder.file("red.glb"));
  CHECK(viewer.state.shown.environment == "none");
  CHECK(viewer.state.settings.sources.environment == "none");
  CHECK(viewer.state.camera.theta == 12);
  CHECK_FALSE(viewer.state.status.isError);
  viewer.load(folder.file("blue.glb"));  // asked for anew it comes
  CHECK(viewer.state.shown.model == folder.file("blue.glb"));
}

TEST_CASE("viewport: a model whose file changes is read again, camera and settings stay", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string source = folder.write("a.glb", texturedTriangle({255, 0, 0}));
  Viewer viewer;
  viewer.load(source);
  viewer.state.camera.theta = 5;
  viewer.state.camera.target = {0.3, 0.3, 0};
  viewer.state.settings.display.toneMapper = frame::ToneMapper::none;
  const scene::OrbitCamera camera = viewer.state.camera;
  view::Followed followed;
  auto now = std::chrono::steady_clock::now();
  const auto look = [&] {
    const bool changed = view::follow(followed, viewer.viewport, viewer.loader, now).model;
    now += std::chrono::milliseconds(500);
    if (changed) viewer.settle();
    return changed;
  };
  CHECK_FALSE(look());
  CHECK_FALSE(look());

  folder.write("a.glb", std::string("glTF half a fi"));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.status.text.find("a.glb") != std::string::npos);
  CHECK(viewer.middle() == glm::ivec3(255, 0, 0));

  folder.write("a.glb", texturedTriangle({0, 0, 255}));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.state.status.text == "reloaded: " + source);
  CHECK(viewer.state.camera == camera);
  CHECK(viewer.middle() == glm::ivec3(0, 0, 255));
  CHECK_FALSE(look());
}

TEST_CASE("viewport: an environment whose file changes is read again, a faulty one leaves what is shown", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string source = folder.file("sky.exr");
  const auto write = [&](float radiance) {
    REQUIRE(io::writeExr(source, {4, 2, std::vector<glm::vec4>(8, glm::vec4(radiance, radiance, radiance, 1))}));
  };
  write(0.25f);
  Viewer viewer;
  viewer.state.settings.sources.environment = source;
  viewer.state.settings.display.toneMapper = frame::ToneMapper::none;
  viewer.load(folder.write("a.glb", texturedTriangle({255, 0, 0})));
  viewer.state.camera.target = {50, 50, 50};  // nothing but sky
  const int dark = viewer.middle().g;
  CHECK(dark == 137);  // 0.25 through the sRGB curve
  view::Followed followed;
  auto now = std::chrono::steady_clock::now();
  const auto look = [&] {
    const bool changed = view::follow(followed, viewer.viewport, viewer.loader, now).environment;
    now += std::chrono::milliseconds(500);
    if (changed) viewer.settle();
    return changed;
  };
  CHECK_FALSE(look());
  folder.write("sky.exr", std::string("half"));
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.state.status.isError);
  CHECK(viewer.state.settings.sources.environment == source);
  CHECK(viewer.middle().g == dark);
  write(1);
  CHECK_FALSE(look());
  CHECK(look());
  CHECK(viewer.middle().g == 255);
  CHECK(viewer.viewport.environments.slots.size() == 1);
}

TEST_CASE("viewport: what plays over a floor goes on, and trees that nobody waits for keep no window awake", "[gl]") {
  test::GltfBuilder b = test::triangle();
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1}, times = {0, 1}, heights = {0, 0, 0, 0, 1, 0};
  b.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = b.add(normals, test::floatType, "VEC3");
  b.append(
      "animations",
      {{"samplers",
        {{{"input", b.add(times, test::floatType, "SCALAR")}, {"output", b.add(heights, test::floatType, "VEC3")}}}},
       {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", "translation"}}}}}}});
  const test::TemporaryFolder folder;
  test::Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.frame.ground = true;
  settings.placement.animation = "all";
  viewer.load(folder.write("rise.glb", b.glb()));
  int shown = 0;
  for (int turn = 1; turn <= 20; ++turn) {
    settings.placement.timeSeconds = 0.04 * turn;  // another pose each turn
    shown += view::bringUp(viewer.viewport, viewer.state, viewer.loader) ? 1 : 0;
  }
  CHECK(shown > 10);
  // Paths are asked for, and no more before their trees are there.
  settings.frame.ground = false;
  settings.quality.samples = 64;
  viewer.settle();
  for (int turn = 0; turn < 3; ++turn) view::drawViewport(viewer.viewport, viewer.state);
  settings.quality.samples = 1;
  settings.quality.visibility = frame::Visibility::none;
  viewer.settle();
  viewer.converge();
  CHECK_FALSE(view::atWork(viewer.viewport, viewer.state));
  CHECK_FALSE(viewer.viewport.comingUp);
}
