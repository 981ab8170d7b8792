#pragma once

// What is told of a frame: no OpenGL.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace facet::frame {

// How the mean of a picture's first draws differs from that of the next ones: sums of squared differences of display
// values over all pixels and colour channels, of bands or of the whole.
struct PartDifference {
  int first = 0, next = 0;  // draws
  double squares = 0;
  double fourths = 0;  // of each pixel's sum over its channels, squared
  double values = 0;   // pixels times channels
};

// What a picture is off by: root mean square over its pixels and colour channels in 1/255, before rounding to 8 bits.
struct ErrorEstimate {
  double likely = -1;  // below 0: not estimated
  double most = -1;    // up to which it is, with errorConfidence
  double rate = 0.5;   // it falls about by N^-rate
};
// Measured: the share of estimates whose `most` was not below the true error (README.md). Its quantile is that of 95 %,
// but samples do not know what none of them has met.
inline constexpr double errorConfidence = 0.79;

// Of a picture whose parts differ like that: the last entry is of all its draws, those before it of fewer and fewer of
// the first ones. What all draws have in common, and what none has met, they do not know.
ErrorEstimate errorEstimate(std::span<const PartDifference> parts);

// GPU time of a pass of a frame.
struct PassTime {
  std::string name;
  double startMs = 0;  // of its first run, since the frame's first pass
  double gpuMs = 0;    // of all its runs
  int runs = 0;
};

struct FrameStatistics {
  std::vector<std::string> passes;
  int draws = 0;
  uint64_t instances = 0, triangles = 0;
  uint64_t culled = 0;                // instances of draws outside the picture
  uint64_t rays = 0;                  // of path-traced light
  std::vector<PartDifference> parts;  // where the targets have a `before`: see errorEstimate
};

// How the display pictures of a measured BRDF and of the model fitted to it differ, in 1/255.
struct ComparisonFigures {
  double rms = 0;      // root mean square over the pixels that differ at all and the colour channels
  double share = 0;    // of the picture's pixels: those
  double largest = 0;  // of any channel
};

}  // namespace facet::frame
