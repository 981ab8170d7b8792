#pragma once

// Diffuse BRDFs for albedo 1 [1/sr], without the cosine of the light. NoV, NoL in [0, 1]; perceptualRoughness in
// [0, 1]. Every one is reciprocal and finite over the whole range, its ends included. What they return of a white
// furnace (diffuseAlbedo) is measured in tests/optics/diffuse_test.cpp:
//   Lambert        1
//   Burley         0.49 (smooth) .. 1.56 (roughness 1), both at NoV -> 0
//   Frostbite      0.005 (smooth) .. 1.03 (roughness 1), both at NoV -> 0
//   Oren-Nayar     0.70 (roughness 1, NoV = 1) .. 1.015 (roughness 0.5, NoV -> 0)
//   EON            1 for albedo 1, by construction
//   Call of Duty   0.24 (smooth) .. 1.16 (roughness 1), both at NoV -> 0
// Burley's, Frostbite's and Chan's hold the loss under a smooth dielectric's interface already.

#include <glm/glm.hpp>

#include "base/choice.hpp"

namespace facet::optics {

// VoL = dot(V, L); VoH = dot(V, H) = sqrt((1 + VoL) / 2); NoH = (NoV + NoL) / (2 VoH).
struct DiffuseAngles {
  double NoV, NoL, VoL;
  double VoH() const;
  double NoH() const;  // V = -L: 0
};

// 1 / pi, so that the hemisphere returns all it gets.
double Fd_Lambert();

// Burley 2012, "Physically Based Shading at Disney", section 5.3: roughness is perceptual.
double Fd_Burley(const DiffuseAngles& angles, double perceptualRoughness);

// Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", listing 1: Burley's with f90 raised by 0.5 r and the whole
// scaled down to 1 / 1.51 at r = 1. Their linearRoughness is the perceptual one.
double Fd_Frostbite(const DiffuseAngles& angles, double perceptualRoughness);

// Oren and Nayar 1994, "Generalization of Lambert's Reflectance Model": the qualitative form (no C2, no C3, no
// interreflection). sigma is the standard deviation of the facets' angle [rad], [0, pi / 2].
double Fd_OrenNayar(const DiffuseAngles& angles, double sigma);
// Beckmann facets of the same alpha have slopes of this deviation: alpha / sqrt(2), 40.5 degrees at alpha = 1.
double sigmaOrenNayar(double perceptualRoughness);

// Portsmouth, Kutz, Hill 2024, "EON: A practical energy-preserving rough diffuse BRDF", with the exact
// albedo: Fujii's form of Oren-Nayar plus the light of further bounces. albedo (rho) in [0, 1]; r in [0, 1], taken as
// perceptualRoughness. The result includes the albedo. rho = 1: the furnace is white.
double Fd_Eon(const DiffuseAngles& angles, double r, double albedo);
// Directional albedo of its first bounce, rho = 1.
double albedoFujii(double NoX, double r);
double albedoFujiiMean(double r);  // 2 int albedoFujii mu dmu

// Chan 2018, "Material Advances in Call of Duty: WWII", the fitted diffuse BRDF with multiple scattering. alpha =
// perceptualRoughness^2 enters by g = log2(2 / alpha^2 - 1) / 18, clamped to [0, 1]: below alpha = 2.8e-3 nothing
// changes.
double Fd_CallOfDuty(const DiffuseAngles& angles, double perceptualRoughness);

enum class DiffuseModel { lambert, burley, frostbite, orenNayar, eon, callOfDuty };
// In the order of DIFFUSE_MODEL in shaders/models.glsl.
inline constexpr Choice<DiffuseModel> diffuseModels[] = {
    {DiffuseModel::lambert, "lambert", "Lambert", "glTF's"}, {DiffuseModel::burley, "burley", "Burley"},
    {DiffuseModel::frostbite, "frostbite", "Frostbite"},     {DiffuseModel::orenNayar, "oren-nayar", "Oren-Nayar"},
    {DiffuseModel::eon, "eon", "EON", "keeps energy"},       {DiffuseModel::callOfDuty, "codww2", "Call of Duty WWII"}};
static_assert(inOrder(diffuseModels));
// Any of them for albedo 1.
double diffuseBrdf(DiffuseModel model, const DiffuseAngles& angles, double perceptualRoughness);
// int f NoL dL over the hemisphere, by quadrature (about 1e-6).
double diffuseAlbedo(DiffuseModel model, double NoV, double perceptualRoughness);

}  // namespace facet::optics
