#include "optics/downhill.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

std::vector<double> downhill(std::vector<std::vector<double>> simplex, double tolerance, int most,
                             const std::function<double(const std::vector<double>&)>& f) {
  const size_t n = simplex.size() - 1;
  std::vector<std::pair<double, std::vector<double>>> points;
  for (auto& point : simplex) {
    const double value = f(point);
    points.emplace_back(value, std::move(point));
  }
  for (int evaluations = 0; evaluations < most;) {
    std::sort(points.begin(), points.end());
    double size = 0;
    for (size_t i = 1; i <= n; ++i)
      for (size_t k = 0; k < n; ++k) size = std::max(size, std::abs(points[i].second[k] - points[0].second[k]));
    if (size < tolerance) break;
    std::vector<double> centre(n, 0.0);
    for (size_t i = 0; i < n; ++i)
      for (size_t k = 0; k < n; ++k) centre[k] += points[i].second[k] / static_cast<double>(n);
    const auto tryAt = [&](double factor) {
      std::vector<double> point(n);
      for (size_t k = 0; k < n; ++k) point[k] = centre[k] + factor * (points[n].second[k] - centre[k]);
      ++evaluations;
      const double value = f(point);
      return std::pair(value, std::move(point));
    };
    auto reflected = tryAt(-1);
    if (reflected.first < points[0].first) {
      auto expanded = tryAt(-2);
      points[n] = expanded.first < reflected.first ? expanded : reflected;
    } else if (reflected.first < points[n - 1].first && n > 1) {
      points[n] = reflected;
    } else {
      auto contracted = tryAt(reflected.first < points[n].first ? -0.5 : 0.5);
      if (contracted.first < std::min(reflected.first, points[n].first)) {
        points[n] = contracted;
        continue;
      }
      for (size_t i = 1; i <= n; ++i) {
        for (size_t k = 0; k < n; ++k) points[i].second[k] = (points[i].second[k] + points[0].second[k]) / 2;
        points[i].first = f(points[i].second);
        ++evaluations;
      }
    }
  }
  return std::min_element(points.begin(), points.end())->second;
}

}  // namespace facet::optics
