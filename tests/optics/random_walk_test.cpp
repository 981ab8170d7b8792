#include "optics/random_walk.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/energy.hpp"
#include "optics/fresnel.hpp"

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
