#include <catch2/catch.hpp>
#include <cmath>

#include "support/picture.hpp"
#include "support/temporary_folder.hpp"
#include "view/viewer.hpp"

using namespace facet;
using test::Viewer;

namespace {

// In 1/255.
double rmsDifference(const io::Pixels& a, const io::Pixels& b) {
  REQUIRE(a.data.size() == b.data.size());
  double sum = 0;
  for (size_t i = 0; i < a.data.size(); ++i) sum += std::pow(double(a.data[i]) - double(b.data[i]), 2);
  return std::sqrt(sum / double(a.data.size()));
}

io::Pixels renderedWhole(const std::string& source, frame::PictureSettings settings) {
  test::Studio studio;
  return studio.render(test::loadBuiltin(source), frame::restingSettings(settings)).display;
}

// A slab of glass before a checked wall, and a blended square before both.
test::GltfBuilder glassScene() {
  test::GltfBuilder b = test::emptyScene();
  b.append("materials", test::material({0.8f, 0.3f, 0.1f, 1}, 0, 0.5));
  nlohmann::json glass = test::material({1, 1, 1, 1}, 0, 0.2);
  glass["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}}};
  b.append("materials", glass);
  nlohmann::json veil = test::material({0.1f, 0.4f, 0.9f, 0.5f}, 0, 0.4);
  veil["alphaMode"] = "BLEND";
  b.append("materials", veil);
  test::addMeshNode(b, test::addSphere(b, 1), 0, test::at(0, 0, -2));
  test::addMeshNode(b, test::addSphere(b, 0.7), 1, test::at(0.2, 0, 0));
  test::addMeshNode(b, test::addQuad(b, {-1, -1}, {0.3f, 1}), 2, test::at(-0.2, 0, 1));
  return b;
}

}  // namespace

TEST_CASE("refinement: a resting picture becomes what facet render makes, byte by byte", "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.samples = 16;
  viewer.load("builtin:spheres");
  CHECK(viewer.converge() >= 4);  // steps end at the estimates at the latest
  CHECK(viewer.state.refinement.shown == 16);
  CHECK(viewer.state.refinement.error >= 0);
  CHECK((viewer.display().data == renderedWhole("builtin:spheres", viewer.state.settings).data));
  CHECK_FALSE(view::drawViewport(viewer.viewport, viewer.state));

  // However the work is cut: in bands of rows, too.
  viewer.state.settings.display.exposureStops = 1;
  view::drawViewport(viewer.viewport, viewer.state);
  while (view::refining(viewer.viewport, viewer.state)) {
    view::drawViewport(viewer.viewport, viewer.state);
    glFinish();
    viewer.viewport.refinement.rows = 7;
  }
  CHECK((viewer.display().data == renderedWhole("builtin:spheres", viewer.state.settings).data));
}

TEST_CASE("refinement: an error to keep to asks for more samples until it is kept, as facet render does", "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.samples = 256;
  viewer.state.settings.quality.maxError = 0.01;
  viewer.state.settings.quality.visibility = frame::Visibility::none;
  viewer.load("builtin:poster");
  viewer.converge();
  test::Studio studio;
  const frame::Picture picture =
      studio.render(test::loadBuiltin("builtin:poster"), frame::restingSettings(viewer.state.settings));
  const std::vector<frame::Attempt>& attempts = picture.statistics.attempts;
  REQUIRE(attempts.size() >= 2);
  CHECK(viewer.state.refinement.shown == attempts.back().samples);
  CHECK(viewer.state.refinement.error == Approx(attempts.back().error.most).epsilon(1e-4));
  CHECK(viewer.state.refinement.error <= 255 * 0.01);
  CHECK((viewer.display().data == picture.display.data));

  // A looser one is kept at once, with coarser tables; none at all asks for the chosen number.
  viewer.state.settings.quality.maxError = 0.1;
  viewer.settle();
  viewer.converge();
  CHECK(viewer.state.refinement.shown == 8);
  CHECK(viewer.viewport.environments.shown->method.irradianceSize == 8);
  viewer.state.settings.quality.maxError.reset();
  viewer.state.settings.quality.samples = 16;
  viewer.settle();
  viewer.converge();
  CHECK(viewer.state.refinement.shown == 16);
  CHECK(viewer.viewport.environments.shown->method.irradianceSize == 32);
  CHECK((viewer.display().data == renderedWhole("builtin:poster", viewer.state.settings).data));
}

TEST_CASE("refinement: glass, blending, an odd number of samples and a coloured background", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("glass.glb", glassScene().glb());
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.quality.samples = 7;
  settings.sources.environment = "builtin:studio";
  settings.frame.background = frame::Background::color;
  settings.frame.backgroundColor = {0.2f, 0.4f, 0.1f};
  viewer.load(file);
  viewer.converge();
  CHECK(viewer.state.refinement.shown == 7);
  test::Studio studio;
  io::LoadedModel model = test::loadBuilt(glassScene());
  model.model.name = file;
  CHECK((viewer.display().data == studio.render(model, frame::restingSettings(settings)).display.data));
}

TEST_CASE("refinement: traced light, with glass, blending and lamps, and back to the unblocked one", "[gl]") {
  const test::TemporaryFolder folder;
  const std::string file = folder.write("glass.glb", glassScene().glb());
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.quality.samples = 3;
  settings.sources.environment = "builtin:sky";  // its sun is a light of its own for the other pictures
  settings.look.lights = frame::Lights::demo;
  viewer.load(file);
  viewer.converge();
  const io::Pixels direct = viewer.display();
  CHECK_FALSE(viewer.viewport.shown.paths);
  test::Studio studio;
  io::LoadedModel model = test::loadBuilt(glassScene());
  model.model.name = file;
  settings.quality.transport = frame::Transport::paths;
  for (const int bounces : {0, 16}) {
    settings.quality.bounces = bounces;
    viewer.converge();
    CHECK(viewer.state.refinement.shown == 3);
    CHECK((viewer.display().data == studio.render(model, frame::restingSettings(settings)).display.data));
    CHECK((viewer.display().data != direct.data));
  }
  settings.quality.transport = frame::Transport::direct;
  viewer.converge();
  CHECK((viewer.display().data == direct.data));
}

TEST_CASE("refinement: any change starts with the cheap picture, and few samples end there", "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.samples = 4;
  viewer.load("builtin:spheres");
  view::drawViewport(viewer.viewport, viewer.state);
  CHECK_FALSE(view::refining(viewer.viewport, viewer.state));
  CHECK_FALSE(viewer.viewport.refinement.targets.sum);
  CHECK_FALSE(viewer.viewport.environments.shown->tables.rest);
  CHECK(view::refinementText(viewer.state.refinement).empty());
  const io::Pixels cheap = viewer.display();

  viewer.state.settings.quality.samples = 8;
  CHECK_FALSE(view::bringUp(viewer.viewport, viewer.state, viewer.loader));
  viewer.converge();
  CHECK((viewer.display().data != cheap.data));
  CHECK_THAT(view::refinementText(viewer.state.refinement), Catch::StartsWith("8 samples, error up to "));

  const scene::OrbitCamera camera = viewer.state.camera;
  viewer.state.camera.theta += 40;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK(viewer.state.refinement.gathered == 0);
  viewer.state.camera = camera;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK((viewer.display().data == cheap.data));
  viewer.state.settings.quality.samples = 4;
  CHECK(view::drawViewport(viewer.viewport, viewer.state));
  CHECK((viewer.display().data == cheap.data));
  CHECK_FALSE(viewer.viewport.refinement.targets.sum);
}

TEST_CASE("refinement: the automatic visibility rests as facet render shows it", "[gl]") {
  Viewer viewer;
  viewer.load("builtin:poster");
  for (const int samples : {8, 20}) {  // as drawn, by paths
    INFO(samples);
    viewer.state.settings.quality.samples = samples;
    viewer.settle();
    viewer.converge();
    CHECK(viewer.viewport.shown.list.features.paths == (samples == 20));
    CHECK((viewer.display().data == renderedWhole("builtin:poster", viewer.state.settings).data));
  }
  viewer.state.settings.quality.samples = 24;
  viewer.state.settings.quality.maxError = 0.01;
  viewer.settle();
  viewer.converge();
  CHECK(viewer.viewport.shown.list.features.paths);
  CHECK((viewer.display().data == renderedWhole("builtin:poster", viewer.state.settings).data));
}

TEST_CASE("refinement: shadow maps and horizons follow rotation, camera, size, lights and pose", "[gl]") {
  Viewer viewer;
  frame::PictureSettings& settings = viewer.state.settings;
  settings.sources.environment = "builtin:sky";  // with a sun
  viewer.load("builtin:poster");
  const auto check = [&](const char* what) {
    viewer.settle();
    viewer.converge();
    INFO(what);
    CHECK(viewer.viewport.shown.list.features.shadows);
    frame::PictureSettings whole = settings;
    const scene::OrbitCamera& camera = viewer.state.camera;
    whole.viewpoint.orbit = frame::Orbit{camera.theta, camera.phi, camera.radius};
    whole.viewpoint.target = camera.target, whole.viewpoint.fovYDeg = camera.fovY;
    CHECK((viewer.display().data == renderedWhole("builtin:poster", whole).data));
  };
  check("as it comes");
  settings.frame.environmentRotationDeg = 120;
  check("rotation");
  viewer.state.camera.theta += 50;
  check("camera");
  settings.frame.width = 96, settings.frame.height = 40;
  check("size");
  settings.look.lights = frame::Lights::demo;
  check("lights");
  settings.frame.environmentRotationDeg = 30, settings.quality.samples = 6;
  check("rotation, refined");
}

TEST_CASE("refinement: what the cheap picture is off by is only stated where it outweighs what the gathered one is") {
  CHECK(view::cheapError(5, {3, 4}) == Approx(4));
  CHECK(view::cheapError(5, {0, 0}) == 5);
  CHECK(view::cheapError(5, {3.6, 4}) < 0);
  CHECK(view::cheapError(5, {6, 8}) < 0);
  CHECK(view::cheapError(0, {0, 0}) < 0);
  CHECK(view::cheapError(5, {}) < 0);
  view::RefinementStatus status{.wanted = 256, .gathered = 4};
  CHECK(view::refinementText(status) == "4 of 256 samples");
  status.error = 0.001;
  CHECK(view::refinementText(status) == "4 of 256 samples, error below 0.01/255");
  status.error = 0.25;
  CHECK(view::refinementText(status) == "4 of 256 samples, error about 0.25/255");
  status.softened = true;
  CHECK(view::refinementText(status) == "4 of 256 samples, error about 0.25/255, caustics softened");
}

TEST_CASE("refinement: every error that is stated on the way is near the true one", "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.visibility = frame::Visibility::none;
  viewer.load("builtin:marbles");
  viewer.state.settings.quality.samples = 512;
  const io::Pixels truth = renderedWhole("builtin:marbles", viewer.state.settings);
  viewer.state.settings.quality.samples = 32;
  view::drawViewport(viewer.viewport, viewer.state);
  int stated = 0;
  while (view::refining(viewer.viewport, viewer.state)) {
    view::drawViewport(viewer.viewport, viewer.state);
    glFinish();
    const view::RefinementStatus& r = viewer.state.refinement;
    if (r.error < 0) continue;
    ++stated;
    const double error = rmsDifference(viewer.display(), truth);
    INFO(r.gathered << " samples, " << r.shown << " shown, stated " << r.error << ", true " << error);
    CHECK(r.error > 0.5 * error);
    CHECK(r.error < 3 * error);
  }
  CHECK(stated > 0);
}

// The true error is that against 512 samples.
TEST_CASE("refinement: the error that is stated follows the true one", "[gl]") {
  Viewer viewer;
  viewer.state.settings.quality.visibility = frame::Visibility::none;
  viewer.load("builtin:poster");
  viewer.state.settings.quality.samples = 512;
  const io::Pixels truth = renderedWhole("builtin:poster", viewer.state.settings);
  for (const int samples : {8, 16, 64}) {
    viewer.state.settings.quality.samples = samples;
    viewer.converge();
    const double error = rmsDifference(viewer.display(), truth), estimate = viewer.state.refinement.error;
    INFO(samples << " samples, estimated " << estimate << ", true " << error);
    CHECK(estimate > 0.8 * error);
    CHECK(estimate < 1.8 * error);
  }
}
