#pragma once

// A thin film on a base: KHR_materials_iridescence, after Belcour and Barla 2017, "A Practical Extension to Microfacet
// Theory for the Modeling of Varying Iridescence", with Schlick's Fresnel terms as the extension has it.

#include <glm/glm.hpp>

namespace facet::optics {

// F of the film-covered base per channel of linear Rec. 709, in [0, inf): saturated colours leave [0, 1] a little.
// outsideIor >= 1 (air: 1), filmIor >= 1, thicknessNm >= 0 [nm]; baseF0 in [0, 1] in air; cosine = VoH in [0, 1].
// Total reflection inside (filmIor < outsideIor): 1. Optical path above 1e5 nm counts as that: the interference has
// faded there, exp(-1700). thicknessNm -> 0: the film's index goes to the outside's (smoothstep over 0 .. 0.03 nm).
// Error against F_ThinFilmSpectral (films of index 1.1 .. 2.2, 50 .. 1000 nm), largest of the channels: facing (cosine
// 1) 0.042, mean 0.008 at baseF0 = 0.04, 0.077, mean 0.020 at 0.8; at cosine 0.6 0.11; at 0.2 0.26 .. 0.47: Schlick's
// curve stands for an interface of two indices that may be all but equal, and the grazing reflection is counted twice.
// For the same reason no film at all (thickness 0) is off from the base by 0.007 facing and 0.42 at cosine 0.2.
glm::dvec3 F_Iridescence(double cosine, double outsideIor, double filmIor, double thicknessNm,
                         const glm::dvec3& baseF0);

// The same series with the exact Fresnel terms of both polarisations apart, as Belcour and Barla's own, and with
// sensitivities normalised to white. thicknessNm -> 0: the exact dielectric of index iorFromF0(baseF0). Error against
// F_ThinFilmSpectral (as above): 0.019 facing, 0.014 at cosine 0.2 for baseF0 = 0.04; 0.028 for 0.3; for 0.8 0.035
// facing, 0.166 at cosine 0.2 (higher orders). A metal's f0 counts as a real index in both. baseF0 counts up to 0.9999.
// cosine 0: 1.
glm::dvec3 F_ThinFilm(double cosine, double outsideIor, double filmIor, double thicknessNm, const glm::dvec3& baseF0);

// Gaussians of the paper's section 5: XYZ of cos(2 pi OPD / lambda + shift), to linear Rec. 709. opticalPathNm [nm].
glm::dvec3 interferenceColor(double opticalPathNm, const glm::dvec3& shift);

// The f0 for which Schlick's curve with f90 = 1 gives F at this cosine; clamped to [0, 1]. cosine -> 0: 0.
glm::dvec3 f0FromSchlick(const glm::dvec3& F, double cosine);

// The truth by brute force: Airy's sum of all orders for both polarisations (Born and Wolf 1999, 7.6) per wavelength,
// CIE 1931 by the fit of Wyman et al. 2013 (multi-lobe), 380 .. 780 nm each `stepNm`, weighted so that a reflectance of
// 1 is (1, 1, 1). baseIor: behind the film, real.
glm::dvec3 F_ThinFilmSpectral(double cosine, double outsideIor, double filmIor, double thicknessNm,
                              const glm::dvec3& baseIor, double stepNm = 1);
// Reflectance of the film at one wavelength, in [0, 1].
double F_Airy(double cosine, double outsideIor, double filmIor, double thicknessNm, double baseIor, double lambdaNm);

// Wyman, Sloan, Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", listing 1.
glm::dvec3 xyzBar(double lambdaNm);

}  // namespace facet::optics
