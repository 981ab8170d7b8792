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

// Unpolarised Fresnel equations of two dielectrics; eta = index behind / index before the surface, > 0.
// eta = 1: 0. Beyond the critical angle (eta < 1): 1. VoH = 0: 1 (0 if eta = 1).
double F_Dielectric(double VoH, double eta);

}  // namespace facet::optics
