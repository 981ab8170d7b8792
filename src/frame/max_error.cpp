#include "frame/max_error.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>

#include "frame/choose.hpp"
#include "frame/settings.hpp"

namespace facet::frame {

namespace {

int most(const PictureSettings& settings) {
  return settings.quality.samples > convergedAbove ? settings.quality.samples : mostSamples;
}

}  // namespace

int firstSamples(const PictureSettings& settings) { return std::min(2 * convergedAbove, most(settings)); }

int nextSamples(const PictureSettings& settings, int samples, double error) {
  assert(settings.quality.maxError && samples > 0);
  const double wanted = 255 * *settings.quality.maxError;
  if (error <= wanted || samples >= most(settings)) return 0;
  // Errors fall by N^-1/2 where they are noise, and by up to N^-1 where they are edges: 0.7 rarely asks for too many,
  // and a further attempt makes up for too few.
  const double needed = samples * std::pow(error / wanted, 1 / 0.7);
  const auto rounded = static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::min<double>(needed, mostSamples))));
  return std::min(std::max(rounded, 2 * samples), most(settings));
}

PictureSettings withSamples(const PictureSettings& settings, int samples) {
  PictureSettings out = settings;
  out.quality.samples = samples;
  out.quality.maxError.reset();
  return out;
}

}  // namespace facet::frame
