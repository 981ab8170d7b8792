#pragma once

// Databases made from formulas, so that what reads, looks up, draws or fits them can be held against the formula.

#include <span>
#include <string_view>

#include "optics/anisotropy.hpp"
#include "optics/diffuse.hpp"
#include "optics/measured.hpp"

namespace facet::optics {

// GGX with Schlick's Fresnel term (f90 = 1 unless f0 is black) over a diffuse model: D V F + albedo Fd [1/sr].
struct AnalyticBrdf {
  glm::dvec3 f0{0.04};
  glm::dvec3 albedo{0};
  AnisotropicAlpha alpha;
  double phi = 0;  // of the direction of alpha.t, from the tangent [rad]
  DiffuseModel diffuse = DiffuseModel::lambert;
};
// perceptualRoughness = alpha^(1/2), of the geometric mean: what the diffuse models take.
double roughnessOf(const AnalyticBrdf& brdf);
glm::dvec3 analyticBrdf(const AnalyticBrdf& brdf, const glm::dvec3& V, const glm::dvec3& L);

struct SyntheticBrdf {
  std::string_view name, summary;
  MeasuredKind kind;
  AnalyticBrdf formula;
};
std::span<const SyntheticBrdf> syntheticBrdfs();
const SyntheticBrdf* findSynthetic(std::string_view name);  // nullptr: no such name

// MERL (the formula must be isotropic): of each cell its centre; where that is below the horizon the mean over 5^3
// points of the cell that are above it, and missing where none is. UTIA: the entries. About 0.1 s.
MeasuredBrdf makeMeasured(const AnalyticBrdf& formula, MeasuredKind kind, std::string_view name);

}  // namespace facet::optics
