#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace facet::compare {

// Difference that one sees when two pictures alternate in place, [0, 1] a pixel: Andersson, Nilsson, Akenine-Möller,
// Oskarsson, Åström, Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images". Written from the paper:
// what the eye cannot resolve is filtered out (section 4.1), the rest is a colour difference (4.1.2) that differences
// of edges and points (4.2) raise (4.3). Symmetric in the pictures.

// Of a screen 0.7 m wide and 3840 pixels across, seen from 0.7 m: the paper's.
inline constexpr double flipPixelsPerDegree = 3840 * 3.14159265358979323846 / 180;

// A difference of HyAB 2.3, the just noticeable one of CIELAB (Mahy, Van Eycken, Oosterlinck 1994), comes out as 0.103.
inline constexpr double flipJustNoticeable = 0.1;

// Colours are linear Rec. 709 and clamped to [0, 1]; row by row. Pixels beyond the border are those at it.
std::vector<float> flipMap(std::span<const glm::dvec3> reference, std::span<const glm::dvec3> picture, int width,
                           int height, double pixelsPerDegree = flipPixelsPerDegree);

// The pieces, for tests.

// Weights from -radius to radius around the middle; sums as said.
struct FlipKernels {
  // Contrast sensitivity: each channel of YCxCz is a weighted sum of Gaussians, each applied along x, then y.
  struct Gaussian {
    double share = 0;             // the shares of a channel sum to 1
    std::vector<double> weights;  // sum to 1
  };
  std::vector<Gaussian> achromatic, redGreen, blueYellow;
  // Features: first and second derivative along one axis, the Gaussian along the other.
  std::vector<double> smooth;       // sums to 1
  std::vector<double> edge, point;  // positive ones sum to 1, negative ones to -1
};
FlipKernels flipKernels(double pixelsPerDegree);

glm::dvec3 ycxczFromLinear(const glm::dvec3& linear);  // linearised CIELAB: 116 Y - 16, 500 (X - Y), 200 (Y - Z)
glm::dvec3 linearFromYcxcz(const glm::dvec3& ycxcz);
glm::dvec3 labFromLinear(const glm::dvec3& linear);  // white is (100, 0, 0)

// Difference of two filtered colours, [0, 1]: HyAB of Hunt-adjusted CIELAB to the power 0.7; of its range the first 0.4
// become [0, 0.95].
double flipColorDifference(const glm::dvec3& a, const glm::dvec3& b);

}  // namespace facet::compare
