#pragma once

#include <cstdint>
#include <vector>

namespace facet::scene {

// A .glb: the chart of learnopengl.com's "PBR: Lighting" (de Vries), red spheres under four point lights, by the
// formulas that it is written with where glTF's are others:
//   roughness 0.05, 1/7 ... 6/7 to the right, metallic 0 ... 6/7 upwards;
//   Fresnel of mix(0.04, albedo, metallic) for all of a surface, so that the diffuse share of a part metal loses by it
//   too (KHR_materials_specular: glTF's mixture loses by 0.04's alone); masking by k = (r + 1)^2 / 8
//   (FACET_materials_models); ambient light of 0.03 albedo, as emission; flux (23.47, 21.31, 20.79) of its text, where
//   its code has 300: all lengths are divided by sqrt(300 / 23.47), which is the same radiance of red.
// Its display is the tone mapper "reinhard-power", and nothing stands in its light's way. What is left: diffuse light
// loses by the lobe's albedo, not by each light's Fresnel (red, up to 4/255), its specular denominator has 0.0001 more,
// and highlights narrower than a pixel are filtered here.
std::vector<uint8_t> tutorial();

}  // namespace facet::scene
