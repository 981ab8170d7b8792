#include "optics/bsdf.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

namespace {

const glm::dvec3 N(0, 0, 1);

// What the surface returns of uniform unit radiance, integrated over light directions.
glm::dvec2 furnace(const Surface& surface, double NoV) {
  const glm::dvec3 V(std::sqrt(1 - NoV * NoV), 0, NoV);
  const Dfg dfg = dfgOf(surface, NoV);
  const double mirror = std::acos(NoV);
  const auto overRing = [&](double theta) {
    const auto onRing = [&](double phi) {
      const double s = std::sin(theta);
      const Reflected r = reflect(surface, dfg, N, V, {s * std::cos(phi), s * std::sin(phi), std::cos(theta)});
      return glm::dvec2(r.specular.x, r.diffuse.x);
    };
    return 2 * std::sin(theta) *
           (integrateAdaptive<glm::dvec2>(onRing, 0, pi * 0.9, 1e-7, 20) +
            integrateAdaptive<glm::dvec2>(onRing, pi * 0.9, pi, 1e-7, 20));
  };
  return integrateAdaptive<glm::dvec2>(overRing, 0, mirror, 1e-6, 20) +
         integrateAdaptive<glm::dvec2>(overRing, mirror, pi / 2, 1e-6, 20);
}

}  // namespace

TEST_CASE("BSDF: white furnace") {
  for (double metallic : {0.0, 1.0})
    for (double r : {0.2, 0.4, 0.7, 1.0})
      for (double NoV : {0.1, 0.5, 1.0}) {
        const Surface white{glm::dvec3(1), metallic, r};
        const glm::dvec2 total = furnace(white, NoV);
        INFO("metallic " << metallic << ", r " << r << ", NoV " << NoV);
        CHECK(total.x + total.y == Approx(1).margin(2e-5));
        if (metallic == 1) CHECK(total.y == 0);
      }
  // In between nothing is gained.
  const glm::dvec2 half = furnace({glm::dvec3(1), 0.5, 0.5}, 0.5);
  CHECK(half.x + half.y < 1);
  CHECK(half.x + half.y > 0.7);
}

TEST_CASE("BSDF: parameters") {
  const Surface surface{{0.8, 0.5, 0.1}, 0.25, 0.6};
  CHECK(alphaOf(surface) == Approx(0.36));
  CHECK(f0Of(surface).x == Approx(0.03 + 0.2));
  CHECK(diffuseColorOf(surface).y == Approx(0.375));
  // By hand: rough black dielectric along the normal: D V F NoL = 1/pi * 1/4 * 0.04, times 1 + 0.04 (1 / E - 1).
  const Surface black{glm::dvec3(0), 0, 1};
  const double E = 1 - std::log(2.0);
  const Reflected r = reflect(black, dfgOf(black, 1), N, N, N);
  CHECK(r.specular.x == Approx(0.01 / pi * (1 + 0.04 * (1 / E - 1))).epsilon(1e-7));
  CHECK(r.diffuse.x == 0);
  // White: what the lobe leaves goes to Lambert.
  const Surface white{glm::dvec3(1), 0, 1};
  const double specularAlbedo = specularAlbedoTurquin(dfgOf(white, 1), glm::dvec3(0.04)).x;
  CHECK(reflect(white, dfgOf(white, 1), N, N, N).diffuse.x == Approx((1 - specularAlbedo) / pi).epsilon(1e-12));
  CHECK(specularAlbedo > 0.01);
  CHECK(specularAlbedo < 0.04);
}

TEST_CASE("BSDF: extremes are finite, nothing below the horizon") {
  const double cosines[] = {0, 1e-8, 0.5, 1};
  size_t bad = 0;
  for (double metallic : {0.0, 1.0})
    for (double base : {0.0, 1.0})
      for (double r : {0.0, 1e-2, 1.0})
        for (double v : cosines) {
          const Surface surface{glm::dvec3(base), metallic, r};
          const Dfg dfg = dfgOf(surface, v);
          const glm::dvec3 V(std::sqrt(1 - v * v), 0, v);
          for (double l : cosines)
            for (double phi : {0.0, 1.0, pi}) {
              const double s = std::sqrt(1 - l * l);
              const Reflected x = reflect(surface, dfg, N, V, {s * std::cos(phi), s * std::sin(phi), l});
              bad += !(x.specular.x >= 0 && x.diffuse.x >= -1e-9 && std::isfinite(x.specular.x + x.diffuse.x));
            }
          const Reflected back = reflect(surface, dfg, N, V, -V);
          bad += !(back.specular == glm::dvec3(0) && back.diffuse == glm::dvec3(0));
        }
  CHECK(bad == 0);
}
