#pragma once

// Metals and dielectrics by name, each with its source. Metals: complex index of refraction at three wavelengths that
// stand for red, green and blue, and F at normal incidence from it (F_Conductor), taken as linear Rec. 709. That is no
// spectral integration: against published Rec. 709 values (Lagarde 2011, "Feeding a physically based shading model")
// F differs by up to 0.10 (titanium), mostly by the choice of measurements (tests/optics/presets_test.cpp).

#include <glm/glm.hpp>
#include <span>
#include <string_view>

namespace facet::optics {

struct MetalPreset {
  std::string_view name;
  glm::dvec3 wavelengthNm;  // red, green, blue
  glm::dvec3 eta, k;        // index of refraction eta + i k
  std::string_view source;
  glm::dvec3 f0() const;   // base colour of a metal
  glm::dvec3 f82() const;  // at cosine 1 / 7, for F_82Tint
};

struct DielectricPreset {
  std::string_view name;
  double ior;   // at 587.6 nm (d) or 589.3 nm (D)
  double abbe;  // Abbe number V_d; 0: not given
  std::string_view source;
  double f0() const;          // ((ior - 1) / (ior + 1))^2
  double dispersion() const;  // KHR_materials_dispersion: 20 / abbe; 0 where not given
};

std::span<const MetalPreset> metalPresets();
std::span<const DielectricPreset> dielectricPresets();

// nullptr: no such name. Names are lower case.
const MetalPreset* findMetal(std::string_view name);
const DielectricPreset* findDielectric(std::string_view name);

}  // namespace facet::optics
