#pragma once

// How much a GGX surface reflects in all (directional albedo), and what the single-scattering model loses.
//
// Fdez-Aguera 2019, "A Multiple-Scattering Microfacet Model for Real-Time Image Based Lighting" (JCGT 8(1));
// Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks"; Turquin 2019, "Practical multiple
// scattering compensation for microfacet models".

#include <cstdint>
#include <glm/glm.hpp>

#include "base/choice.hpp"

namespace facet::optics {

// With Schlick's F = f0 (1 - Fc) + f90 Fc, Fc = (1 - VoH)^5:
//   A = int D V (1 - Fc) NoL dL,   B = int D V Fc NoL dL   (V including 1 / (4 NoV NoL)).
// Directional albedo of single scattering: f0 A + f90 B; for F = 1: E = A + B.
struct Dfg {
  double A = 0, B = 0;
};

// The integral by adaptive Gauss-Legendre to the given absolute tolerance (measured error by default <= 5e-8, see
// the tests; documented bound 1e-5). NoV in [0, 1] (NoV <= 0 is the limit from above), alpha in [0, 1].
// alpha = 0 in closed form: A = 1 - (1 - NoV)^5, B = (1 - NoV)^5. Check at alpha = 1: A + B = 1 - NoV ln(1 + 1 / NoV).
Dfg integrateDfg(double NoV, double alpha, double tolerance = 1e-9);

// Where the lobe looks on average: with m = int L D V NoL dL (F = 1), the sine of the angle from N to m, positive on
// the side that faces away from V. alpha = 0: sqrt(1 - NoV^2), the mirror direction. alpha = 1: 0, because D V NoL =
// NoL / (2 pi (NoL + NoV)) there, which is symmetric about N. NoV = 1: 0. Domain and accuracy as above.
double meanDirectionSine(double NoV, double alpha, double tolerance = 1e-9);

// Weights of image-based light. Furnace: single + multiple + diffuse = 1 per channel (white albedo).
struct SpecularEnergy {
  glm::dvec3 single;    // times the prefiltered radiance LD
  glm::dvec3 multiple;  // times irradiance / pi
  glm::dvec3 diffuse;   // times albedo and irradiance / pi: what the specular lobe leaves, kD
};
// Fdez-Aguera 2019, with F0 itself as the single-scattering reflectance (not the roughness-dependent kS of its listing,
// which has no counterpart in the integral). f0 = 1: single + multiple = 1 exactly.
SpecularEnergy energyFdezAguera(const Dfg& dfg, const glm::dvec3& f0, double f90 = 1);

// Turquin 2019, eq. 16: the single-scattering lobe scaled by 1 + f0 (1 / E - 1). 1 where E = 1.
glm::dvec3 compensationTurquin(const Dfg& dfg, const glm::dvec3& f0);

// 1 - 2 int E mu dmu, F = 1: of all light, what a rough white surface loses. By quadrature (about 1e-6 of the value),
// alpha in [1e-3, 1]; alpha = 1: 4/3 (1 - ln 2) less than 1. The fit is off by 1.3e-4 of the value, held below 1e-3.
double missingOnAverage(double alpha);
double missingOnAverageFit(double alpha);

// ---- The models side by side ----------------------------------------------------------------------------------------

// A surface's lobe is g D V F + m s(L) / pi, g its gain and m the albedo at V of further bounces, with s spread so that
// int s NoL dL = pi. The base gets 1 - (g (f0 A + f90 B) + m). Distant light: LD with g (f0 A + f90 B), irradiance / pi
// with m.
//   none        g = 1, m = 0
//   fdezAguera  m = energyFdezAguera's, s = 1: its authors meant distant light; for lights the same, a flat lobe
//   kullaConty  m = Fms (1 - E(V)), s = (1 - E(L)) / (1 - Eavg): reciprocal; of distant light the irradiance stands for
//               the second
//   turquin     g = compensationTurquin, m = 0
//   automatic   fdezAguera for distant light, turquin for lights
// f0 = f90 = 1: g E + m = 1 but for none. The order is that of shaders/energy.glsl.
enum class EnergyModel : uint8_t { automatic, none, fdezAguera, kullaConty, turquin };
inline constexpr Choice<EnergyModel> energyModels[] = {
    {EnergyModel::automatic, "auto", "automatic",
     "fdez-aguera for the environment, turquin for lights; above 4 samples kulla-conty"},
    {EnergyModel::none, "none", "single scattering",
     "one bounce: a rough white metal returns as little as 31 % of what it gets"},
    {EnergyModel::fdezAguera, "fdez-aguera", "Fdez-Aguera", "what is missing leaves evenly to all sides"},
    {EnergyModel::kullaConty, "kulla-conty", "Kulla and Conty",
     "reciprocal; what is missing leaves as it came, by the albedo's complement"},
    {EnergyModel::turquin, "turquin", "Turquin", "the lobe itself is made brighter"}};
static_assert(inOrder(energyModels));
EnergyModel distantEnergy(EnergyModel chosen);
EnergyModel lightEnergy(EnergyModel chosen);

struct Compensation {
  glm::dvec3 gain{1}, multiple{0};
};
// model: not automatic.
Compensation compensationOf(EnergyModel model, const Dfg& dfg, double alpha, const glm::dvec3& f0, double f90 = 1);
// g (f0 A + f90 B) + m.
glm::dvec3 specularAlbedo(EnergyModel model, const Dfg& dfg, double alpha, const glm::dvec3& f0, double f90 = 1);
// s at L. Of Kulla and Conty's, what 1 - Eavg lacks to 0.011 (below roughness 0.24) is a flat lobe: half floats do not
// hold so little well.
double multipleShape(EnergyModel model, double albedoL, double alpha);

}  // namespace facet::optics
