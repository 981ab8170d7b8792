#pragma once

// The sun of an environment map, or any small lamp as bright: taken out, it is a light of its own, and the rest is a
// map whose integrals few samples get right.

#include <glm/glm.hpp>
#include <optional>

#include "scene/environment.hpp"

namespace facet::scene {

// A disc of even radiance.
struct Sun {
  glm::dvec3 direction{0, 1, 0};  // unit, towards it, in the map's frame
  double angularRadius = 0;       // radians; the disc's spread about its centre is that of what was taken out
  glm::dvec3 irradiance{0};       // on a surface that faces it: radiance times solid angle, linear Rec. 709

  double solidAngle() const;  // sr
  glm::dvec3 radiance() const { return irradiance / solidAngle(); }
  bool operator==(const Sun&) const = default;
};

// The connected texels around the brightest one, across the seam of longitudes too, where they are a sun: more than 100
// times as bright as the map's mean, on less than 1e-3 sr, and at least 1 % of all flux. A softbox is larger, the
// highlights of an overcast sky are weaker: both stay. Of several suns the brightest is found.
struct FoundSun {
  Sun sun;
  Environment rest;  // the map with the sun's texels filled from those around them
};
// Sun and rest add up to the map: its flux as texels times their solid angle under bilinear interpolation
// (optics::equirectTentSolidAngle) to 1e-6.
std::optional<FoundSun> findSun(const Environment& environment);

}  // namespace facet::scene
