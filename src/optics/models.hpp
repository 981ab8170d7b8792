#pragma once

// Which formulas a surface is evaluated with, where there is a choice. The defaults are those of glTF 2.0, appendix B.

#include <cstdint>
#include <glm/glm.hpp>

#include "base/choice.hpp"
#include "optics/diffuse.hpp"
#include "optics/energy.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

// The order of each is that of shaders/models.glsl.
enum class FresnelModel : uint8_t { schlick, exact, f82Tint };
enum class NormalDistribution : uint8_t { ggx, beckmann, blinn };
enum class Masking : uint8_t { smith, approximate, cavity, remapped };

// Where the look-ups of the environment's prefiltered radiance go for a specular lobe (shaders/image_light_*.glsl):
//   mirror   at the mirror direction, with the lobe of N = V = R (Karis 2013)
//   shifted  from there towards N, by (1 - alpha) (sqrt(1 - alpha) + alpha) (Lagarde and de Rousiers 2014)
//   mean     at the lobe's mean direction
//   taps1 .. taps3  at as many fitted directions and roughnesses in the plane of N and V
//   sampled  none: the environment itself is sampled
//   automatic  usualLookUp up to 4 samples a pixel, sampled above
enum class ImageLight : uint8_t { automatic, mirror, shifted, mean, taps1, taps2, taps3, sampled };
inline constexpr ImageLight usualLookUp = ImageLight::taps3;
constexpr int tapsOf(ImageLight model) {
  return model < ImageLight::taps1 || model > ImageLight::taps3 ? 0 : static_cast<int>(model) - 3;
}

inline constexpr Choice<FresnelModel> fresnelModels[] = {
    {FresnelModel::schlick, "schlick", "Schlick", "glTF's"},
    {FresnelModel::exact, "exact", "exact Fresnel", "dielectrics, and metals whose complex index is known"},
    {FresnelModel::f82Tint, "f82", "F82-tint", "metals whose complex index is known"}};
inline constexpr Choice<NormalDistribution> distributions[] = {{NormalDistribution::ggx, "ggx", "GGX", "glTF's"},
                                                               {NormalDistribution::beckmann, "beckmann", "Beckmann"},
                                                               {NormalDistribution::blinn, "blinn", "Blinn"}};
inline constexpr Choice<Masking> maskings[] = {
    {Masking::smith, "smith", "Smith", "glTF's"},
    {Masking::approximate, "approximate", "approximate masking"},
    {Masking::cavity, "v-cavity", "V-cavities"},
    {Masking::remapped, "remapped", "remapped masking", "k = (r + 1)² / 8, of tutorials; the horizon reflects less"}};
inline constexpr Choice<ImageLight> imageLights[] = {
    {ImageLight::automatic, "auto", "automatic", "taps3; above 4 samples sampled"},
    {ImageLight::mirror, "mirror", "mirror direction", "the usual split sum: N = V = R"},
    {ImageLight::shifted, "shifted", "shifted direction", "UE4's and Frostbite's"},
    {ImageLight::mean, "mean", "mean direction", "where the lobe looks on average"},
    {ImageLight::taps1, "taps1", "1 fitted tap"},
    {ImageLight::taps2, "taps2", "2 fitted taps"},
    {ImageLight::taps3, "taps3", "3 fitted taps"},
    {ImageLight::sampled, "sampled", "sampled", "the integral itself, at each pixel"}};
static_assert(inOrder(fresnelModels) && inOrder(distributions) && inOrder(maskings) && inOrder(imageLights));

struct Models {
  DiffuseModel diffuse = DiffuseModel::lambert;
  FresnelModel fresnel = FresnelModel::schlick;
  NormalDistribution distribution = NormalDistribution::ggx;
  Masking masking = Masking::smith;
  ImageLight imageLight = ImageLight::automatic;
  EnergyModel energy = EnergyModel::automatic;
  bool operator==(const Models&) const = default;
};

// A metal whose index of refraction is known: eta + i k per channel.
struct Conductor {
  glm::dvec3 eta, k;
};

double distributionOf(NormalDistribution distribution, const Angles& angles, double alpha);  // [1/sr]

// G2 / (4 NoV NoL).
//   smith        GGX and Beckmann: height-correlated, exact. Blinn has no closed form: as `approximate`.
//   approximate  GGX: Schlick's; Beckmann and Blinn: Walter's rational function; the two directions' product.
//   cavity       V-cavities, for any distribution.
//   remapped     Schlick's with Karis' k for lights, for any distribution.
double visibilityOf(NormalDistribution distribution, Masking masking, const Angles& angles, double alpha);

// A and B of the lobe (energy.hpp: integrateDfg is GGX with Smith's term), by adaptive quadrature: about 1e-6,
// V-cavities, which have kinks, 1e-5. alpha >= 0.01, NoV > 0. And their sum, the albedo where every facet reflects all
// (F = 1).
Dfg lobeDfg(NormalDistribution distribution, Masking masking, double NoV, double alpha);
double lobeAlbedo(NormalDistribution distribution, Masking masking, double NoV, double alpha);

// Of a dielectric of reflectance f0 at normal incidence and f90 at the horizon (the weight of KHR_materials_specular).
// exact: f90 times Fresnel's equations for the index that f0 / f90 belongs to. f82Tint: Schlick.
glm::dvec3 fresnelDielectric(FresnelModel model, double VoH, const glm::dvec3& f0, double f90);
// Of a metal of that f0. exact, f82Tint: of the conductor, times f0 over the conductor's own, at most 1; without one
// Schlick.
glm::dvec3 fresnelMetal(FresnelModel model, double VoH, const glm::dvec3& f0, const Conductor* conductor);

// Diffuse BRDF times albedo [1/sr], without the cosine; Eon's colour deepens with each bounce.
glm::dvec3 diffuseTerm(DiffuseModel model, const DiffuseAngles& angles, double perceptualRoughness,
                       const glm::dvec3& albedo);
// What it returns of a white furnace: int f NoL dL, by quadrature (about 1e-6); of Eon in closed form.
glm::dvec3 diffuseReturned(DiffuseModel model, double NoV, double perceptualRoughness, const glm::dvec3& albedo);

}  // namespace facet::optics
