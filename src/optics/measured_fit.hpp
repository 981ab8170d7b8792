#pragma once

// The analytic model that comes closest to a measured BRDF: GGX, or another lobe, with Schlick's Fresnel term over a
// diffuse model.
//
// Ngan, Durand, Matusik 2005, "Experimental Analysis of BRDF Models"; Loew, Kronander, Ynnerman, Unger 2012, "BRDF
// Models for Accurate and Efficient Rendering of Glossy Surfaces" (TOG 31(1)).

#include <array>
#include <iterator>
#include <string>
#include <vector>

#include "optics/analytic_brdf.hpp"
#include "optics/measured.hpp"
#include "optics/measured_proxy.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

// Errors are root mean squares, over samples and channels, of c(f NoL) - c(f' NoL): the cosine as in Ngan et al., c so
// that a highlight does not outweigh all else.
enum class FitMetric : uint8_t {
  log,       // ln(1 + x), Loew et al. eq. 13
  cubeRoot,  // x^(1/3), x counted from 1e-6 up
};

struct FitSample {
  Angles angles;
  glm::dvec3 V, L, value;
  double VoL;
  double pairs;  // the measure of the pairs of directions that it stands for, up to a common factor
};
// Every third theta_h, fourth theta_d and twelfth phi_d of MERL's cells, at their centres, so that the highlight gets
// the share that the database gives it; of UTIA's entries every eighth azimuth of L and second of V. Both directions at
// most 75 degrees from the normal: beyond that the databases hold extrapolated values. Without cells that are missing
// or guessed.
std::vector<FitSample> fitSamples(const MeasuredBrdf& brdf);

// Root mean square, without the term for the energy.
double fitError(const AnalyticBrdf& model, const std::vector<FitSample>& samples, FitMetric metric);

// Directional albedo, linear RGB, at polar angles of V [degrees] that databases have measured.
inline constexpr double fitAlbedoAngles[] = {0, 15, 30, 45, 60, 75};
struct FitAlbedo {
  glm::dvec3 table{0}, model{0};
  double off() const;  // the largest |model - table| / max(table, 0.01) over the channels
};
inline constexpr double toldAlbedoError = 0.05;  // from which on one is warned

struct BrdfFit {
  AnalyticBrdf model;
  double error = 0;   // in the metric of the fit
  double misfit = 0;  // root of what was made least: the error with the term for the energy
  std::array<FitAlbedo, std::size(fitAlbedoAngles)> albedo = {};
  // The largest of their off(), and its angle.
  double albedoError = 0, albedoErrorAngle = 0;
};
// What is least is the mean square error in the metric plus, so that no fit reflects twice what its table does, the
// mean square of the relative error of what is reflected of five rings of 15 degrees, per channel. Without that term a
// metric of compressed values puts up with any energy: a Ward table's blue got an albedo of 0.28 for 0.14. f0 and
// albedo per channel, within [0, 1], by Gauss-Newton steps for each roughness that a downhill simplex (Nelder and Mead
// 1965) tries; alpha in [1e-4, 1]; MERL isotropic, UTIA both alphas and their azimuth (GTR one), starting at the proxy;
// what a shape has of its own besides. Of a synthetic table of GGX the parameters come back within
// 1e-3, of other shapes within 1 % (two alphas: 2 %). Less than a second each.
BrdfFit fitAnalytic(const MeasuredBrdf& brdf, const std::vector<FitSample>& samples, const MeasuredProxy& proxy,
                    DiffuseModel diffuse, FitMetric metric, LobeShape shape = LobeShape::ggx);
inline constexpr double leastExponent = 0.2, mostExponent = 20;  // of GTR that are tried
// All diffuse models with GGX, in the enumeration's order.
std::vector<BrdfFit> fitAll(const MeasuredBrdf& brdf, FitMetric metric);
// All shapes of the lobe, in the enumeration's order, over the diffuse model of a fit with GGX, which is the first.
std::vector<BrdfFit> fitShapes(const MeasuredBrdf& brdf, const BrdfFit& ggx, FitMetric metric);
// Those whose misfit is the least but for what two fits of the same function differ by: 1 % of it, or 3e-5. Of fits at
// least one; of a table without diffuse light all.
std::vector<bool> bestFits(const std::vector<BrdfFit>& fits);
// "its albedo is off by 38 % at 75 degrees", where that is from toldAlbedoError on; else empty.
std::string albedoRemark(const BrdfFit& fit);

// KHR_materials_anisotropy's strength of a pair of alphas: alpha.t = mix(alpha.b, 1, strength^2); t >= b.
double anisotropyStrength(const AnisotropicAlpha& alpha);

}  // namespace facet::optics
