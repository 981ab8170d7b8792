#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>

#include "report/visibility.hpp"
#include "support/picture.hpp"

using namespace facet;
using report::VisibilityMeasure, report::VisibilityRow;
using test::GltfBuilder;

namespace {

VisibilityMeasure measured(const io::LoadedModel& model, const char* environment,
                           const report::VisibilityOptions& options) {
  test::Studio studio;
  frame::LoadedScene scene = test::sceneOf(model);
  frame::PictureSettings settings = test::bareSettings(24, 24);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  const auto made = report::measureVisibility(settings, options, [&](const frame::PictureSettings& wanted, int) {
    return Result<frame::Picture>(studio.render(scene, wanted));
  });
  REQUIRE(made);
  return *made;
}

std::string figures(const VisibilityMeasure& m) {
  std::ostringstream out;
  const auto add = [&](const report::VisibilityError& e) {
    out << e.rms << ", FLIP " << e.flip << ", bias " << e.bias;
  };
  for (const VisibilityRow& row : m.rows) {
    out << row.name << " x " << row.samples << ": ";
    add(row.error);
    out << ", rays " << row.raysPerPixel << "\n";
  }
  out << "floor: ";
  add(m.floor);
  return out.str();
}

void placeSphere(GltfBuilder& builder, double radius, int material, const glm::vec3& at) {
  test::addMeshNode(builder, test::addSphere(builder, radius, 48, 96), material, test::at(at.x, at.y, at.z));
}

// Three on a white plane, which return most of what they get.
io::LoadedModel whiteSpheres() {
  GltfBuilder builder = test::emptyScene();
  const int white = builder.append("materials", test::material({0.9, 0.9, 0.9, 1}, 0, 1));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), white);
  for (const glm::vec2 at : {glm::vec2(-0.25, -0.2), glm::vec2(0.25, -0.2), glm::vec2(0, 0.25)})
    placeSphere(builder, 0.24, white, {at, 0.24});
  test::addOrthographicCamera(builder, 0.5, 0.5);
  return test::loadBuilt(builder);
}

}  // namespace

TEST_CASE("visibility: on one convex body nothing is missed, whatever the method", "[gl]") {
  GltfBuilder builder = test::emptyScene();
  placeSphere(builder, 0.5, builder.append("materials", test::material({0.6, 0.5, 0.4, 1}, 0, 0.5)), {});
  test::addOrthographicCamera(builder, 0.3, 0.3);
  const VisibilityMeasure m = measured(test::loadBuilt(builder), "builtin:studio",
                                       {.samples = 256, .bounces = {1}, .raySamples = {}, .fewSamples = {4}});
  INFO(figures(m));
  REQUIRE(m.rows.size() == 5);
  const VisibilityRow &none = m.rows[1], &once = m.rows[2], &few = m.rows[3];
  CHECK(none.samples == 256);
  CHECK(m.withinFloor(none));
  CHECK(std::abs(none.error.bias) < 0.005);
  CHECK(once.error.rms < 0.05 * m.floor.rms);  // the same paths: there is nothing to go on to
  CHECK(m.withinFloor(once));
  CHECK_FALSE(m.withinFloor(few));
  CHECK(once.raysPerPixel == Approx(m.rows[4].raysPerPixel).epsilon(0.01));
  CHECK(once.raysPerPixel > 2 * 256);  // the camera's, one of the lobe, one to a light that can light it
  CHECK(once.raysPerPixel <= 3 * 256);
}

TEST_CASE("visibility: more bounces come nearer, more samples come nearer, and what cannot be told apart is said",
          "[gl]") {
  const VisibilityMeasure m = measured(
      whiteSpheres(), "builtin:white",
      {.samples = 128, .bounces = {1, 2, 8}, .raySamples = {}, .fewSamples = {4, 16, 64}, .occlusionTextures = true});
  INFO(figures(m));
  REQUIRE(m.rows.size() == 10);
  const auto rms = [&](size_t row) { return m.rows[row].error.rms; };
  // None, occlusion textures (there are none: the same), one bounce, two, eight.
  CHECK(rms(2) == rms(1));
  CHECK(rms(1) > 3 * m.floor.rms);
  CHECK(m.rows[1].error.bias > 0.04);
  CHECK(rms(4) < 0.7 * rms(3));
  CHECK(rms(5) < 0.2 * rms(4));
  CHECK(m.withinFloor(m.rows[5]));
  CHECK_FALSE(m.withinFloor(m.rows[3]));
  CHECK(m.rows[3].error.bias < m.rows[4].error.bias);
  CHECK(m.rows[4].error.bias < 0);
  CHECK(std::abs(m.rows[5].error.bias) < 0.01);
  // 4, 16 and 64 samples, and the reference: noise alone. Of half the reference's samples the others are the judge.
  CHECK(rms(7) < 0.62 * rms(6));
  CHECK(rms(8) < 0.8 * rms(7));  // its judge is as noisy as itself, not of the same noise
  CHECK(rms(8) > 0.45 * rms(7));
  CHECK(rms(8) == Approx(std::sqrt(2) * m.floor.rms));
  CHECK(rms(9) == Approx(m.floor.rms / std::sqrt(2)));
  CHECK(m.rows[1].raysPerPixel == 0);
  CHECK(m.rows[3].raysPerPixel < m.rows[4].raysPerPixel);
  CHECK(m.rows[6].raysPerPixel == Approx(m.rows[9].raysPerPixel / 32).epsilon(0.05));
  CHECK(m.traced.triangles > 10000);
}

TEST_CASE("visibility: rays beside a drawn picture are nearer than none, and nearer with more samples", "[gl]") {
  const VisibilityMeasure m = measured(whiteSpheres(), "builtin:white",
                                       {.samples = 128, .bounces = {}, .raySamples = {4, 16}, .fewSamples = {}});
  INFO(figures(m));
  REQUIRE(m.rows.size() == 6);
  const VisibilityRow &none = m.rows[0], &screen = m.rows[2], &few = m.rows[3], &more = m.rows[4];
  CHECK(screen.name == "screen");
  CHECK(screen.raysPerPixel == 0);
  CHECK(screen.error.rms < none.error.rms);
  CHECK(std::abs(screen.error.bias) < std::abs(none.error.bias));
  CHECK(few.error.rms < 0.75 * none.error.rms);
  CHECK(more.error.rms < 0.7 * few.error.rms);
  CHECK(std::abs(few.error.bias) < 0.25 * std::abs(none.error.bias));
  CHECK(more.raysPerPixel == Approx(4 * few.raysPerPixel).epsilon(0.05));
}

TEST_CASE("visibility: what only covers is no error, and a black model is told", "[gl]") {
  GltfBuilder builder = test::emptyScene();
  placeSphere(builder, 0.5, builder.append("materials", test::unlit({0.02, 0.02, 0.02, 1})), {});
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  const report::VisibilityOptions options{.samples = 64, .bounces = {1}, .raySamples = {}, .fewSamples = {4}};
  const VisibilityMeasure m = measured(model, "builtin:studio", options);
  INFO(figures(m));
  const auto relative = [&](size_t row) { return m.rows[row].error.rms / m.rows[0].error.rms; };
  CHECK(m.rows[0].error.rms < 2);  // a dark body's edge over black
  CHECK(relative(1) < 0.5);
  CHECK(m.rows[2].error.rms == 0);
  model.model.materials[0].baseColorFactor = {0, 0, 0, 1};
  test::Studio studio;
  frame::PictureSettings settings = test::bareSettings(24, 24);
  settings.viewpoint.camera = "0";
  const auto made = report::measureVisibility(settings, options, [&](const frame::PictureSettings& wanted, int) {
    return Result<frame::Picture>(studio.render(model, wanted));
  });
  REQUIRE_FALSE(made);
  CHECK(made.error().problem.find("black") != std::string::npos);
}

TEST_CASE("visibility: paths of few samples are the first of many", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = test::loadBuiltin("builtin:spheres");
  frame::PictureSettings settings = test::bareSettings(24, 24);
  settings.sources.environment = "builtin:studio";
  settings.quality.transport = frame::Transport::paths;
  const auto render = [&](int samples) {
    settings.quality.samples = samples;
    return studio.render(model, settings).radiance;
  };
  const io::RadianceImage some = render(2), more = render(3);
  // What the third one adds is light and coverage, nowhere less than none.
  float least = 0, most = 0;
  for (size_t i = 0; i < more.pixels.size(); ++i) {
    const glm::vec4 third = 3.0f * more.pixels[i] - 2.0f * some.pixels[i], scale = glm::max(more.pixels[i], 1.0f);
    for (int c = 0; c < 4; ++c) least = std::min(least, third[c] / scale[c]);
    most = std::max(most, third.a);
  }
  CHECK(least > -1e-5f);
  CHECK(most == Approx(1));
}
