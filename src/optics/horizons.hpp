#pragma once

// Occlusion by the horizons of a height field (Jimenez, Wu, Pesce, Jarabo 2016, "Practical Realtime Strategies for
// Accurate Indirect Occlusion"). The twin is shaders/horizons.glsl.

#include <glm/glm.hpp>

namespace facet::optics {

// Share of a slice's cosine-weighted arc that is open from the viewer's direction to a horizon at angle h [rad], either
// side; n [rad], within pi / 2: the projected normal from the viewer. Equation 7. Both sides of an open hemisphere,
// h = n +- pi / 2, sum to 1.
double openArc(double h, double n);

// The horizon, kept within pi / 2 of the normal.
double keptHorizon(double h, double n);

// Light that arrives where only a share (0, 1] of the sky is seen past surfaces of the same albedo, which return some,
// over that share: equation 10, a fit to path-traced scenes. At least 1, and at most what no surface hides.
glm::dvec3 interreflection(double share, const glm::dvec3& albedo);

}  // namespace facet::optics
