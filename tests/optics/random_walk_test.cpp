#include "optics/random_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/energy.hpp"
#include "optics/presets.hpp"

using namespace facet::optics;

TEST_CASE("Random walk: white facets return all, the first bounce is the DFG integral") {
  const glm::dvec3 f0(1, 0.5, 0.04);
  for (double alpha : {0.05, 0.36, 1.0})
    for (double NoV : {0.05, 0.5, 1.0}) {
      const WalkedAlbedo walked = walkAlbedo(NoV, alpha, f0, 1, 20000);
      const Dfg dfg = integrateDfg(NoV, alpha);
      INFO("alpha " << alpha << ", NoV " << NoV);
      CHECK((walked.single + walked.multiple).x == Approx(1).epsilon(1e-12));
      // Deviation of a share of 20000 walks: 0.0036 at most.
      for (int c = 0; c < 3; ++c) CHECK(walked.single[c] == Approx(f0[c] * dfg.A + dfg.B).margin(0.013));
      CHECK(walked.deviation.x < 1e-9);
      CHECK(walked.deviation.y < 0.004);
    }
}

TEST_CASE("Random walk: hardly rough is a mirror, and of grey facets each bounce costs its share") {
  const WalkedAlbedo smooth = walkAlbedo(0.7, 1e-3, glm::dvec3(0.3), 0.3, 2000);
  CHECK(smooth.single.x == Approx(0.3).margin(1e-3));
  // F = 0.5 at every facet: the second bounce returns at most half as much as was missing after the first.
  const WalkedAlbedo grey = walkAlbedo(1, 1, glm::dvec3(0.5), 0.5, 20000);
  const double missing = std::log(2.0);
  CHECK(grey.multiple.x < 0.25 * missing);
  CHECK(grey.multiple.x > 0.5 * 0.25 * missing);
  const WalkedAlbedo again = walkAlbedo(1, 1, glm::dvec3(0.5), 0.5, 20000);
  CHECK(again.multiple == grey.multiple);
}

TEST_CASE("Random walk: how far the energy models are off for rough gold") {
  const glm::dvec3 f0 = findMetal("gold")->f0();
  constexpr struct {
    EnergyModel model;
    double least, most;
  } models[] = {{EnergyModel::none, -0.58, -0.04},
                {EnergyModel::fdezAguera, -0.08, 0.005},
                {EnergyModel::kullaConty, -0.05, 0.005},
                {EnergyModel::turquin, -0.01, 0.06}};
  for (double NoV : {0.3, 1.0}) {
    const WalkedAlbedo truth = walkAlbedo(NoV, 1, f0, 1, 1 << 15);
    const Dfg dfg = integrateDfg(NoV, 1);
    for (const auto& [model, least, most] : models) {
      const glm::dvec3 error = specularAlbedo(model, dfg, 1, f0) - truth.single - truth.multiple;
      INFO("model " << int(model) << ", NoV " << NoV << ": " << error.r << ", " << error.g << ", " << error.b);
      for (int c = 0; c < 3; ++c) {
        CHECK(error[c] > least);
        CHECK(error[c] < most);
      }
    }
  }
}
