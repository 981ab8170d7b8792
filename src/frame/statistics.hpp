#pragma once

// What is told of a frame: no OpenGL.

#include <cstdint>
#include <string>
#include <vector>

namespace facet::frame {

struct FrameStatistics {
  std::vector<std::string> passes;
  int draws = 0;
  uint64_t instances = 0, triangles = 0;
  uint64_t culled = 0;  // instances of draws outside the picture
  uint64_t rays = 0;    // of path-traced light
  double error = -1;    // estimated (PictureErrors::parts), 1/255; below 0: the targets have no `before`
};

// How the display pictures of a measured BRDF and of the model fitted to it differ, in 1/255.
struct ComparisonFigures {
  double rms = 0;      // root mean square over the pixels that differ at all and the colour channels
  double share = 0;    // of the picture's pixels: those
  double largest = 0;  // of any channel
};

}  // namespace facet::frame
