#pragma once

// Punctual lights, KHR_lights_punctual: how intensity [cd] or illuminance [lx] arrives at a point.

namespace facet::optics {

// Distances below this [m] act as this, so that the inverse square is bounded by 1e12: finite in single precision with
// any intensity below 3e26 cd, and small enough not to be seen in scenes of a micrometre.
inline constexpr double smallestLightDistance = 1e-6;

// Irradiance per intensity [1/m^2] at normal incidence: max(min(1 - (d / range)^4, 1), 0) / d^2.
// range <= 0 (absent in the file) or infinite: plain inverse square. d = 0: 1 / smallestLightDistance^2.
// d >= range: exactly 0. d infinite: 0.
double distanceAttenuation(double distance, double range);

// Spot cone, the extension's "Inner and Outer Cone Angles": 1 inside innerCone, 0 outside outerCone, the square of a
// straight line in the cosine between. Angles [rad] from the axis, 0 <= inner < outer <= pi / 2; the two cosines count
// as at least 0.001 apart. cosAngle = dot(spot direction, direction light -> point), both unit.
double spotAttenuation(double cosAngle, double innerCone, double outerCone);

// Width of a GGX lobe that reflects a disc of that angular radius [rad] in the place of a point of the same irradiance:
// alpha'^2 = alpha^2 + (radius / 2)^2. At the highlight's peak it is exact for a mirror, where the disc itself is seen
// (D(0) / 4 = 1 / (pi radius^2)), and for lobes much wider than the disc; the energy is the lobe's at any width.
double alphaOfDisc(double alpha, double angularRadius);

// The angle from its axis and the azimuth of a point of the unit square in a disc of that angular radius: equal shares
// of its area, radius [rad] << 1.
struct DiscPoint {
  double theta = 0, phi = 0;
};
DiscPoint pointInDisc(double angularRadius, double u, double v);

}  // namespace facet::optics
