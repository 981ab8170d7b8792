#include "frame/max_error.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "frame/choose.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

int most(const PictureSettings& settings) {
  return settings.quality.samples > convergedAbove ? settings.quality.samples : mostSamples;
}

// To 4 ... 7 times a power of two, mostSamples at most.
int roundedUp(double samples) {
  if (samples >= mostSamples) return mostSamples;
  const int unit = std::max(1 << std::max(std::ilogb(samples) - 2, 0), 1);
  return static_cast<int>(std::ceil(samples / unit)) * unit;
}

}  // namespace

int firstSamples(const PictureSettings& settings) { return std::min(2 * convergedAbove, most(settings)); }

int nextSamples(const PictureSettings& settings, std::span<const Attempt> attempts) {
  assert(settings.quality.maxError && !attempts.empty());
  const Attempt &first = attempts.front(), &last = attempts.back();
  const double ratio = errorMargin * last.error.most / (255 * *settings.quality.maxError);
  if (ratio <= 1 || last.samples >= most(settings)) return 0;
  // What two attempts have shown of how the error falls holds for the next; the first one tells by its parts.
  double rate = last.error.rate;
  if (attempts.size() > 1)
    rate = std::log(first.error.most / last.error.most) / std::log(static_cast<double>(last.samples) / first.samples);
  double needed = last.samples * std::pow(ratio, 1 / std::clamp(rate, 0.4, 1.0));
  if (attempts.size() == 1 && needed > 4 * last.samples) needed /= 2;  // a guess of so far is none: a look on the way
  return std::clamp(roundedUp(std::max(needed, last.samples + 1.0)), last.samples + 1, most(settings));
}

PictureSettings withSamples(const PictureSettings& settings, int samples) {
  PictureSettings out = settings;
  out.quality.samples = samples;
  out.quality.maxError.reset();
  return out;
}

}  // namespace facet::frame
