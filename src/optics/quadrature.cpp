#include "optics/quadrature.hpp"

#include "optics/microfacet.hpp"

namespace facet::optics {

Quadrature gaussLegendre(size_t n) {
  Quadrature rule;
  rule.nodes.resize(n);
  rule.weights.resize(n);
  const double count = static_cast<double>(n);
  for (size_t i = 0; i < (n + 1) / 2; ++i) {
    double x =
        (1 - (1 - 1 / count) / (8 * count * count)) * std::cos(pi * (4 * static_cast<double>(i) + 3) / (4 * count + 2));
    double derivative = 0;
    for (int step = 0; step < 20; ++step) {
      double p = x, previous = 1;
      for (size_t k = 2; k <= n; ++k) {
        const double order = static_cast<double>(k);
        const double next = ((2 * order - 1) * x * p - (order - 1) * previous) / order;
        previous = p;
        p = next;
      }
      derivative = count * (x * p - previous) / ((x - 1) * (x + 1));
      const double change = p / derivative;
      x -= change;
      if (std::abs(change) < 1e-16) break;
    }
    const double weight = 1 / ((1 - x) * (1 + x) * derivative * derivative);  // halved: [0, 1] instead of [-1, 1]
    if (n % 2 == 1 && i == n / 2) x = 0;
    rule.nodes[i] = (1 - x) / 2;
    rule.nodes[n - 1 - i] = (1 + x) / 2;
    rule.weights[i] = rule.weights[n - 1 - i] = weight;
  }
  return rule;
}

glm::dvec2 hammersley(uint32_t i, uint32_t n) {
  uint32_t bits = i;
  bits = (bits << 16) | (bits >> 16);
  bits = ((bits & 0x00ff00ffu) << 8) | ((bits >> 8) & 0x00ff00ffu);
  bits = ((bits & 0x0f0f0f0fu) << 4) | ((bits >> 4) & 0x0f0f0f0fu);
  bits = ((bits & 0x33333333u) << 2) | ((bits >> 2) & 0x33333333u);
  bits = ((bits & 0x55555555u) << 1) | ((bits >> 1) & 0x55555555u);
  return {static_cast<double>(i) / n, static_cast<double>(bits) / 4294967296.0};
}

glm::dvec2 spiralPoint(uint32_t i, uint32_t n) {
  constexpr double ratio = 0.6180339887498949;
  return {(i + 0.5) / n, std::fmod(i * ratio, 1.0)};
}

glm::dvec3 goldenSpiral(size_t i, size_t n) {
  const double z = 1 - (2 * static_cast<double>(i) + 1) / static_cast<double>(n);
  const double sine = std::sqrt((1 - z) * (1 + z));
  const double phi = static_cast<double>(i) * pi * (3 - std::sqrt(5.0));
  return {sine * std::cos(phi), sine * std::sin(phi), z};
}

}  // namespace facet::optics
