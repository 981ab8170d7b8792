#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>

#include "optics/reference.hpp"
#include "scene/builtin_environments.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using test::GltfBuilder;

namespace {

constexpr int cell = 32;

// One sphere seen from +Z, tangents along the longitudes' circles about +Y.
io::LoadedModel sphere(const scene::Material& material) {
  GltfBuilder builder = test::emptyScene();
  test::addMeshNode(builder, test::addSphere(builder, 1, 64, 128),
                    builder.append("materials", test::material({1, 1, 1, 1}, 1, 1)));
  test::addOrthographicCamera(builder, 1, 1);
  io::LoadedModel model = test::loadBuilt(builder);
  model.model.materials[0] = material;
  scene::Primitive& primitive = model.model.meshes[0].primitives[0];
  primitive.tangents.clear();
  for (const glm::vec3& n : primitive.normals)
    primitive.tangents.emplace_back(std::hypot(n.x, n.z) > 0 ? glm::normalize(glm::vec3(n.z, 0, -n.x)) : n, 1.0f);
  return model;
}

// Mean radiance under the lobe at N, in the view along -Z, from a picture of it and of its furnace, against truth.
struct Compared {
  double rms = 0;
  int count = 0;
  void add(double got, double expected) { rms += (got / expected - 1) * (got / expected - 1), ++count; }
  double value() const { return std::sqrt(rms / count); }
};

template <class F>
void eachPixel(const F& f) {
  for (int y = 3; y < cell; y += 8)
    for (int x = 3; x < cell; x += 8) {
      const double u = (x + 0.5) / cell * 2 - 1, v = 1 - (y + 0.5) / cell * 2, r2 = u * u + v * v;
      if (r2 < 0.95) f(x, y, glm::dvec3(u, v, std::sqrt(1 - r2)));
    }
}

PictureSettings pictureSettings(const char* environment) {
  PictureSettings settings = test::bareSettings(cell, cell);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  return settings;
}

}  // namespace

TEST_CASE("Grain: the environment under the long lobe, against the integral and against a bent normal") {
  test::Studio studio;
  const auto environment = scene::builtinEnvironment("studio");
  REQUIRE(environment);
  const glm::dvec3 V(0, 0, 1);
  std::printf("grain, rRMSE under builtin:studio: roughness strength, taps, bent normal\n");
  for (const double r : {0.2, 0.4, 0.6})
    for (const double strength : {0.4, 0.8}) {
      scene::Material material;
      material.metallicFactor = 1;
      material.perceptualRoughnessFactor = float(r);
      const optics::AnisotropicAlpha alpha = optics::alphaFromAnisotropy(r * r, strength);
      // The bent normal of the extension's sample code, one look-up, exact LD.
      material.anisotropyStrength = float(strength);
      const io::LoadedModel model = sphere(material);
      const frame::Picture lit = studio.render(model, pictureSettings("builtin:studio"));
      const frame::Picture white = studio.render(model, pictureSettings("builtin:white"));
      Compared taps, bent;
      eachPixel([&](int x, int y, const glm::dvec3& N) {
        const glm::dvec3 T = glm::normalize(glm::dvec3(N.z, 0, -N.x)), B = glm::cross(N, T);
        const double truth = optics::anisotropic(*environment, N, T, V, alpha).value.y;
        const optics::Dfg dfg = optics::integrateDfgAnisotropic({glm::dot(T, V), glm::dot(B, V), N.z}, alpha);
        const double E = dfg.A + dfg.B, diffuse = optics::irradiance(*environment, N).value.y / optics::pi;
        const double radiance = double(test::pixel(lit.radiance, x, y).y);
        taps.add((radiance - (1 - E) * diffuse) / E, truth);
        const glm::dvec3 bentTo = glm::normalize(glm::cross(glm::cross(B, V), B));
        const double factor = std::pow(1 - strength * (1 - r), 4);
        const glm::dvec3 n = glm::normalize(glm::mix(bentTo, N, factor));
        bent.add(optics::prefiltered(*environment, glm::reflect(-V, n), r * r).value.y, truth);
        CHECK(test::pixel(white.radiance, x, y).y == Approx(1).margin(1e-3));
      });
      std::printf("  %.1f %.1f  %.3f  %.3f\n", r, strength, taps.value(), bent.value());
      CHECK(taps.value() < 0.5);
      CHECK(taps.value() < bent.value());
    }
}

TEST_CASE("Sheen: the environment under the lobe, against the integral and against irradiance") {
  test::Studio studio;
  const auto environment = scene::builtinEnvironment("studio");
  REQUIRE(environment);
  const glm::dvec3 V(0, 0, 1);
  std::printf("sheen, rRMSE under builtin:studio: sheen roughness, quadrature, irradiance\n");
  for (const double r : {0.3, 0.5, 0.8, 1.0}) {
    scene::Material material;
    material.baseColorFactor = {0, 0, 0, 1};
    material.metallicFactor = 0;
    material.specularWeight = 0;
    material.sheenColorFactor = glm::vec3(1);
    material.sheenRoughnessFactor = float(r);
    const io::LoadedModel model = sphere(material);
    const frame::Picture lit = studio.render(model, pictureSettings("builtin:studio"));
    const frame::Picture white = studio.render(model, pictureSettings("builtin:white"));
    Compared quadrature, irradiance;
    eachPixel([&](int x, int y, const glm::dvec3& N) {
      const optics::Reference truth = optics::sheen(*environment, N, V, r * r);
      const double albedo = double(test::pixel(white.radiance, x, y).y);
      CHECK(albedo == Approx(truth.weight).margin(2e-3));
      quadrature.add(double(test::pixel(lit.radiance, x, y).y) / albedo, truth.value.y);
      irradiance.add(optics::irradiance(*environment, N).value.y / optics::pi, truth.value.y);
    });
    std::printf("  %.1f  %.3f  %.3f\n", r, quadrature.value(), irradiance.value());
    CHECK(quadrature.value() < 0.75);
    CHECK(quadrature.value() < irradiance.value());
  }
}
