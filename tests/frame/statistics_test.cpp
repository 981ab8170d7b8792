#include "frame/statistics.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace facet;
using frame::ErrorEstimate, frame::PartDifference;

namespace {

constexpr double pixels = 1e4, channels = 3;

// Differences at 2, 4, 8 ... draws and at all of them, of errors that fall by N^-rate from `error` (of 1) at one draw;
// `noisy` pixels bear them in equal shares.
std::vector<PartDifference> differences(std::vector<std::pair<int, int>> marks, double error, double rate,
                                        double noisy = pixels) {
  std::vector<PartDifference> parts;
  for (const auto& [m, n] : marks) {
    const auto variance = [&](double draws) { return error * error * std::pow(draws, -2 * rate); };
    const double all = m + n;
    // What V(m), V(n) and V(m + n) leave for |a - b|^2.
    const double square = variance(m) * all / n + variance(n) * all / m - variance(all) * all * all / (m * n);
    const double squares = square * pixels * channels;
    parts.push_back({m, n, squares, squares * squares / noisy, pixels * channels});
  }
  return parts;
}

const std::vector<std::pair<int, int>> doublings = {{1, 1}, {2, 2}, {4, 4}, {8, 8}, {16, 16}, {32, 32}};

}  // namespace

TEST_CASE("error estimate: noise of independent draws, for halves and for what is left of any number") {
  for (const auto& marks : {doublings, {{1, 1}, {2, 2}, {4, 4}, {8, 12}}, {{1, 1}}}) {
    const double draws = marks.back().first + marks.back().second;
    const ErrorEstimate estimate = frame::errorEstimate(differences(marks, 0.1, 0.5));
    CHECK(estimate.likely == Approx(255 * 0.1 / std::sqrt(draws)).epsilon(1e-6));
  }
  CHECK(frame::errorEstimate({}).likely < 0);
  const std::vector<PartDifference> none = {{1, 1, 0, 0, 3}};
  CHECK(frame::errorEstimate(none).likely == 0);
  CHECK(frame::errorEstimate(none).most == 0);
}

TEST_CASE("error estimate: where errors fall faster, halves say too much, and half of that is seen") {
  const double half = 255 * 0.1 * std::sqrt(differences({{32, 32}}, 1, 0.85)[0].squares / pixels / channels) / 2;
  const double truth = 255 * 0.1 * std::pow(64, -0.85);
  CHECK(half / truth == Approx(1.50).epsilon(0.01));
  const double likely = frame::errorEstimate(differences(doublings, 0.1, 0.85)).likely;
  CHECK(likely > truth);
  CHECK(likely < 1.3 * truth);
  CHECK(frame::errorEstimate(differences(doublings, 0.1, 0.85)).rate == Approx(0.85).margin(0.15));
}

TEST_CASE("error estimate: the fewer pixels bear the noise, the more it may be") {
  const auto most = [](double noisy) {
    const ErrorEstimate estimate = frame::errorEstimate(differences(doublings, 0.1, 0.5, noisy));
    return std::pow(estimate.most / estimate.likely / (1 + 1.0 / 64), 2);
  };
  // 2 n degrees of freedom over the 5 % quantile of chi-squared.
  CHECK(most(1e4) == Approx(20000 / 19671.9).epsilon(1e-3));
  CHECK(most(50) == Approx(100 / 77.93).epsilon(2e-3));
  CHECK(most(5) == Approx(10 / 3.940).epsilon(0.01));
  CHECK(most(2) == Approx(4 / 0.711).epsilon(0.05));
}
