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

}  // namespace facet::optics
