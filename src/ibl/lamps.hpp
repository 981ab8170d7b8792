#pragma once

// The environment for samples: its lamps, which are sampled on their own, and the rest, whose samples each read a level
// by their share of the lobe. The GLSL side is shaders/environment_samples.glsl.

#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "ibl/filters.hpp"

namespace facet::ibl {

struct Tables;

// A texel that samples of the lamps fall into.
struct LampPoint {
  float texel;    // index: (face size + row) size + column; exact up to size 1024
  float density;  // of samples per unit of the face's st area, [-1, 1]^2
};

struct Lamps {
  std::vector<glm::vec4> rest;    // radiance that no lamp sends; alpha unused
  std::vector<glm::vec4> lamps;   // rgb what is left of it; alpha density of samples [1/sr], the texel's mean
  std::vector<LampPoint> points;  // equal shares of all samples, along a curve; empty: there are no lamps
};

inline constexpr int lampPointsWidth = 512, lampPointsHeight = 256;

// texels: of a cube of size^2 faces, face by face. Lamps is what exceeds twice the mean radiance of the sphere (more
// where that is more than a quarter of the texels that there are points for), by the brightest channel, if it is at
// least 2 % of the light. Samples fall into the texels from which a bilinear look-up has any of it, in proportion to
// how much, into each with a chance of one point at least.
Lamps findLamps(const std::vector<glm::vec4>& texels, int size);

// Steps that leave Tables::rest, lamps and lampPoints in made, from scratch's environment cube, which is made by then.
void addLampSteps(std::vector<Step>& steps, Tables& made, const std::shared_ptr<Scratch>& scratch,
                  shading::ProgramStore& programs);

}  // namespace facet::ibl
