#pragma once

// Directions of an environment, drawn by how much its texels radiate: the table that shaders/environment_texels.glsl
// reads, and its twin in double precision.

#include "optics/environment.hpp"

namespace facet::optics {

// Shares of what is drawn, by texel of an equirectangular grid, halved along both axes from level to level. An element
// holds those of four texels: upper left, upper right, lower left, lower right.
struct TexelTable {
  int width = 0, height = 0;                   // texels, powers of two, width = 2 height
  std::vector<std::vector<glm::vec4>> levels;  // width / 2 x height / 2 elements, then halved until there is one

  glm::ivec2 elements(int level) const;
};

// Each texel's share is its solid angle times what the mean of the radiance's channels, spread by [1 2 1] / 4 along
// both axes, has above its mean over the sphere: directions of less light are left to whoever draws by the lobes
// (Karlik et al. 2019, "MIS Compensation"). Wherever bilinear interpolation sees more, the density is above 0. The
// smallest power of two that is not below the environment's width, `largest` at most (then a share is that of several
// texels). An even environment: of all directions alike.
TexelTable texelTable(const Environment& environment, int largest);

// Of a direction in the environment's space [1/sr].
double texelDensity(const TexelTable& table, const glm::dvec3& direction);

struct TexelSample {
  glm::dvec3 direction = glm::dvec3(0, 1, 0);
  double density = 0;  // [1/sr]
};
// u in [0, 1)^2.
TexelSample sampleTexels(const TexelTable& table, glm::dvec2 u);

}  // namespace facet::optics
