#pragma once

// Light that passes a surface and leaves beyond it as one lobe: what a picture shows through glass. Of one crossing,
// optics/transmission.hpp has the truth; this is what is left of a body whose far side is not traced.

#include <glm/glm.hpp>

namespace facet::optics {

// alpha of the lobe that transmitted light leaves by: the reflected GGX lobe of that alpha, mirrored at the surface.
// Thin walls: KHR_materials_transmission's lobe, by transmissionRoughness. A volume: refracted twice by rough surfaces,
// into the body and out of it. A facet of slope m turns the light by (ior - 1) m outside, a mirror by 2 m, and the sum
// of two independent GGX slopes has 1.671 times the median of one: 0.8354 (ior - 1) alpha, at most 1. In [0, 1];
// ior = 0 (infinite): nothing passes, the surface's own.
double transmittedAlpha(double perceptualRoughness, double ior, bool volume);

// f |NoL| [1/sr] of that lobe with F = 1; N, V above, L below, else 0. Its integral over L is A + B of energy.hpp, so
// over that it keeps all energy. alpha = 0: 0, a delta.
double transmittedLobe(const glm::dvec3& V, const glm::dvec3& L, double alpha);

// How an edge appears, that lies x to the side of the view's foot and a distance behind a rough pane that is met head
// on; half width a = 2 alpha distance: 1/2 (1 + x / sqrt(x^2 + a^2)), small angles. a = 0: a step.
double transmittedEdge(double x, double a);
// The same as the GPU blurs it, by two Gaussians: off by 0.006 at most.
double transmittedEdgeFit(double x, double a);

// Variance [pixels^2 along each axis] of level k of the copy of what is behind: filtered k times by [1 3 3 1] / 8, read
// by a cubic B-spline. (7 4^k - 3) / 12.
double behindVariance(int level);
// Levels whose mix has a variance: level (-1: the picture itself, variance 0) and the share of the next one. Above the
// last level: that one.
struct BehindLevel {
  int level = -1;
  double weight = 0;
};
BehindLevel findBehindLevel(double variance, int levels);

}  // namespace facet::optics
