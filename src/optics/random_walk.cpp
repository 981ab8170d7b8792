#include "optics/random_walk.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

// Lambda of the paper's eq. 2 in both half spaces: below the horizon -1 - Lambda of the opposite direction.
double signedLambda(double cosine, double alpha) {
  return cosine > 0 ? Lambda_GGX(cosine, alpha) : -1 - Lambda_GGX(-cosine, alpha);
}

// The share of facets below the ray's height, after it went on to the next facet: 1 or more if there is none. From eq.
// 13 to 15, where the heights' distribution drops out.
double nextHeight(double height, double cosine, double alpha, double u) {
  const double lambda = signedLambda(cosine, alpha);
  if (std::abs(lambda) < 1e-12) return 2;  // straight up
  return height * std::pow(1 - u, -1 / lambda);
}

constexpr int mostBounces = 1000;

}  // namespace

WalkedAlbedo walkAlbedo(double NoV, double alpha, const glm::dvec3& f0, double f90, size_t walks) {
  std::mt19937_64 engine(1);
  const auto uniform = [&] {
    return (static_cast<double>(engine() >> 12) + 0.5) * 0x1p-52;
  };  // (0, 1), alike everywhere
  const glm::dvec3 V(std::sqrt((1 - NoV) * (1 + NoV)), 0, NoV);
  WalkedAlbedo sum;
  glm::dvec3 squares(0);
  for (size_t i = 0; i < walks; ++i) {
    glm::dvec3 direction = -V, weight(1);
    double height = 1;
    int bounces = 0;
    while (bounces < mostBounces) {
      height = nextHeight(height, direction.z, alpha, uniform());
      if (height >= 1) break;
      const glm::dvec3 back = -direction;
      const glm::dvec2 u(uniform(), uniform());
      const glm::dvec3 H = sampleVisibleGGX(back, alpha, u);
      weight *= F_Schlick(glm::dot(back, H), f0, f90);
      direction = glm::reflect(direction, H);
      ++bounces;
    }
    (bounces == 1 ? sum.single : sum.multiple) += weight;
    squares += weight * weight;
  }
  const auto count = static_cast<double>(walks);
  sum.single /= count, sum.multiple /= count;
  const glm::dvec3 mean = sum.single + sum.multiple;
  sum.deviation = glm::sqrt(glm::max(squares / count - mean * mean, glm::dvec3(0)) / count);
  return sum;
}

}  // namespace facet::optics
