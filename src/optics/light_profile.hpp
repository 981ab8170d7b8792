#pragma once

// Luminous intensity by direction as goniophotometers measure it and IES files (LM-63) hold it.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace facet::optics {

// Which axis the angles are about. Directions are the lamp's: it is aimed along -Z, its vertical photometric plane is
// XZ (EXT_lights_ies, "Coordinate System Mapping").
enum class Photometry : uint8_t {
  c,  // polar: vertical angle from -Z; azimuth: horizontal angle from +X to +Y
  a,  // polar: 90 degrees - vertical angle, from +X; azimuth: horizontal angle from -Z to -Y
  b,  // polar: 90 degrees - horizontal angle, from -Y; azimuth: vertical angle from -Z to +X
};

// A grid over polar angle [0, 180] and azimuth [degrees], both rising strictly, symmetries already unfolded. One
// azimuth: the same all round. Azimuths that span 360 degrees go all round, the last is the first again. Elsewhere
// nothing was measured, and nothing shines.
struct LightProfile {
  std::string name;
  Photometry photometry = Photometry::c;
  std::vector<float> polar, azimuth;  // at least two, at least one
  std::vector<float> candela;         // by azimuth, then polar; finite, >= 0
  float mostCandela = 0;
};

struct ProfileAngles {
  double polar = 0, azimuth = 0;  // degrees; azimuth (-180, 180]
};
ProfileAngles profileAngles(Photometry photometry, const glm::dvec3& direction);

// Bilinear in the angles; exactly the number of the grid at its points, and exactly a constant where all are alike.
// direction: from the lamp, in its own space, any length.
double candela(const LightProfile& profile, const glm::dvec3& direction);

// Luminous flux [lm]: the integral over the sphere of exactly what candela() gives.
double lumens(const LightProfile& profile);

}  // namespace facet::optics
