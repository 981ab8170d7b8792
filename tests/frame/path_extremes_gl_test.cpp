#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>

#include "frame/path_scenes.hpp"
#include "support/picture.hpp"

// Scenes of extreme size, materials at the ends of their ranges, and geometry that is not as it should be, path traced.

using namespace facet;
using frame::PictureSettings;
using test::addBox, test::at, test::emptyScene, test::glowing, test::lambert, test::meanOf, test::tracedSettings;
using test::GltfBuilder;

namespace {

// A sphere above a plane, of that size.
io::LoadedModel sphereOverPlane(double size) {
  GltfBuilder builder = emptyScene();
  const int grey = builder.append("materials", test::material({0.7, 0.5, 0.3, 1}, 0, 0.5));
  const int sphere = test::addMeshNode(builder, test::addSphere(builder, 0.5, 24, 48), grey, at(0, 0, 0.5));
  const int plane = test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), grey);
  const nlohmann::json root = {{"scale", {size, size, size}}, {"children", {sphere, plane}}};
  builder.json["scenes"][0]["nodes"] = {builder.append("nodes", root)};
  return test::loadBuilt(builder);
}

double rootMeanSquare(const io::RadianceImage& a, const io::RadianceImage& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  double squares = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i)
    for (int c = 0; c < 3; ++c) squares += std::pow(double(a.pixels[i][c] - b.pixels[i][c]), 2);
  return std::sqrt(squares / double(3 * a.pixels.size()));
}

// White light from everywhere on what `build` adds, seen along -z over two metres.
frame::Picture furnace(test::Studio& studio, const std::function<void(GltfBuilder&, int material)>& build,
                       const std::function<void(scene::Material&)>& change, int samples = 64) {
  GltfBuilder builder = emptyScene();
  build(builder, builder.append("materials", test::material({1, 1, 1, 1}, 1, 0)));
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  change(model.model.materials[0]);
  return studio.render(model, tracedSettings(16, 16, samples));
}

void addGlassSphere(GltfBuilder& builder, int material) {
  test::addMeshNode(builder, test::addSphere(builder, 0.8, 48, 96), material);
}
void clearGlass(scene::Material& m) {
  m.metallicFactor = 0, m.perceptualRoughnessFactor = 0, m.transmissionFactor = 1, m.thicknessFactor = 1;
}

}  // namespace

TEST_CASE("Paths: a scene of a picometre and one of a hundred million kilometres look the same", "[gl]") {
  test::Studio studio;
  PictureSettings settings = tracedSettings(32, 32, 32, "builtin:studio");
  settings.viewpoint.camera.clear();
  settings.quality.bounces = 4;
  const frame::Picture usual = studio.render(sphereOverPlane(1), settings);
  const double mean = meanOf(usual.radiance).x;
  for (const double size : {1e-12, 1e-9, 1e-4, 1e4, 1e8, 5e10}) {
    const frame::Picture picture = studio.render(sphereOverPlane(size), settings);
    INFO("size " << size);
    CHECK(picture.statistics.visibility.method == "paths");
    CHECK(picture.statistics.nonFinitePixels == 0);
    CHECK(rootMeanSquare(usual.radiance, picture.radiance) < 0.02 * mean);
  }
  // Beyond that it is drawn, and said so.
  for (const double size : {1e-15, 1e14}) {
    const frame::Picture picture = studio.render(sphereOverPlane(size), settings);
    INFO("size " << size);
    CHECK(picture.statistics.visibility.method == "none");
    CHECK(picture.statistics.visibility.why == "rays do not reach in a scene of this size");
    CHECK(picture.statistics.frame.rays == 0);
    CHECK(std::ranges::count_if(studio.notes, [](const Note& note) {
            return note.text.find("light is not traced") != std::string::npos;
          }) == 1);
    CHECK(meanOf(picture.radiance).x > 0.5 * mean);
  }
}

TEST_CASE("Screen space: shadow maps and horizons of a picometre and of a hundred million kilometres are the same",
          "[gl]") {
  test::Studio studio;
  PictureSettings settings = test::bareSettings(48, 48);
  settings.sources.environment = "builtin:sky";  // with a sun
  const frame::Picture unblocked = studio.render(sphereOverPlane(1), settings);
  settings.quality.visibility = frame::Visibility::screen;
  const frame::Picture usual = studio.render(sphereOverPlane(1), settings);
  const double mean = meanOf(usual.radiance).x;
  CHECK(rootMeanSquare(usual.radiance, unblocked.radiance) > 0.1 * mean);
  for (const double size : {1e-12, 1e-9, 1e-4, 1e4, 1e8, 5e10}) {
    const frame::Picture picture = studio.render(sphereOverPlane(size), settings);
    INFO("size " << size);
    CHECK(picture.statistics.visibility.method == "screen");
    CHECK(picture.statistics.nonFinitePixels == 0);
    CHECK(rootMeanSquare(usual.radiance, picture.radiance) < 0.02 * mean);
  }
}

TEST_CASE("Paths: glass that absorbs nothing loses nothing, whatever its index, depth and roughness", "[gl]") {
  test::Studio studio;
  struct Row {
    float ior, thickness, distance, roughness;
  };
  const float infinite = std::numeric_limits<float>::infinity();
  for (const Row& row : {Row{1, 1, infinite, 0}, Row{1.0001f, 1, infinite, 0}, Row{0, 1, infinite, 0},
                         Row{4, 1, infinite, 0}, Row{1.5f, 1e-30f, infinite, 0}, Row{1.5f, 1e30f, infinite, 0},
                         Row{1.5f, 1, 1e-30f, 0}, Row{1.5f, 1, 1e30f, 0}, Row{1.5f, 0, infinite, 0}}) {
    const frame::Picture picture = furnace(studio, addGlassSphere, [&](scene::Material& m) {
      clearGlass(m);
      m.ior = row.ior, m.thicknessFactor = row.thickness;
      m.attenuationDistance = row.distance, m.perceptualRoughnessFactor = row.roughness;
    });
    const glm::dvec3 mean = meanOf(picture.radiance);
    INFO("ior " << row.ior << ", thickness " << row.thickness << ", distance " << row.distance << ": " << mean.x);
    CHECK(picture.statistics.nonFinitePixels == 0);
    for (int c = 0; c < 3; ++c) CHECK(mean[c] == Approx(1).margin(0.01));
  }
}

TEST_CASE("Paths: glass that absorbs all in no distance is black but for its interface", "[gl]") {
  test::Studio studio;
  const frame::Picture picture = furnace(
      studio,
      [](GltfBuilder& builder, int material) {
        test::addMeshNode(builder, addBox(builder, {2, 2, 0.5}, false), material);
      },
      [](scene::Material& m) { clearGlass(m), m.attenuationColor = glm::vec3(0.5f), m.attenuationDistance = 1e-30f; });
  for (int c = 0; c < 3; ++c) CHECK(meanOf(picture.radiance)[c] == Approx(0.04).margin(0.005));
}

TEST_CASE("Paths: eight glass spheres in one another, and a ball between two mirrors, keep all light", "[gl]") {
  test::Studio studio;
  const frame::Picture nested = furnace(
      studio,
      [](GltfBuilder& builder, int material) {
        for (const double radius : {0.8, 0.7, 0.6, 0.5, 0.4, 0.3, 0.2, 0.1})
          test::addMeshNode(builder, test::addSphere(builder, radius, 48, 96), material);
      },
      clearGlass);
  CHECK(nested.statistics.nonFinitePixels == 0);
  for (int c = 0; c < 3; ++c) CHECK(meanOf(nested.radiance)[c] == Approx(1).margin(0.01));
  const frame::Picture mirrors = furnace(
      studio,
      [](GltfBuilder& builder, int material) {
        for (const double x : {-0.5, 0.5})
          test::addMeshNode(builder, addBox(builder, {0.01, 1, 1}, false), material, at(x, 0, 0));
        test::addMeshNode(builder, test::addSphere(builder, 0.4, 48, 96), material);
      },
      [](scene::Material& m) { m.perceptualRoughnessFactor = 0; });
  CHECK(mirrors.statistics.nonFinitePixels == 0);
  for (int c = 0; c < 3; ++c) CHECK(meanOf(mirrors.radiance)[c] == Approx(1).margin(0.01));
}

TEST_CASE("Paths: walls that glow with 1e30 light a room with 1e30, those with 1e-30 with that", "[gl]") {
  test::Studio studio;
  for (const float glow : {1e30f, 1e-30f}) {
    GltfBuilder builder = emptyScene();
    test::addMeshNode(builder, addBox(builder, {1, 1, 1}, true),
                      builder.append("materials", test::material({1, 1, 1, 1})));
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.2}, {"znear", 0.01}}}});
    builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", {{"camera", 0}}));
    io::LoadedModel model = test::loadBuilt(builder);
    lambert(model.model.materials[0], 0.5f);
    model.model.materials[0].emissiveFactor = glm::vec3(1), model.model.materials[0].emissiveStrength = glow;
    studio.display = false;
    const frame::Picture picture = studio.render(model, tracedSettings(16, 16, 64, "none"));
    INFO("glow " << glow);
    CHECK(picture.statistics.nonFinitePixels == 0);
    CHECK(meanOf(picture.radiance).x == Approx(2 * double(glow)).epsilon(0.01));
  }
}

TEST_CASE("Paths: a lamp in a closed box lights its inside alone, one in a wall nothing that is not finite", "[gl]") {
  test::Studio studio;
  const auto render = [&](const glm::dvec3& place, bool inside) {
    GltfBuilder builder = emptyScene();
    const int white = builder.append("materials", test::material({1, 1, 1, 1}));
    test::addMeshNode(builder, addBox(builder, {0.5, 0.5, 0.5}, false), white);
    test::addMeshNode(builder, addBox(builder, {2, 2, 2}, true), white);
    builder.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 1.2}, {"znear", 0.01}}}});
    const double z = inside ? 0.4 : 1.9;
    builder.json["scenes"][0]["nodes"].push_back(builder.append("nodes", {{"camera", 0}, {"translation", {0, 0, z}}}));
    io::LoadedModel model = test::loadBuilt(builder);
    for (scene::Material& m : model.model.materials) lambert(m, 0.5f), m.doubleSided = true;
    test::addPointLight(model.model, 10, place);
    PictureSettings settings = tracedSettings(16, 16, 16, "none");
    settings.quality.bounces = 4;
    return studio.render(model, settings);
  };
  CHECK(meanOf(render({0, 0, 0}, false).radiance) == glm::dvec3(0));
  CHECK(meanOf(render({0, 0, 0}, true).radiance).x > 0.1);
  for (const glm::dvec3& place : {glm::dvec3(0, 0, 0.5), glm::dvec3(0.5), glm::dvec3(2, 0, 0), glm::dvec3(0, 0, 1.9)}) {
    const frame::Picture picture = render(place, false);
    INFO("lamp at " << place.x << " " << place.y << " " << place.z);
    CHECK(picture.statistics.nonFinitePixels == 0);
  }
}

TEST_CASE("Paths: triangles that lie in one another, that have no area or normals to the wrong side", "[gl]") {
  test::Studio studio;
  const auto quads = [&](int copies, bool flat) {
    GltfBuilder builder = emptyScene();
    const int white = builder.append("materials", test::material({1, 1, 1, 1}));
    for (int i = 0; i < copies; ++i) test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {1, 1}), white);
    if (flat) {  // a needle, a point, and one so small that its area is none
      const std::vector<float> corners = {0, 0, .1f, 1, 0, .1f, 1, 0, .1f, 0, 0, .1f, 0,      0, .1f, 0, 0,      .1f,
                                          0, 0, .1f, 0, 0, .1f, 0, 0, .1f, 0, 0, .1f, 1e-25f, 0, .1f, 0, 1e-25f, .1f};
      test::addMeshNode(builder, {{"attributes", {{"POSITION", builder.add(corners, test::floatType, "VEC3")}}}},
                        white);
    }
    test::addOrthographicCamera(builder, 1, 1);
    io::LoadedModel model = test::loadBuilt(builder);
    lambert(model.model.materials[0], 0.5f);
    return studio.render(model, tracedSettings(16, 16, 64, "builtin:studio"));
  };
  const frame::Picture one = quads(1, false), twice = quads(2, false), flat = quads(1, true);
  CHECK(twice.radiance.pixels == one.radiance.pixels);
  CHECK(rootMeanSquare(flat.radiance, one.radiance) < 0.01 * meanOf(one.radiance).x);
  // Normals to the inside of a sphere: dark, but nothing is brighter than what lights it.
  GltfBuilder builder = emptyScene();
  test::addMeshNode(builder, test::addSphere(builder, 0.8, 48, 96),
                    builder.append("materials", test::material({1, 1, 1, 1}, 1, 0.3)));
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel wrong = test::loadBuilt(builder);
  for (glm::vec3& normal : wrong.model.meshes[0].primitives[0].normals) normal = -normal;
  const frame::Picture picture = studio.render(wrong, tracedSettings(16, 16, 64));
  CHECK(picture.statistics.nonFinitePixels == 0);
  for (int c = 0; c < 3; ++c) CHECK(meanOf(picture.radiance)[c] <= 1.01);
}
