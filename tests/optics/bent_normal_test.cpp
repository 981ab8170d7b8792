#include "optics/bent_normal.hpp"

#include <catch2/catch.hpp>
#include <random>

using namespace facet;

TEST_CASE("Bent normals: the mirror direction leaves the surface, and who leans less stays as it is", "[optics]") {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const glm::dvec3 Ng(0, 0, 1);
  int bent = 0;
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 N = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    glm::dvec3 V = glm::normalize(glm::dvec3(normal(random), normal(random), normal(random)));
    V.z = std::abs(V.z);
    const glm::dvec3 got = optics::bentNormal(N, Ng, V);
    CHECK(glm::length(got) == Approx(1));
    const glm::dvec3 before = 2 * glm::dot(N, V) * N - V, mirrored = 2 * glm::dot(got, V) * got - V;
    CHECK(mirrored.z > 0);
    const double least = std::min(0.01, 0.9 * V.z);
    if (before.z >= least) {
      CHECK(got == N);
      continue;
    }
    ++bent;
    CHECK(glm::dot(got, V) > 0);
  }
  CHECK(bent > 500);
  // From straight ahead a normal that leans by less than half a right angle stays.
  CHECK(optics::bentNormal(glm::normalize(glm::dvec3(0.9, 0, 1)), Ng, Ng).x == Approx(0.9 / std::sqrt(1.81)));
}
