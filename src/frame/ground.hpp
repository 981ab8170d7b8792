#pragma once

// A floor below the scene that is seen only by what the scene does to the light on it: shadows, and what it returns. It
// is in no ray's way and lights nothing. Paths from a grid of its points find which share of its light arrives (GROUND,
// shaders/passes/paths_ground.comp.glsl); the picture reads the grid, from wherever it is seen.

#include "frame/paths.hpp"

namespace facet::frame {

// What its grid is made for, besides the draw list and the tables.
struct GroundWish {
  int size = 0;     // points along an axis
  int samples = 0;  // of each point
  int seed = 0;
  float environmentRotationDeg = 0, environmentStrength = 1;

  bool operator==(const GroundWish&) const = default;
};
GroundWish groundWish(const PictureSettings& settings);

struct Ground {
  glm::vec4 place = glm::vec4(0);  // xyz its middle from the list's origin, w half its width [m]
  GroundWish wish = {};
  int done = 0;        // samples
  int row = 0;         // of the next one
  gl::Texture sums;    // RGBA32F array, groundSumLayers; only until it is complete
  gl::Texture shares;  // RGBA32F array, groundLayers; no floor is seen before there is one
  PathWork work = {};
  uint64_t rays = 0;  // of what is complete

  bool complete() const { return wish.samples > 0 && done == wish.samples; }
  size_t bytes() const { return shares.bytes(); }
};

// Just below the bounds, which may be those of all poses of an animation: the floor does not move with them; and wide
// enough for the shadows of light that is 40 degrees high.
Ground placedGround(const DrawList& list, const scene::Bounds& bounds);

// Goes on with the grid of what in.settings ask for, from the start where that has changed, some thousand paths at a
// time; in.paths is there. True: it is complete.
Result<bool> continueGround(const FrameInput& in, Ground& ground, shading::ProgramStore& programs,
                            const KeepGoing& keepGoing = {});

// The same as a question; true where there is no floor.
bool groundComplete(const Ground* ground, const PictureSettings& settings);

// Over what is drawn and behind what is to come, in the frame's target.
Result<void> drawGround(const FrameInput& in, shading::ProgramStore& programs, FrameStatistics& statistics);

// All that both use.
std::vector<ProgramGetter> neededGroundPrograms(const FrameInput& in, shading::ProgramStore& programs);

}  // namespace facet::frame
