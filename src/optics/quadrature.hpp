#pragma once

// Nodes and weights, point sets, and an integrator in one variable that refines itself.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace facet::optics {

struct Quadrature {
  std::vector<double> nodes, weights;  // on [0, 1], ascending; the weights add up to 1
};

// Gauss-Legendre of n >= 1 points: exact for polynomials up to degree 2n - 1. Newton on the three-term recurrence from
// Tricomi's estimate; nodes and weights good to about 1e-15 for n up to 1000.
Quadrature gaussLegendre(size_t n);

// Hammersley 1960: (i / n, van der Corput base 2 of i), i < n <= 2^32.
glm::dvec2 hammersley(uint32_t i, uint32_t n);
// i-th of n: on the unit disc of radius sqrt(x) and azimuth 2 pi y the spiral of Vogel 1979, "A better way to construct
// the sunflower head", y by the golden ratio's multiples.
glm::dvec2 spiralPoint(uint32_t i, uint32_t n);
// i-th of n points spread evenly over the unit sphere (golden-angle spiral, equal areas), from +Z to -Z.
glm::dvec3 goldenSpiral(size_t i, size_t n);

namespace detail {

template <class Value, class Function>
Value gauss(const Function& f, double a, double b, const Quadrature& rule) {
  Value sum{};
  for (size_t i = 0; i < rule.nodes.size(); ++i) sum += f(a + (b - a) * rule.nodes[i]) * rule.weights[i];
  return sum * (b - a);
}

inline double magnitude(double value) { return std::abs(value); }
inline double magnitude(const glm::dvec2& value) { return std::abs(value.x) + std::abs(value.y); }

template <class Value, class Function>
Value refine(const Function& f, double a, double b, const Value& whole, double tolerance, int depth,
             const Quadrature& rule) {
  const double middle = a + (b - a) / 2;
  const Value left = gauss<Value>(f, a, middle, rule), right = gauss<Value>(f, middle, b, rule);
  if (depth == 0 || magnitude(left + right - whole) <= tolerance) return left + right;
  return refine(f, a, middle, left, tolerance / 2, depth - 1, rule) +
         refine(f, middle, b, right, tolerance / 2, depth - 1, rule);
}

}  // namespace detail

// Integral of f over [a, b], Value double or dvec2. Halves an interval until one 8-point rule and two on its halves
// agree within its share of the tolerance (so the result is usually far better than that), or maxDepth is reached.
template <class Value, class Function>
Value integrateAdaptive(const Function& f, double a, double b, double tolerance, int maxDepth = 40) {
  static const Quadrature rule = gaussLegendre(8);
  return detail::refine(f, a, b, detail::gauss<Value>(f, a, b, rule), tolerance, maxDepth, rule);
}

}  // namespace facet::optics
