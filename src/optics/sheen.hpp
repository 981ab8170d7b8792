#pragma once

// Cloth: the lobe of KHR_materials_sheen. Estevez and Kulla 2017, "Production Friendly Microfacet Sheen BRDF".
// alpha = sheenRoughness^2 (perceptual, KHR_materials_sheen), counted from smallestSheenAlpha up: below, the lobe is a
// ring at the horizon that nothing resolves. Cosines in [0, 1].

namespace facet::optics {

inline constexpr double smallestSheenAlpha = 1e-3;

// "Charlie" [1/sr]: (2 + 1/alpha) sin^(1/alpha) / (2 pi). 0 along the normal. Integrates to int D NoH dH = 1.
double D_Charlie(double NoH, double alpha);

// The paper's fit of Smith's Lambda for it: exp(L(cos)) below cosine 0.5, exp(2 L(0.5) - L(1 - cos)) above, L's
// five numbers interpolated by (1 - alpha)^2. As KHR_materials_sheen has it: without the paper's softening of the
// terminator. G1 from it against the exact one (visible area) is off by 0.007 at alpha = 1, 0.036 at 0.36, 0.09 at
// 0.05, 0.33 at 0.01: the narrower, the more it lets through.
double Lambda_Charlie(double cosine, double alpha);
// 1 / (4 NoV NoL (1 + Lambda(V) + Lambda(L))), cosines counted from 1e-4 up. KHR_materials_sheen's choice.
double V_Charlie(double NoV, double NoL, double alpha);
// Ashikhmin and Premoze 2007, "Distribution-based BRDFs": 1 / (4 (NoL + NoV - NoL NoV)); the cheap alternative that the
// extension mentions. Smooth at the horizon, infinite only if both cosines are 0 (counted from 1e-4 up).
double V_Ashikhmin(double NoV, double NoL);

// E = int D V NoL dL for sheen colour 1, by quadrature (about 1e-5): what the table holds. Because of that fit it
// exceeds 1 near the horizon for sheenRoughness < 0.26 (alpha < 0.068): 1.07 at alpha = 0.05, 1.9 at 0.01, 4.0 at
// 0.0025.
double sheenAlbedo(double NoV, double alpha);

// What is left for the layers below, KHR_materials_sheen: 1 - max(sheenColor) E, the smaller of that at V and at L (the
// result is reciprocal and never gains); for distant light E at V alone. E in [0, 1].
double sheenScaling(double maxSheenColor, double albedoV, double albedoL);

// Factor on the lobe that takes the gain away where E exceeds 1, 1 / max(1, E(V), E(L)): reciprocal; the scaled lobe's
// albedo is 1 at most, and min(1, E) is a bound of it that sheenScaling may use. 1 where E <= 1.
double sheenGainGuard(double albedoV, double albedoL);

}  // namespace facet::optics
