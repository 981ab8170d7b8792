#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "optics/mapping.hpp"
#include "optics/zonal.hpp"
#include "scene/builtin_environments.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using nlohmann::json;

namespace {

PictureSettings skySettings(const std::string& environment, float blur, int size = 12) {
  PictureSettings settings = test::bareSettings(size, size);
  settings.sources.environment = environment;
  settings.frame.background = frame::Background::environment;
  settings.frame.backgroundBlur = blur;
  settings.viewpoint.orbit = frame::Orbit{0, 90, 20.0};
  settings.viewpoint.target = glm::dvec3(0);
  return settings;
}

glm::dvec3 texelOf(const scene::Environment& map, int x, int y) {
  const auto row = static_cast<size_t>(std::clamp(y, 0, map.height - 1));
  return map.radiance[row * static_cast<size_t>(map.width) + static_cast<size_t>((x + map.width) % map.width)];
}

// What the lobe sees of the map as bilinear look-ups read it: by points in the middle of texels, and many in each of
// those about the lobe's centre.
glm::dvec3 blurred(const scene::Environment& map, const glm::dvec3& direction, double blur) {
  glm::dvec3 sum(0);
  double total = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const glm::dvec3 middle = optics::directionFromEquirect(optics::equirectTexelCentre(x, y, map.width, map.height));
      const int points = glm::length(middle - direction) < 30 * blur * blur && blur < 0.1 ? 16 : 1;
      for (int i = 0; i < points * points; ++i) {
        // From the texel's middle, in texels; y down.
        const double u = (i % points + 0.5) / points - 0.5, v = (i / points + 0.5) / points - 0.5;
        const glm::dvec3 d = optics::directionFromEquirect({(x + 0.5 + u) / map.width, 1 - (y + 0.5 + v) / map.height});
        const double area = 2 * pi * pi / map.width / map.height * std::sqrt(d.x * d.x + d.z * d.z) / points / points;
        const double angle = 2 * std::asin(std::min(1.0, glm::length(d - direction) / 2));
        const double weight = area * optics::prefilterKernel(blur * blur, angle);
        const int left = u < 0 ? x - 1 : x, upper = v < 0 ? y - 1 : y;
        const double right = u < 0 ? u + 1 : u, down = v < 0 ? v + 1 : v;
        const glm::dvec3 radiance =
            points == 1
                ? texelOf(map, x, y)
                : glm::mix(glm::mix(texelOf(map, left, upper), texelOf(map, left + 1, upper), right),
                           glm::mix(texelOf(map, left, upper + 1), texelOf(map, left + 1, upper + 1), right), down);
        sum += weight * radiance, total += weight;
      }
    }
  CHECK(total == Approx(1).epsilon(0.02));
  return sum;
}

// Towards the middle of a pixel, of an orbit that looks along -Z rotated by theta and phi.
glm::dvec3 pixelDirection(const PictureSettings& s, int x, int y) {
  const double theta = s.viewpoint.orbit->thetaDeg * pi / 180, phi = s.viewpoint.orbit->phiDeg * pi / 180;
  const glm::dvec3 forward(-std::sin(phi) * std::sin(theta), -std::cos(phi), -std::sin(phi) * std::cos(theta));
  const glm::dvec3 right(std::cos(theta), 0, -std::sin(theta)), up = glm::cross(right, forward);
  const double tangent = std::tan(*s.viewpoint.fovYDeg * pi / 360);
  const double u = ((x + 0.5) / s.frame.width * 2 - 1) * tangent, v = (1 - (y + 0.5) / s.frame.height * 2) * tangent;
  return glm::normalize(forward + u * right + v * up);
}

}  // namespace

TEST_CASE("A blurred background is the map under the lobe, its sun too, at any blur", "[gl]") {
  test::Studio studio;
  studio.display = false;
  const io::LoadedModel model = test::loadBuilt(test::emptyScene());
  for (const char* name : {"builtin:studio", "builtin:sky"}) {
    const scene::Environment map = *scene::builtinEnvironment(name);
    for (const float blur : {0.03f, 0.08f, 0.13f, 0.35f, 0.75f}) {
      double squares = 0, reference = 0, worst = 0;
      for (const double theta : {0.0, 120.0, 240.0}) {
        PictureSettings settings = skySettings(name, blur, 2);
        settings.viewpoint.orbit = frame::Orbit{theta, 130, 20.0};  // up, where the lamps are
        settings.viewpoint.fovYDeg = 100;
        const frame::Picture picture = studio.render(model, settings);
        for (int y = 0; y < 2; ++y)
          for (int x = 0; x < 2; ++x) {
            const glm::dvec3 expected = blurred(map, pixelDirection(settings, x, y), double{blur});
            const glm::dvec3 got(test::pixel(picture.radiance, x, y));
            squares += glm::dot(got - expected, got - expected), reference += glm::dot(expected, expected);
            worst = std::max(worst, glm::length(got - expected) / glm::length(expected));
          }
      }
      const double error = std::sqrt(squares / reference);
      std::printf("background blurred by %.2f, %s: RMSE %.2f %%, worst pixel %.2f %%\n", double{blur}, name,
                  100 * error, 100 * worst);
      INFO(name << " blurred by " << blur);
      CHECK(error < 0.01);
    }
  }
}

TEST_CASE("A blurred background: the same drawn, converged and path traced, also through glass, and light stays",
          "[gl]") {
  test::GltfBuilder builder = test::emptyScene();
  json pane = test::material({1, 1, 1, 1}, 0, 0);
  pane["extensions"] = {{"KHR_materials_transmission", {{"transmissionFactor", 1}}},
                        {"KHR_materials_ior", {{"ior", 1}}}};
  const int glass = builder.append("materials", pane),
            metal = builder.append("materials", test::material({1, 1, 1, 1}, 1, 0.1));
  test::addMeshNode(builder, test::addQuad(builder, {-1, -1}, {0, 1}), glass);
  test::addMeshNode(builder, test::addQuad(builder, {0, -1}, {1, 0}), metal);
  const io::LoadedModel model = test::loadBuilt(builder);
  test::Studio studio;
  studio.display = false;
  PictureSettings settings = skySettings("builtin:sky", 0.3f, 8);
  settings.viewpoint.orbit = frame::Orbit{0, 90, 2.2};
  const auto at = [](const frame::Picture& picture, int x, int y) {
    return glm::vec3(test::pixel(picture.radiance, x, y));
  };
  const frame::Picture drawn = studio.render(model, settings);
  settings.quality.samples = 8;
  const frame::Picture converged = studio.render(model, settings);
  settings.quality.transport = frame::Transport::paths;
  settings.quality.samples = 64;
  const frame::Picture traced = studio.render(model, settings);
  settings.frame.backgroundBlur = 0;
  const frame::Picture sharp = studio.render(model, settings);
  for (const int y : {2, 5}) {
    const glm::vec3 pane1 = at(drawn, 2, y);
    CHECK(glm::length(at(converged, 2, y) - pane1) < 0.02f * glm::length(pane1));
    CHECK(glm::length(at(traced, 2, y) - pane1) < 0.02f * glm::length(pane1));
  }
  CHECK(glm::length(at(traced, 5, 2) - at(drawn, 5, 2)) < 0.01f * glm::length(at(drawn, 5, 2)));  // the sky itself
  CHECK(glm::length(at(sharp, 5, 2) - at(traced, 5, 2)) > 0.03f * glm::length(at(sharp, 5, 2)));
  CHECK(at(sharp, 5, 5) == at(traced, 5, 5));  // what the metal mirrors
}

TEST_CASE("Frugality: a blur makes one table, and where the environment is not seen none", "[gl]") {
  const io::LoadedModel model = test::loadBuilt(test::emptyScene());
  test::Studio studio;
  const auto names = [&](const PictureSettings& settings) {
    std::vector<std::string> names;
    const frame::Picture picture = studio.render(model, settings);
    for (const ibl::TableStatistics& table : picture.statistics.tables) names.push_back(table.name);
    return names;
  };
  using Names = std::vector<std::string>;
  PictureSettings settings = skySettings("builtin:studio", 0.4f);
  settings.frame.background = frame::Background::transparent;
  CHECK(names(settings).empty());
  settings.frame.background = frame::Background::environment;
  CHECK(names(settings) == Names{"environment cube", "blurred background"});
  settings.frame.environmentRotationDeg = 30;
  CHECK(names(settings).empty());
  settings.frame.backgroundBlur = 0.5f;
  CHECK(names(settings) == Names{"environment cube", "blurred background"});
  settings.frame.backgroundBlur = 0;
  CHECK(names(settings) == Names{"background"});
}
