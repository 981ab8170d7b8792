#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace facet::ibl {

// A point set for the kernel D(H) NoL of N = V = R: directions in N's frame with equal shares of the kernel on a golden
// angle spiral, and the mip level of a cube map of faceSize^2 faces whose texels are as large as the share (Krivanek
// and Colbert 2008, with K = 1).
struct KernelSample {
  glm::dvec3 direction;
  double level;
};
std::vector<KernelSample> kernelSamples(double alpha, int count, int faceSize);

// Share of the kernel within the cone of half angle acos(mu) about N, mu = NoL in [0, 1]; 1 at mu = 0. Closed form.
double kernelShare(double alpha, double mu);

}  // namespace facet::ibl
