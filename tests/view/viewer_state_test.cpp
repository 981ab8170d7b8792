#include "view/viewer_state.hpp"

#include <catch2/catch.hpp>

#include "frame/picture.hpp"
#include "io/gltf.hpp"
#include "optics/presets.hpp"
#include "options/picture_options.hpp"
#include "support/gltf_builder.hpp"
#include "support/temporary_folder.hpp"
#include "view/screenshot.hpp"
#include "view/statistics_panel.hpp"

using namespace facet;

TEST_CASE("viewer state: a built-in scene brings its camera and environment, what is given wins") {
  const scene::Model model;
  frame::PictureSettings settings;
  settings.frame.width = 800;
  settings.frame.height = 600;
  CHECK(frame::chooseEnvironment(settings, "builtin:furnace", model, 0) == "builtin:white");
  settings.sources.environment = "none";
  CHECK(frame::chooseEnvironment(settings, "builtin:furnace", model, 0) == "none");

  const scene::Bounds bounds = {glm::dvec3(-1), glm::dvec3(1)};
  CHECK(frame::chooseOrbit(settings.viewpoint, frame::aspectOf(settings.frame), "builtin:furnace", bounds).radius ==
        14);
  CHECK(frame::chooseOrbit(settings.viewpoint, frame::aspectOf(settings.frame), "furnace", bounds) ==
        scene::frameBounds(bounds, 45, 800.0 / 600));
  settings.frame.height = 1600;
  CHECK(frame::chooseOrbit(settings.viewpoint, frame::aspectOf(settings.frame), "builtin:furnace", bounds).radius ==
        28);
  settings.viewpoint.orbit = frame::Orbit{10, 20, std::nullopt};
  settings.viewpoint.target = glm::dvec3(1, 2, 3);
  const scene::OrbitCamera camera =
      frame::chooseOrbit(settings.viewpoint, frame::aspectOf(settings.frame), "builtin:furnace", bounds);
  CHECK(camera.theta == 10);
  CHECK(camera.phi == 20);
  CHECK(camera.radius == 28);
  CHECK(camera.target == glm::dvec3(1, 2, 3));
}

TEST_CASE("viewer state: the copied command gives the same settings again") {
  view::ViewerState state;
  state.settings.frame.width = 1280;
  state.settings.frame.height = 800;
  state.settings.display.exposureStops = -1.5f;
  state.settings.frame.environmentRotationDeg = 30;
  state.settings.look.channel = "normal";
  state.shown.environment = "builtin:sky";
  state.camera = {12.5, 80, 3.25, {0.5, 1, -2}, 35};
  const std::string line = options::commandLine(view::commandSettings(state), "a b.glb");
  CHECK(line ==
        "facet 'a b.glb' --size 1280x800 --orbit 12.5,80,3.25 --target 0.5,1,-2 --fov-y 35 --env builtin:sky "
        "--env-rotation 30 --exposure -1.5 --channel normal");
  state.settings.viewpoint.camera = "door";
  CHECK(options::commandLine(view::commandSettings(state), "a.glb") ==
        "facet a.glb --size 1280x800 --camera door --env builtin:sky --env-rotation 30 --exposure -1.5 "
        "--channel normal");
}

TEST_CASE("viewer state: a measured BRDF takes the materials' place, and gives it back") {
  view::ViewerState state;
  using view::MaterialSource;
  CHECK(view::materialSource(state.settings) == MaterialSource::file);
  state.settings.look.material = {true, {0.1f, 0.2f, 0.3f}, 0.75f, 0.25f, 1.5f, {}, {}};
  CHECK(view::materialSource(state.settings) == MaterialSource::one);
  view::chooseBrdf(state, "a.binary");
  CHECK(view::materialSource(state.settings) == MaterialSource::measured);
  CHECK_FALSE(state.settings.look.material.on);
  CHECK(state.settings.sources.brdf == "a.binary");

  view::chooseMaterialSource(state, MaterialSource::one);
  CHECK(state.settings.sources.brdf.empty());
  CHECK(state.settings.look.material.perceptualRoughness == 0.25f);
  view::chooseMaterialSource(state, MaterialSource::measured);
  CHECK(state.settings.sources.brdf == "a.binary");
  view::chooseMaterialSource(state, MaterialSource::file);
  CHECK(view::materialSource(state.settings) == MaterialSource::file);
  view::ViewerState fresh;
  view::chooseMaterialSource(fresh, MaterialSource::measured);
  CHECK(fresh.settings.sources.brdf == "builtin:plastic-0.2");
  fresh = {};
  fresh.databases = {view::fileEntry(view::FileKind::brdf, "/b/gold.binary")};
  view::chooseMaterialSource(fresh, MaterialSource::measured);
  CHECK(fresh.settings.sources.brdf == "/b/gold.binary");
}

TEST_CASE("viewer state: the material choice takes every draw's place") {
  const std::vector<uint8_t> glb = test::triangle().glb();
  const Result<io::LoadedModel> loaded = io::loadGltfBytes(glb, "triangle.glb");
  REQUIRE(loaded);
  view::ViewerState state;
  state.settings.look.material = {true, {0.1f, 0.2f, 0.3f}, 0.75f, 0.25f, 1.5f, {}, {}};
  const frame::DrawList list = frame::buildDrawList(loaded->model, 0, frame::drawOptions(state.settings, true));
  REQUIRE(list.opaque.size() == 1);
  const scene::Material& material = list.materials[static_cast<size_t>(list.opaque[0].material)];
  CHECK(material.baseColorFactor == glm::vec4(0.1f, 0.2f, 0.3f, 1));
  CHECK(material.metallicFactor == 0.75f);
  CHECK(material.perceptualRoughnessFactor == 0.25f);
  CHECK(view::variantCount(list) == 1);
}

TEST_CASE("viewer state: numbers for people") {
  CHECK(view::grouped(0) == "0");
  CHECK(view::grouped(999) == "999");
  CHECK(view::grouped(1000) == "1 000");
  CHECK(view::grouped(1234567) == "1 234 567");
  CHECK(view::milliseconds(3.254) == "3.25 ms");
  CHECK(view::milliseconds(5555.4) == "5555 ms");
  CHECK(view::byteText(999) == "999 B");
  CHECK(view::byteText(1000) == "1.0 kB");
  CHECK(view::byteText(9960) == "10 kB");
  CHECK(view::byteText(999'600) == "1.0 MB");
  CHECK(view::byteText(84'123'456) == "84 MB");
  CHECK(view::byteText(~uint64_t{0}) == "18 EB");
}

TEST_CASE("screenshot: the name tells the time and overwrites nothing") {
  const test::TemporaryFolder folder;
  std::tm time{};
  time.tm_year = 124, time.tm_mon = 1, time.tm_mday = 29, time.tm_hour = 7, time.tm_min = 5, time.tm_sec = 9;
  CHECK(view::newName(time, folder.path(), ".png") == folder.path() / "facet-20240229-070509.png");
  folder.write("facet-20240229-070509.png", std::string("x"));
  folder.write("facet-20240229-070509-2.png", std::string("x"));
  CHECK(view::newName(time, folder.path(), ".png") == folder.path() / "facet-20240229-070509-3.png");
}

TEST_CASE("Presets: a metal brings colour and conductor, a dielectric its index, sources are told") {
  view::ViewerState state;
  state.settings.look.material.on = true;
  state.settings.look.material.perceptualRoughness = 0.25f;
  view::choosePreset(state.settings.look.material, "gold");
  scene::Material made = frame::overridingMaterial(state.settings.look.material);
  CHECK(made.conductor == "gold");
  CHECK(made.metallicFactor == 1);
  CHECK(made.perceptualRoughnessFactor == 0.25f);
  CHECK(made.baseColorFactor.r == Approx(optics::findMetal("gold")->f0().r));
  const glm::vec3 colour = state.settings.look.material.baseColor;
  view::choosePreset(state.settings.look.material, "diamond");
  made = frame::overridingMaterial(state.settings.look.material);
  CHECK(made.conductor.empty());
  CHECK(made.metallicFactor == 0);
  CHECK(made.ior == Approx(2.4175));
  CHECK(state.settings.look.material.baseColor == colour);
  CHECK(view::presetText("gold").find("Johnson and Christy 1972") != std::string::npos);
  CHECK(view::presetText("diamond").find("2.417") != std::string::npos);
  CHECK(view::presetText("unobtainium").empty());
}

TEST_CASE("viewer state: messages are kept whole, with their time, and counted while what they are about is shown") {
  view::ViewerState state;
  CHECK(view::messageCount(state.messages).empty());
  view::note(state, "chair.glb: /meshes/0: has no normals.", false);
  CHECK(view::messageCount(state.messages) == "1 warning");
  state.status = {"table.glb: no such file.", true};
  view::noteProblem(state);
  view::noteProblem(state);  // each frame
  CHECK(view::messageCount(state.messages) == "1 problem, 1 warning");
  REQUIRE(state.messages.size() == 2);
  CHECK(state.messages[1].text == "table.glb: no such file.");
  CHECK(state.messages[0].time.size() == 8);
  for (view::Message& message : state.messages) message.past = true;
  CHECK(view::messageCount(state.messages).empty());
  view::noteProblem(state);  // again, of what is shown now
  CHECK(view::messageCount(state.messages) == "1 problem");
  for (int i = 0; i < 300; ++i) view::note(state, std::to_string(i), true);
  CHECK(state.messages.size() == 100);
  CHECK(state.messages.back().text == "299");
}

TEST_CASE("viewer state: a view of everything fits into what no panel covers, the picture's middle in the middle") {
  view::ViewerState state;
  state.settings.frame.width = 1280;
  state.settings.frame.height = 800;
  CHECK(view::framingAspect(state) == Approx(1.6));
  state.coveredLeft = 252, state.coveredRight = 294;
  CHECK(view::framingAspect(state) == Approx((1280 - 2 * 294) / 800.0));
  state.coveredLeft = 900;
  CHECK(view::framingAspect(state) == Approx(0.3 * 1.6));
}
