#include "optics/footprint.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace facet::optics;

TEST_CASE("Footprints: reads along the longer axis, each of half the axes' ratio at most") {
  const auto reads = [](glm::dvec2 dx, glm::dvec2 dy, double most = 8) { return footprintReads(dx, dy, most); };
  CHECK(reads({3, 0}, {0, 3}).count == 1);
  CHECK(reads({3, 0}, {0, 3}).scale == 1);
  // Twice as long: one read at the mean level of both axes.
  CHECK(reads({6, 0}, {0, 3}).count == 1);
  CHECK(reads({6, 0}, {0, 3}).scale == Approx(1 / std::sqrt(2)));
  for (const double turn : {0.0, 0.7, 2.0}) {  // whatever the direction, whichever is longer
    const glm::dvec2 along = 10.0 * glm::dvec2(std::cos(turn), std::sin(turn)), across(-along.y / 5, along.x / 5);
    CHECK(reads(along, across).count == 3);
    CHECK(reads(across, along).count == 3);
    // Across is 2, a read's share of along 10 / 3: the level is that of their mean.
    CHECK(reads(across, along).scale * 10 == Approx(std::sqrt(2 * 10.0 / 3)));
  }
  CHECK(reads({500, 0}, {0, 1}).count == 4);  // no more than is wished for
  CHECK(reads({500, 0}, {0, 1}).scale == Approx(1 / std::sqrt(8 * 4.0)));
  CHECK(reads({500, 0}, {0, 1}, 1).count == 1);
  CHECK(reads({500, 0}, {0, 1}, 1).scale == 1);
  // Magnified: there is nothing between texels.
  CHECK(reads({0.9, 0}, {0, 0.1}).count == 1);
  CHECK(reads({0.9, 0}, {0, 0.1}).scale == 1);
  CHECK(reads({4, 0}, {0, 0.1}).scale == Approx(1 / std::sqrt(4 * 2.0)));  // the shorter axis counts as a texel
  CHECK(reads({0, 0}, {0, 0}).count == 1);
  CHECK(reads({0, 0}, {0, 0}).scale == 1);
  CHECK(reads({1e20, 0}, {1e20, 0}).count == 4);  // no area
}
