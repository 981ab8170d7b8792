#pragma once

// Filters on the sphere that depend on the angle to their centre alone: products of Legendre coefficients, and the
// prefiltered layers' kernels as mixtures of few smooth filters. Kernels integrate to 1 over the sphere; their
// coefficient of degree l is int K P_l dw.
//
// A GGX kernel is, near enough, a mixture of Gaussians: with widths a factor of sqrt(2) apart the largest deviation is
// in the tests. Each Gaussian blur is made from the next narrower one with few taps, so that a whole chain costs less
// than a single layer by sampling.

#include <cstddef>
#include <vector>

namespace facet::optics {

// P_0 .. P_(count - 1) at x in [-1, 1].
std::vector<double> legendre(double x, std::size_t count);

// The kernel of the prefiltered layers for N = V = R, D(H) NoL, normalised [1/sr]; 0 below the horizon. alpha = 1: NoL
// / pi.
double prefilterKernel(double alpha, double theta);

// Few cells of radiance in the place of the sphere: the mean of max(x, 0) over x spread evenly about c with that
// variance, which is what a cell across the horizon sends, and with it D(H) NoL of N = V = R, but for a factor, where c
// is the cosine of normal and light.
double spreadCosine(double c, double variance);
double spreadZonalKernel(double c, double variance, double alpha);

// One ring of taps about the centre, its weight shared by `count` taps at the azimuths 2 pi (i + turn) / count.
struct Ring {
  double angle = 0;   // rad
  double weight = 1;  // of the whole ring; all rings sum to 1
  int count = 1;
  double turn = 0;
};
// A Gaussian of standard deviation tau (rad, per axis) on a hexagonal grid of 19 points, 1.15 tau apart.
std::vector<Ring> hexagonalBlur(double tau);
std::vector<double> coefficients(const std::vector<Ring>& rings, std::size_t count);

// The blurred copies of an environment cube that layers are mixed from: copy 0 is the cube itself, copy i + 1 is copy i
// blurred by rings. sigma: per axis, rad, with what bilinear look-ups add.
struct BlurredCopy {
  int size = 256;  // texels along a cube's edge
  std::vector<Ring> rings = {};
  double sigma = 0;
};
std::vector<BlurredCopy> blurredCopies();

// Two more are made by summing over the whole sphere, because no mixture of Gaussians ends at the horizon: the kernels
// of these alpha (perceptual roughness 0.8 and 1).
inline constexpr double summedAlphas[] = {0.64, 1};

// Weights of the copies, then of the two summed ones, for a layer of that alpha and size; >= 0, they sum to 1. Least
// squares over angles, errors counted by their share of the kernel (chi^2), non-negative (Lawson and Hanson 1974) by
// coordinate descent. Costs some hundred milliseconds: what programs use is a table of them (ibl/mixtures.hpp).
std::vector<double> mixtureWeights(double alpha, int layerSize);

// The same at any alpha for a cube that is looked at itself, beside the map that the copies were made of: the last
// weight is the map's, of so many texels around the equator. Lobes narrower than the copies are a little of both, and
// one of narrowestBlur is the map.
std::vector<double> backgroundWeights(double alpha, int size, int mapWidth);
// alpha that shows a tenth of a texel's light beyond its edge.
inline double narrowestBlur(int mapWidth) { return 0.5 / mapWidth; }

// How far the mixture is from the kernel.
struct MixtureError {
  double l1 = 0;    // int |mixture - kernel| dw: bounds the relative error of layers over maps without lamps
  double core = 0;  // RMS error over RMS within 4 alpha of the centre: that of a small lamp's image
};
MixtureError mixtureError(double alpha, int layerSize, const std::vector<double>& weights);
MixtureError backgroundError(double alpha, int size, int mapWidth, const std::vector<double>& weights);

// The kernel that shows a light of that angular radius [rad] under a share of a lobe: as wide as both, and far from its
// centre as bright as the whole lobe, which the rest of it does not reach.
double backgroundLightAlpha(double alpha, double share, double angularRadius);

}  // namespace facet::optics
