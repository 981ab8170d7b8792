#include "frame/measured_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace facet::frame {

namespace {

constexpr std::array counts = {4, 8, 16, 32, 64, 128, 256, 512, 1024};

struct Row {
  std::string_view name;
  double alpha, diffuseShare;
  std::array<double, counts.size()> errors;
};

// By the table "measured-samples" of `facet report measured` under builtin:studio; made by tools/measured_samples.
constexpr Row rows[] = {
#include "frame/measured_samples.inc"
};

// Matte, lobe over a matte ground, lobe alone.
int classOf(double diffuseShare) { return diffuseShare > 0.97 ? 0 : diffuseShare > 0.5 ? 1 : 2; }

}  // namespace

int measuredSamples(const optics::MeasuredProxy& proxy, double maxError) {
  const double alpha = std::min(proxy.alpha.t, proxy.alpha.b);
  // The next sharper and the next wider row of the same class; the last one beyond the ends.
  const Row *sharper = nullptr, *wider = nullptr;
  for (const Row& row : rows) {
    if (classOf(row.diffuseShare) != classOf(proxy.diffuseShare)) continue;
    if (row.alpha <= alpha * 1.05 && (!sharper || row.alpha > sharper->alpha)) sharper = &row;
    if (row.alpha >= alpha / 1.05 && (!wider || row.alpha < wider->alpha)) wider = &row;
  }
  for (size_t i = 0; i < counts.size(); ++i)
    if ((!sharper || sharper->errors[i] <= maxError) && (!wider || wider->errors[i] <= maxError)) return counts[i];
  return counts.back();
}

}  // namespace facet::frame
