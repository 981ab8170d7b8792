#include "frame/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace facet::frame {

namespace {

// |A - B|^2 of the first m and the other n of N draws over the squared error V(N) of all, where V(N) = c N^-2r: from
// V(N) = |m a + n b|^2 / N^2 of the errors a and b of both.
double differenceOverError(double m, double n, double rate) {
  const double all = m + n;
  return std::pow(all / m, 2 * rate) * all / n + std::pow(all / n, 2 * rate) * all / m - all * all / (m * n);
}

struct Fall {
  double square = 0, rate = 0.5;  // at all draws; by N^-2 rate
};

// The squared error by how the differences fall: a line through the last of their logarithms, each weighted by what is
// known of it, with a rate of 1/2 to begin with.
Fall errorByFall(std::span<const PartDifference> parts) {
  constexpr double usualRate = 0.5, rateDeviation = 0.15, leastVariance = 0.01;
  constexpr int fewest = 4;  // draws: before, differences are those of single samples
  constexpr size_t most = 4;
  const PartDifference& all = parts.back();
  const double draws = all.first + all.next;
  double weights = 0, x1 = 0, y1 = 0, x2 = 0, xy = 0;
  for (const PartDifference& part : parts.last(std::min(parts.size(), most))) {
    const double m = part.first, n = part.next;
    if (m + n < fewest || !(part.squares > 0)) continue;
    const double equalParts = differenceOverError(1, 1, usualRate) / differenceOverError(m, n, usualRate);
    const double x = std::log((m + n) / draws), y = std::log(part.squares / part.values * equalParts);
    const double weight = 1 / (part.fourths / (part.squares * part.squares) + leastVariance);
    weights += weight, x1 += weight * x, y1 += weight * y, x2 += weight * x * x, xy += weight * x * y;
  }
  if (weights == 0) return {all.squares / all.values / differenceOverError(all.first, all.next, usualRate)};
  const double before = 1 / (4 * rateDeviation * rateDeviation);  // weight of the usual rate, of 2 r
  const double slope =
      (before * 2 * usualRate * weights + x1 * y1 - weights * xy) / (weights * (x2 + before) - x1 * x1);
  const double rate = std::clamp(slope / 2, 0.3, 1.1);
  return {std::exp((y1 + 2 * rate * x1) / weights) / differenceOverError(1, 1, rate), rate};
}

// By what a sum of squares whose relative variance is that may be too small, at 95 %: chi-squared with 2 /
// variance degrees of freedom (Satterthwaite 1946), as the cube of a normal number (Wilson and Hilferty 1931). The more
// of the sum comes from few pixels, the less is known of it.
double mostOverSum(double variance) {
  constexpr double quantile = 1.645;
  const double share = variance / 9;
  return 1 / std::pow(std::max(1 - share - quantile * std::sqrt(share), 0.3), 3);
}

}  // namespace

ErrorEstimate errorEstimate(std::span<const PartDifference> parts) {
  if (parts.empty() || parts.back().values == 0) return {};
  const PartDifference& all = parts.back();
  if (!(all.squares > 0)) return {0, 0};
  // Halves alone take draws for independent, and say up to 1.7 times too much where they are evener; the fall alone is
  // uncertain. Between both.
  const double independent = all.squares / all.values / differenceOverError(all.first, all.next, 0.5);
  const Fall fall = errorByFall(parts);
  const double likely = 255 * std::pow(independent * fall.square, 0.25);
  const double variance = all.fourths / (all.squares * all.squares);
  const double unmet = 1 + 1.0 / (all.first + all.next);  // what few draws have not met
  return {likely, likely * unmet * std::sqrt(mostOverSum(variance)), fall.rate};
}

}  // namespace facet::frame
