#include "optics/reference.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet;
using namespace facet::optics;

namespace {

template <class Function>
Environment makeMap(int width, int height, const Function& radiance) {
  Environment environment;
  environment.width = width;
  environment.height = height;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      environment.radiance.push_back(
          glm::vec3(radiance(directionFromEquirect(equirectTexelCentre(column, row, width, height)))));
  return environment;
}

Environment delta(int width, int height, int column, int row, float value) {
  Environment environment;
  environment.width = width;
  environment.height = height;
  environment.radiance.assign(size_t(width) * size_t(height), glm::vec3(0));
  environment.radiance[size_t(row) * size_t(width) + size_t(column)] = glm::vec3(value);
  return environment;
}

// Turns longitude by whole texels: column c of the map goes to column c + columns.
glm::dvec3 turned(const glm::dvec3& d, int columns, int width) {
  const double angle = 2 * pi * columns / width;
  return {d.x * std::cos(angle) - d.z * std::sin(angle), d.y, d.x * std::sin(angle) + d.z * std::cos(angle)};
}

const auto one = [](const glm::dvec3&) { return glm::dvec3(1); };

}  // namespace

TEST_CASE("radianceAt: texel centres, the wrap, the poles") {
  Environment map = delta(4, 2, 0, 0, 0);
  for (size_t i = 0; i < 8; ++i) map.radiance[i] = glm::vec3(float(i));
  for (int row = 0; row < 2; ++row)
    for (int column = 0; column < 4; ++column)
      CHECK(radianceAt(map, directionFromEquirect(equirectTexelCentre(column, row, 4, 2))).x ==
            Approx(row * 4 + column).margin(1e-12));
  CHECK(radianceAt(map, directionFromEquirect({0, 0.75})).x == Approx(1.5));  // between columns 3 and 0
  CHECK(radianceAt(map, directionFromEquirect({0.25, 0.5})).x == Approx(2.5));
  CHECK(radianceAt(map, {1e-9, 1, 1e-9}).x == Approx(2).margin(1e-6));  // u = 5/8 is the centre of column 2
}

TEST_CASE("References: a constant map stays constant, on any size of map") {
  const int sizes[][2] = {{1, 1}, {2, 1}, {25, 12}, {128, 64}};
  for (const auto& [width, height] : sizes) {
    const Environment map = makeMap(width, height, one);
    for (size_t i = 0; i < 3; ++i) {
      const glm::dvec3 n = goldenSpiral(i, 3);
      INFO(width << " x " << height << ", n " << n.x << ' ' << n.y << ' ' << n.z);
      const Reference e = irradiance(map, n);
      CHECK(e.value.y == Approx(pi).epsilon(1e-12));
      CHECK(e.weight == Approx(1).margin(1e-6));
      for (double alpha : {1e-6, 0.01, 0.2, 1.0})
        for (LobeWeight weight : {LobeWeight::NoL, LobeWeight::G2}) {
          const Reference ld = prefiltered(map, n, alpha, weight);
          INFO("alpha " << alpha << ", weight " << ld.weight - 1);
          CHECK(ld.value.y == Approx(1).epsilon(1e-12));
          CHECK(ld.weight == Approx(1).margin(1e-6));
        }
    }
  }
}

TEST_CASE("irradiance: closed forms") {
  const Environment slope = makeMap(256, 128, [](const glm::dvec3& d) { return glm::dvec3(1 + d.y, 1 + d.x, 1); });
  const Environment sky = makeMap(256, 128, [](const glm::dvec3& d) { return glm::dvec3(d.y > 0); });
  double worst = 0;
  for (size_t i = 0; i < 12; ++i) {
    const glm::dvec3 n = goldenSpiral(i, 12);
    const Reference a = irradiance(slope, n);
    worst = std::max(
        {worst, std::abs(a.value.x / (pi + 2 * pi / 3 * n.y) - 1), std::abs(a.value.y / (pi + 2 * pi / 3 * n.x) - 1)});
    // Half of the sphere: form factor (1 + cos) / 2. The edge is a ramp of one row.
    CHECK(irradiance(sky, n).value.x == Approx(pi * (1 + n.y) / 2).margin(1e-3));
  }
  INFO("worst " << worst);
  CHECK(worst < 2e-4);  // bilinear texels of 1.4 degrees flatten a cosine by delta^2 / 12 = 5e-5
}

TEST_CASE("prefiltered: rough is irradiance, a mirror is the map, a delta is the lobe") {
  const Environment map = makeMap(
      128, 64, [](const glm::dvec3& d) { return glm::dvec3(1 + d.x * d.y, std::exp(2 * d.z), 2 + std::sin(5 * d.x)); });
  for (size_t i = 0; i < 5; ++i) {
    const glm::dvec3 n = goldenSpiral(i, 5);
    const glm::dvec3 E = irradiance(map, n).value / pi;
    const glm::dvec3 rough = prefiltered(map, n, 1).value;
    CHECK(rough.x == Approx(E.x).epsilon(1e-5));
    CHECK(rough.y == Approx(E.y).epsilon(1e-5));
    const glm::dvec3 sharp = prefiltered(map, n, 1e-5).value, mirror = prefiltered(map, n, 0).value;
    CHECK(sharp.z == Approx(mirror.z).epsilon(1e-3));
    CHECK(mirror == radianceAt(map, n));
  }
  // One texel of solid angle w and radiance 1000 at angle t from n: 1000 w (D / 4) NoL / int (D / 4) NoL.
  const int width = 512, height = 256, column = 100, row = 128;
  const Environment sun = delta(width, height, column, row, 1000);
  const glm::dvec3 towards = directionFromEquirect(equirectTexelCentre(column, row, width, height));
  for (double alpha : {0.2, 0.6, 1.0})
    for (double angle : {0.0, 0.3, 1.0}) {
      const glm::dvec3 n = glm::normalize(towards * std::cos(angle) + glm::dvec3(0, 1, 0) * std::sin(angle));
      const double NoL = glm::dot(n, towards);
      const glm::dvec3 H = glm::normalize(n + towards);
      const double lobe = D_GGX(n, H, alpha) / 4 * NoL;
      // Closed form of int D / 4 NoL dL, partial fractions in tan^2; a = alpha^2.
      const double a = alpha * alpha;
      const double whole =
          alpha == 1 ? 0.25 : 2 * a / ((1 - a) * (1 - a)) * (std::log(2.0) - std::log((1 + a) / a)) + 1 / (1 - a);
      const double expected = 1000 * equirectTexelSolidAngle(row, width, height) * lobe / whole;
      CHECK(prefiltered(sun, n, alpha).value.x == Approx(expected).epsilon(3e-3));
    }
}

TEST_CASE("References: a sun on the wrap or in a pole row is like any other") {
  const int width = 64, height = 32;
  for (int row : {0, 15, 31}) {
    const Environment inside = delta(width, height, 20, row, 1e5f);
    const Environment edge = delta(width, height, 63, row, 1e5f);
    for (size_t i = 0; i < 4; ++i) {
      const glm::dvec3 n = goldenSpiral(i, 4);
      const glm::dvec3 m = turned(n, 43, width);
      CHECK(irradiance(edge, m).value.x == Approx(irradiance(inside, n).value.x).epsilon(1e-4).margin(1e-6));
      CHECK(prefiltered(edge, m, 0.3).value.x ==
            Approx(prefiltered(inside, n, 0.3).value.x).epsilon(1e-4).margin(1e-6));
    }
  }
}

TEST_CASE("specular: a constant map gives the DFG integral") {
  const Environment map = makeMap(64, 32, one);
  const glm::dvec3 N = glm::normalize(glm::dvec3(0.3, 0.5, -0.8));
  const glm::dvec3 T = glm::normalize(glm::cross(N, glm::dvec3(0, 1, 0)));
  for (double alpha : {1e-4, 0.01, 0.1, 0.4, 1.0})
    for (double NoV : {0.01, 0.05, 0.25, 0.7, 1.0}) {
      const glm::dvec3 V = N * NoV + T * std::sqrt(1 - NoV * NoV);
      const SpecularReference s = specular(map, N, V, alpha);
      const Dfg dfg = integrateDfg(NoV, alpha);
      INFO("alpha " << alpha << ", NoV " << NoV << ": " << s.dfg.A - dfg.A << ' ' << s.dfg.B - dfg.B);
      CHECK(s.dfg.A == Approx(dfg.A).margin(1e-6));
      CHECK(s.dfg.B == Approx(dfg.B).margin(1e-6));
      CHECK(s.a.x == Approx(s.dfg.A).epsilon(1e-12));
    }
}

TEST_CASE("specular: agrees with sampling of visible normals on a map with structure") {
  const Environment map = makeMap(
      128, 64, [](const glm::dvec3& d) { return glm::dvec3(1 + d.x * d.y, std::exp(2 * d.z), 2 + std::sin(5 * d.x)); });
  const glm::dvec3 N(0, 0, 1);
  for (double alpha : {0.05, 0.5})
    for (double NoV : {0.2, 0.8}) {
      const glm::dvec3 V(std::sqrt(1 - NoV * NoV), 0, NoV);
      constexpr uint32_t count = 1 << 16;
      glm::dvec3 sampled(0);
      for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3 H = sampleVisibleGGX(V, alpha, hammersley(i, count));
        const glm::dvec3 L = glm::reflect(-V, H);
        if (L.z <= 0) continue;
        const double weight = G2_GGX(NoV, L.z, alpha) / G1_GGX(NoV, alpha) * F_Schlick(glm::dot(V, H), 0.04, 1);
        sampled += radianceAt(map, L) * (weight / count);
      }
      const SpecularReference s = specular(map, N, V, alpha);
      const glm::dvec3 value = 0.04 * s.a + s.b;
      INFO("alpha " << alpha << ", NoV " << NoV);
      for (int k = 0; k < 3; ++k) CHECK(value[k] == Approx(sampled[k]).epsilon(1e-3));
    }
  // Mirror: the limit of narrow lobes.
  const glm::dvec3 V(0.6, 0, 0.8);
  const SpecularReference mirror = specular(map, N, V, 0), narrow = specular(map, N, V, 1e-5);
  CHECK(narrow.a.z == Approx(mirror.a.z).epsilon(1e-3));
  CHECK(mirror.a.z == Approx(radianceAt(map, {-0.6, 0, 0.8}).z * (1 - std::pow(0.2, 5))).epsilon(1e-12));
}
