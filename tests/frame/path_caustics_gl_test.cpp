#include <catch2/catch.hpp>
#include <cmath>

#include "frame/path_scenes.hpp"
#include "support/picture.hpp"

// Light that a diffuse surface sees by way of a mirror: as it goes, or softened.

using namespace facet;
using frame::Caustics, frame::PictureSettings;
using test::addMeshNode, test::addQuad, test::at, test::emptyScene, test::GltfBuilder;

namespace {

// A chrome ball on a floor in z = 0 that is white, or a mirror, too; under a small lamp.
io::LoadedModel ballOnFloor(bool white) {
  GltfBuilder builder = emptyScene();
  test::addOrthographicCamera(builder, 2, 2);
  const int floor = builder.append("materials", test::material({1, 1, 1, 1}, white ? 0 : 1, white ? 1 : 0));
  const int chrome = builder.append("materials", test::material({0.9, 0.9, 0.9, 1}, 1, 0));
  const int lamp = builder.append("materials", test::glowing({100, 100, 100, 1}));
  addMeshNode(builder, addQuad(builder, {-2, -2}, {2, 2}), floor);
  addMeshNode(builder, test::addSphere(builder, 0.6), chrome, at(0, 0, 0.6));
  nlohmann::json down = at(2.5, 0, 2);
  down["rotation"] = {0, 1, 0, 0};  // it shines towards -Z
  addMeshNode(builder, addQuad(builder, {-0.15f, -0.15f}, {0.15f, 0.15f}), lamp, down);
  return test::loadBuilt(builder);
}

PictureSettings settingsOf(Caustics caustics, int seed, int samples) {
  PictureSettings settings = test::tracedSettings(24, 24, samples, "none");
  settings.quality.caustics = caustics, settings.quality.seed = seed;
  settings.quality.bounces = 4;
  return settings;
}

// RMS of the difference of two pictures of other random numbers.
double noise(test::Studio& studio, const io::LoadedModel& model, Caustics caustics) {
  const frame::Picture a = studio.render(model, settingsOf(caustics, 1, 16)),
                       b = studio.render(model, settingsOf(caustics, 2, 16));
  double sum = 0;
  for (size_t i = 0; i < a.radiance.pixels.size(); ++i) {
    const double d = double(a.radiance.pixels[i].x) - double(b.radiance.pixels[i].x);
    sum += d * d;
  }
  return std::sqrt(sum / double(a.radiance.pixels.size()));
}

double meanRadiance(const frame::Picture& picture) { return test::meanOf(picture.radiance).x; }

}  // namespace

TEST_CASE("Caustics: softened ones have less noise, keep their light and are told", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = ballOnFloor(true);
  const double all = noise(studio, model, Caustics::all), soft = noise(studio, model, Caustics::soft);
  INFO("noise " << all << ", softened " << soft);
  CHECK(soft < 0.6 * all);
  const frame::Picture right = studio.render(model, settingsOf(Caustics::all, 3, 256)),
                       softened = studio.render(model, settingsOf(Caustics::soft, 3, 256));
  CHECK(meanRadiance(softened) == Approx(meanRadiance(right)).epsilon(0.05));
  CHECK(right.statistics.visibility.why == "asked for");
  CHECK(softened.statistics.visibility.why == "asked for; caustics are softened");
}

TEST_CASE("Caustics: those of coats and of brushed metals are softened, too", "[gl]") {
  test::Studio studio;
  for (const bool coat : {true, false}) {
    io::LoadedModel model = ballOnFloor(true);
    scene::Material& ball = model.model.materials[1];
    if (coat) {
      ball.baseColorFactor = glm::vec4(0, 0, 0, 1), ball.metallicFactor = 0, ball.perceptualRoughnessFactor = 1;
      ball.clearcoatFactor = 1;
    } else {
      ball.perceptualRoughnessFactor = 0.2f, ball.anisotropyStrength = 0.9f;
      scene::Primitive& p = model.model.meshes[1].primitives[0];
      for (const glm::vec3& n : p.normals) {
        const glm::vec3 along = glm::cross(glm::vec3(0, 0, 1), n);
        p.tangents.emplace_back(glm::length(along) > 0 ? glm::normalize(along) : glm::vec3(1, 0, 0), 1);
      }
    }
    const double all = noise(studio, model, Caustics::all), soft = noise(studio, model, Caustics::soft);
    INFO((coat ? "coat" : "grain") << ": noise " << all << ", softened " << soft);
    CHECK(soft < 0.95 * all);
  }
}

TEST_CASE("Caustics: where no surface is diffuse, nothing is softened", "[gl]") {
  test::Studio studio;
  const io::LoadedModel model = ballOnFloor(false);
  const frame::Picture right = studio.render(model, settingsOf(Caustics::all, 1, 8)),
                       softened = studio.render(model, settingsOf(Caustics::soft, 1, 8));
  CHECK(right.radiance.pixels == softened.radiance.pixels);
  CHECK(meanRadiance(right) > 0);
}
