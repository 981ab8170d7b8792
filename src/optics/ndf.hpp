#pragma once

// Other distributions of normals and other shadowing terms than GGX with height-correlated Smith, for comparison.
// alpha in (0, 1] means the same for all: D(1) = 1 / (pi alpha^2). Ends as in microfacet.hpp: alpha < smallestAlpha is
// a mirror (D = 0, G = 1), a direction below the horizon sees nothing. Every D integrates to int D NoH dH = 1.

#include <functional>

#include "optics/anisotropy.hpp"
#include "optics/microfacet.hpp"

namespace facet::optics {

// Beckmann, Walter et al. 2007 eq. 25 [1/sr]. 0 for NoH <= 0. Tail: exp(-tan^2 / alpha^2).
double D_Beckmann(double NoH, double alpha);
double D_BeckmannFromSin2(double sin2NoH, double alpha);
// Blinn 1977 ("Phong" in Walter et al. 2007, eq. 30), normalised: (n + 2) / (2 pi) NoH^n with n = 2 / alpha^2 - 2.
double D_Blinn(double NoH, double alpha);
double D_BlinnFromSin2(double sin2NoH, double alpha);

// Smith's Lambda for Beckmann, Heitz 2014 eq. 66: (erf(a) - 1) / 2 + exp(-a^2) / (2 a sqrt(pi)), a = 1 / (alpha tan).
double Lambda_Beckmann(double cosine, double alpha);
double G1_Beckmann(double cosine, double alpha);
double G2_Beckmann(double NoV, double NoL, double alpha);           // height-correlated, Heitz 2014 eq. 99
double V_BeckmannCorrelated(double NoV, double NoL, double alpha);  // / (4 NoV NoL); finite unless both are 0
// With a width along x and one along y, as in anisotropy.hpp: Heitz 2014, section 5.3 (D of slopes over their widths,
// and the width in a direction's azimuth).
double D_BeckmannAnisotropic(const glm::dvec3& H, const AnisotropicAlpha& alpha);
double V_BeckmannAnisotropic(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha);
// Walter et al. 2007 eq. 27: a rational function of a, 1 from a = 1.6 on. Error against G1_Beckmann: 3.1e-3 at most.
double G1_BeckmannRational(double cosine, double alpha);
double V_BeckmannRational(double NoV, double NoL, double alpha);  // product of both over 4 NoV NoL; finite at 0
// Blinn's has no closed form; Walter et al. take this one for it, too: off by 0.0025 (alpha 0.1), 0.038 (0.5),
// 0.22 (1, where Blinn's normals are all alike). Exact by quadrature: G1_Smith.

// GTR, Burley 2012, appendix B.2: c / (1 + (alpha^2 - 1) NoH^2)^exponent; exponent > 0: 2 is GGX, less has longer
// tails. D(1) is not 1 / (pi alpha^2) unless it is 2.
double D_GTR(double NoH, double alpha, double exponent);

// Smith's G1 of any isotropic distribution D(sin^2): NoV / int max(VoH, 0) D dH (Heitz 2014 eq. 12: what is visible
// adds up to the projected area), by quadrature to about 1e-6. NoV > 0.
double G1_Smith(const std::function<double(double sin2NoH)>& D, double alpha, double NoV);

// Schlick 1994 for Smith's G1 of GGX with k = alpha / 2 (Karis 2013, without his remapping for lights):
// NoX / (NoX (1 - k) + k). Error against G1_GGX: 0.16 at most, for narrow lobes near the horizon; none at alpha = 1.
// alpha = 0: 1.
double G1_SchlickGGX(double cosine, double alpha);
// Product of both over 4 NoV NoL. Finite for alpha > 0.
double V_SchlickGGX(double NoV, double NoL, double alpha);

// The same with k = (r + 1)^2 / 8, r the perceptual roughness: "to reduce hotness" of lights (Karis 2013, eq. 4; r + 1
// halved is Disney's). alpha = 0: k = 1/8, so that mirrors lose light too.
double V_SchlickRemapped(double NoV, double NoL, double alpha);

// V-cavities, Cook and Torrance 1982 eq. in section "The geometrical attenuation factor": min(1, 2 NoH NoV / VoH,
// 2 NoH NoL / VoH), independent of alpha.
double G_Cavity(const Angles& angles);
// Over 4 NoV NoL: min(1 / (4 NoV NoL), NoH / (2 VoH max(NoV, NoL))). Grows without bound only at NoV = NoL = 0.
double V_Cavity(const Angles& angles);

}  // namespace facet::optics
