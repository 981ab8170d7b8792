#pragma once

// Measured BRDFs as tables, and look-ups in them: the reference, in double precision.
//
// MERL: Matusik, Pfister, Brand, McMillan 2003, "A Data-Driven Reflectance Model", in the half and difference angles of
// Rusinkiewicz 1998, "A New Change of Variables for Efficient BRDF Representation". Isotropic.
// UTIA: Filip and Vavra 2014, "Template-Based Sampling of Anisotropic BRDFs". Anisotropic.
//
// Directions are unit vectors that leave the surface, in tangent space: x along the tangent (where UTIA's azimuths
// begin), z along the normal. L goes to the light. What a look-up returns is f_r [1/sr], linear RGB, without a cosine:
// finite and never negative, 0 where V or L is not above the horizon.

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "base/choice.hpp"

namespace facet::optics {

enum class MeasuredKind : uint8_t { merl, utia };

inline constexpr int merlThetaSteps = 90;  // of theta_h (by its square root) and of theta_d
inline constexpr int merlPhiSteps = 180;   // of phi_d over [0, pi); another variant has 360 over [0, 2 pi)
inline constexpr int utiaThetaSteps = 6;   // 0, 15 .. 75 degrees
inline constexpr int utiaPhiSteps = 48;    // 0, 7.5 .. 352.5 degrees
inline constexpr int utiaDirections = utiaThetaSteps * utiaPhiSteps;
inline constexpr double utiaLastTheta = 75;  // [degrees]

// What a table stores where nothing was measured. A cell is valid where its first channel is not negative.
inline constexpr float missingValue = -1;
// The largest f_r [1/sr] that is taken for one: what pictures' cells hold (a mirror of alpha 1e-5 has 8e8).
inline constexpr double largestMeasured = 65504 * 32768.0;

// Cells that were stored as missing, each counted once, by the first of these that one of its channels is.
struct MeasuredCounts {
  size_t notANumber = 0, infinite = 0, tooLarge = 0, negative = 0;  // too large: finite, above largestMeasured
  size_t missing() const { return notANumber + infinite + tooLarge + negative; }
};

// Values that were never measured: what became of the missing cells (measured_holes.hpp).
struct MeasuredGuess {
  size_t belowHorizon = 0;   // stay missing: no pair of directions above the horizon lies in them
  size_t acrossHorizon = 0;  // reach above it, their centres don't: hold their neighbours' values, no holes
  size_t reciprocal = 0;     // holes: got the value of the pair with V and L exchanged,
  size_t between = 0;        // one between their neighbours on both sides,
  size_t continued = 0;      // or that of the nearest ones
  double energy = 0;         // share of what the table reflects of light from everywhere, luminance: that of the holes
  std::vector<uint32_t> cells;  // the holes, ascending
  size_t holes() const { return cells.size(); }
};

struct MeasuredBrdf {
  std::string name;
  MeasuredKind kind = MeasuredKind::merl;
  int phiSteps = merlPhiSteps;  // MERL: of phi_d, 180 or 360
  // f_r [1/sr], linear RGB; missing cells are (-1, -1, -1). In single precision: off by 6e-8 of the file's values.
  // MERL: [theta_h][theta_d][phi_d], the last is the fastest. UTIA: [theta_L][phi_L][theta_V][phi_V].
  std::vector<glm::vec3> values;
  MeasuredCounts counts;
  MeasuredGuess guess = {};
};

size_t cellsOf(MeasuredKind kind, int phiSteps = merlPhiSteps);

// Rusinkiewicz' angles [rad]: theta_h, theta_d in [0, pi / 2] above the horizon, phi_d in [0, 2 pi): exchanging V and L
// adds pi. By atan2 of differences, so that they are good to about 1e-15 also where V and L are close and at grazing
// angles. theta_h = 0 or theta_d = 0 leaves phi_d undefined: 0. L = -V: theta_h 0, theta_d pi / 2.
struct HalfDifference {
  double thetaH = 0, thetaD = 0, phiD = 0;
};
HalfDifference halfDifference(const glm::dvec3& V, const glm::dvec3& L);
// The pair with those angles whose half vector lies at azimuth 0. V or L may come out below the horizon.
struct Directions {
  glm::dvec3 V{0, 0, 1}, L{0, 0, 1};
};
Directions directionsFrom(const HalfDifference& angles);

// Where a pair lies in the grid, in cells. MERL: x = 90 sqrt(theta_h / (pi / 2)), y = 90 theta_d / (pi / 2), z = 180
// phi_d / pi modulo phiSteps (180: phi_d + pi is the same by reciprocity); cell k reaches from k to k + 1.
glm::dvec3 merlPosition(const HalfDifference& angles, int phiSteps);
HalfDifference merlAngles(const glm::dvec3& position);
// UTIA: x = theta / 15 degrees, y = phi / 7.5 degrees in [0, 48); entry k was measured at k. Along the normal phi is 0.
glm::dvec2 utiaPosition(const glm::dvec3& direction);
glm::dvec3 utiaDirection(const glm::dvec2& position);

// What a cell's pairs of directions count in integrals over both hemispheres, int NoV NoL dV dL, up to a factor that is
// the grid's. MERL: 4 cos(theta_d) sin(theta_d) sin(theta_h) d(theta_d) d(theta_h) d(phi_d) d(phi_h) at the centre,
// d(theta_h) ~ x, without NoV NoL. UTIA, of a direction: int cos over the ring of 15 degrees around an entry, half of
// one at the normal, all that is left at the last.
double merlPairs(int x, int y);
double utiaProjected(int theta);

enum class LookUp : uint8_t {
  nearest,       // MERL: the cell that the pair lies in, as the database's own code has it; UTIA: the nearest entry
  interpolated,  // MERL: trilinear between the centres of cells; UTIA: quadrilinear
};
inline constexpr Choice<LookUp> lookUps[] = {
    {LookUp::nearest, "nearest", "nearest", "the cell that a pair of directions lies in"},
    {LookUp::interpolated, "interpolated", "interpolated", "between the cells"}};
static_assert(inOrder(lookUps));
// Both hold the outermost value beyond the grid: MERL the first and last half cell of theta_h and theta_d, UTIA theta
// above 75 degrees, where nothing was measured. Azimuths wrap. Missing cells weigh nothing, what remains is
// renormalised; where all are missing the result is 0.
glm::dvec3 measuredBrdf(const MeasuredBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L, LookUp lookUp);

}  // namespace facet::optics
