#include "ibl/prepared.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace facet;

TEST_CASE("Tables of an environment hold its radiance in a power of two that suits halves") {
  const auto scale = [](float largest) {
    scene::Environment map;
    map.width = 2, map.height = 1;
    map.radiance = {glm::vec3(largest / 1000), glm::vec3(0, largest, 0)};
    return ibl::radianceScaleFor(map);
  };
  for (const float usual : {1.0f / 64, 0.5f, 1.0f, 1000.0f, 32768.0f}) CHECK(scale(usual) == 1);
  CHECK(scale(32769) == 2);
  CHECK(scale(1e6f) == 32);
  CHECK(scale(0.015f) == 1.0f / 64);
  CHECK(scale(0) == 1);
  for (const float largest : {1e-38f, 1e-20f, 1e-6f, 0.01f, 1e5f, 1e20f}) {
    const float stored = largest / scale(largest);
    INFO(largest << " is stored as " << stored);
    CHECK(stored <= 32768);
    if (largest > 1e-30f) CHECK(stored > 0.5f);
    CHECK(std::exp2(std::round(std::log2(scale(largest)))) == scale(largest));
  }
}
