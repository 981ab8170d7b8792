#pragma once

// Share of light that a smooth facet reflects. VoH in [0, 1], clamped.

#include <glm/glm.hpp>

namespace facet::optics {

// (1 - VoH)^5, the weight of f90.
double schlickWeight(double VoH);
// Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering", eq. 15, with f90 in the place of 1.
// f0 at VoH = 1, f90 at VoH = 0.
double F_Schlick(double VoH, double f0, double f90);
glm::dvec3 F_Schlick(double VoH, const glm::dvec3& f0, double f90);

// Mean over the cosine-weighted hemisphere, 2 int F(mu) mu dmu: f0 + (f90 - f0) / 21.
glm::dvec3 F_SchlickAverage(const glm::dvec3& f0, double f90);

// Index of refraction behind the surface over that before it, and reflectance at normal incidence in air. An index of 0
// stands for an infinite one, as in KHR_materials_ior: f0 = 1.
double f0FromIor(double ior);  // ((ior - 1) / (ior + 1))^2, ior >= 0
double iorFromF0(double f0);   // (1 + sqrt(f0)) / (1 - sqrt(f0)) >= 1; f0 clamped to [0, 1]; f0 = 1: 0

// Unpolarised Fresnel equations of two dielectrics; eta = index behind / index before the surface.
// eta = 1: 0. eta <= 0 stands for infinity: 1. Beyond the critical angle (eta < 1): 1. VoH = 0: 1 (0 if eta = 1).
double F_Dielectric(double VoH, double eta);
// Its mean, 2 int F(mu) mu dmu, by quadrature (about 1e-10).
double F_DielectricAverage(double eta);
// Fit of that mean, Kulla and Conty 2017, "Revisiting Physically Based Shading at Imageworks": 0.25 <= eta <= 400,
// clamped beyond; largest error against the integral 6.5e-3, at eta = 1.17; eta <= 0: 1.
double F_DielectricAverageFit(double eta);

// Unpolarised Fresnel equations of a conductor in vacuum, index eta + i k. k = 0: the dielectric's. VoH = 0: 1 (0 where
// eta = 1 and k = 0). eta, k >= 0.
double F_Conductor(double VoH, double eta, double k);
glm::dvec3 F_Conductor(double VoH, const glm::dvec3& eta, const glm::dvec3& k);  // per channel
glm::dvec3 F_ConductorAverage(const glm::dvec3& eta, const glm::dvec3& k);       // by quadrature

// Kutz, Hasan, Edmondson 2021, "Novel aspects of the Adobe Standard Material", F82-tint: Schlick's curve with f90 =
// 1, less a VoH (1 - VoH)^6 with a such that at cosine 1 / 7 (82 degrees) it is Schlick's times tint. tint = 1:
// Schlick. f0 and tint in [0, 1]. For small f0 and tint the curve would fall below 0 (to -0.13 at f0 = tint = 0):
// clamped to 0.
inline constexpr double cosine82 = 1.0 / 7;
glm::dvec3 F_82Tint(double VoH, const glm::dvec3& f0, const glm::dvec3& tint);
// Its mean without the clamp: Schlick's less a / 126.
glm::dvec3 F_82TintAverage(const glm::dvec3& f0, const glm::dvec3& tint);
// The tint for which the curve passes through a reflectance measured at 82 degrees; within [0, 1].
glm::dvec3 tintFromF82(const glm::dvec3& f0, const glm::dvec3& f82);

}  // namespace facet::optics
