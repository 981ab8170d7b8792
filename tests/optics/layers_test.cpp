#include "optics/layers.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "support/direction.hpp"

using namespace facet::optics;

using facet::test::direction;

namespace {

double coatAlbedo(double NoV, double alpha) {
  const Dfg dfg = integrateDfg(NoV, alpha, 1e-6);
  return coatF0 * dfg.A + dfg.B;
}

}  // namespace

TEST_CASE("Coat: none is none, the extension's factors, its lobe integrates to its albedo") {
  CHECK(coatTransmittance(0, 0.1) == 1);
  CHECK(coatTransmittance(1, 1) == Approx(0.96));
  CHECK(coatTransmittance(1, 0) == 0);
  CHECK(coatTransmittanceBothWays(0.5, 1, 1) == Approx(0.98 * 0.98));
  const glm::dvec3 V = direction(0.5, 0.3);
  constexpr size_t count = 200000;
  double sum = 0;
  for (size_t i = 0; i < count; ++i) sum += coatLobe({0, 0, 1}, V, goldenSpiral(i, count), 0.4);
  CHECK(sum * 4 * pi / count == Approx(coatAlbedo(0.5, 0.4)).epsilon(2e-3));
  CHECK(coatLobe({0, 0, 1}, V, direction(-0.1, 0), 0.4) == 0);
}

TEST_CASE("Coat over white: by albedo exactly white, by the extension's Fresnel term what it gains and loses") {
  double gain = 0, loss = 0, smooth = 0, both = 0;
  for (double alpha : {0.0, 0.01, 0.1, 0.3, 0.6, 1.0})
    for (double NoV : {0.02, 0.1, 0.2, 0.4, 0.7, 1.0})
      for (double clearcoat : {0.3, 1.0}) {
        const double E = coatAlbedo(NoV, alpha);
        CHECK(clearcoat * E + layerTransmittance(clearcoat, E) == Approx(1).epsilon(1e-14));
        const double change = clearcoat * E + coatTransmittance(clearcoat, NoV) - 1;
        (change > 0 ? gain : loss) = change > 0 ? std::max(gain, change) : std::min(loss, change);
        if (alpha == 0) smooth = std::max(smooth, std::abs(change));
      }
  for (double NoV : {0.1, 0.5, 1.0}) {
    // Smooth coat over white Lambert, attenuated both ways: 1 - F(V) + F(V) - (1 - F(V)) 2 int F mu dmu.
    const double mean = F_SchlickAverage(glm::dvec3(coatF0), 1).x;
    const auto f = [&](double mu) { return 2 * mu * coatTransmittanceBothWays(1, NoV, mu); };
    const double total = F_Coat(NoV) + integrateAdaptive<double>(f, 0, 1, 1e-10);
    CHECK(total == Approx(1 - (1 - F_Coat(NoV)) * mean).epsilon(1e-8));
    both = std::min(both, total - 1);
  }
  INFO("gain " << gain << ", loss " << loss << ", smooth " << smooth << ", both ways " << both);
  CHECK(smooth < 1e-9);
  CHECK(gain == Approx(0.0007).margin(0.0001));
  CHECK(loss == Approx(-0.833).margin(0.002));  // alpha 1, NoV 0.02
  CHECK(both == Approx(-0.0823).margin(0.001));
}

TEST_CASE("Layers: the reciprocal form gives the same sum over a Lambertian base") {
  const double alpha = 0.3;
  for (double weight : {0.4, 1.0}) {
    const auto E = [&](double mu) { return coatAlbedo(mu, alpha) * 5; };  // a stronger layer shows more
    const double mean = integrateAdaptive<double>([&](double mu) { return 2 * mu * E(mu); }, 0, 1, 1e-6, 8);
    for (double NoV : {0.3, 0.9}) {
      const auto f = [&](double mu) { return 2 * mu * layerTransmittanceReciprocal(weight, E(NoV), E(mu), mean); };
      CHECK(integrateAdaptive<double>(f, 0, 1, 1e-6, 8) == Approx(1 - weight * E(NoV)).margin(1e-4));
      CHECK(layerTransmittanceReciprocal(weight, E(NoV), 0.2, mean) ==
            Approx(layerTransmittanceReciprocal(weight, 0.2, E(NoV), mean)));
    }
  }
  CHECK(layerTransmittanceReciprocal(1, 1, 1, 1) == 0);
}
