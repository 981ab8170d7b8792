#include "optics/quadrature.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"

using namespace facet::optics;

TEST_CASE("gaussLegendre: exact to degree 2n - 1, and no further") {
  for (size_t n : {1, 2, 3, 5, 16, 33, 128}) {
    const Quadrature rule = gaussLegendre(n);
    REQUIRE(rule.nodes.size() == n);
    const auto power = [&](size_t degree) {
      double sum = 0;
      for (size_t i = 0; i < n; ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], static_cast<double>(degree));
      return sum * static_cast<double>(degree + 1);
    };
    for (size_t degree : {size_t{0}, n, 2 * n - 1}) CHECK(power(degree) == Approx(1).epsilon(1e-13));
    if (n <= 5) CHECK(std::abs(power(2 * n) - 1) > 1e-6);
    for (size_t i = 1; i < n; ++i) CHECK(rule.nodes[i] > rule.nodes[i - 1]);
  }
  const Quadrature two = gaussLegendre(2);
  CHECK(two.nodes[0] == Approx((1 - 1 / std::sqrt(3.0)) / 2).epsilon(1e-15));
  const Quadrature many = gaussLegendre(1000);
  double sum = 0;
  for (size_t i = 0; i < 1000; ++i) sum += many.weights[i] / (1 + many.nodes[i]);
  CHECK(sum == Approx(std::log(2.0)).epsilon(1e-14));
}

TEST_CASE("integrateAdaptive: kinks and narrow peaks") {
  CHECK(integrateAdaptive<double>([](double x) { return std::abs(x - 0.3); }, 0, 1, 1e-12) ==
        Approx(0.5 * (0.09 + 0.49)).epsilon(1e-11));
  const double w = 1e-4;
  CHECK(integrateAdaptive<double>([&](double x) { return w / (x * x + w * w); }, -1, 1, 1e-12) ==
        Approx(2 * std::atan(1 / w)).epsilon(1e-11));
}

TEST_CASE("hammersley and goldenSpiral are even") {
  CHECK(hammersley(0, 4) == glm::dvec2(0, 0));
  CHECK(hammersley(1, 4) == glm::dvec2(0.25, 0.5));
  CHECK(hammersley(3, 4) == glm::dvec2(0.75, 0.75));
  glm::dmat3 moments(0);
  glm::dvec3 mean(0);
  constexpr size_t n = 4096;
  for (size_t i = 0; i < n; ++i) {
    const glm::dvec3 d = goldenSpiral(i, n);
    CHECK(std::abs(glm::length(d) - 1) < 1e-14);
    mean += d / double(n);
    moments += glm::outerProduct(d, d) / double(n);
  }
  CHECK(glm::length(mean) < 1e-3);
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) CHECK(moments[i][k] == Approx(i == k ? 1.0 / 3 : 0).margin(1e-3));
}
