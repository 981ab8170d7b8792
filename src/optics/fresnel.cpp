#include "optics/fresnel.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

double schlickWeight(double VoH) {
  const double x = 1 - std::clamp(VoH, 0.0, 1.0);
  return x * x * x * x * x;
}

double F_Schlick(double VoH, double f0, double f90) {
  const double weight = schlickWeight(VoH);
  return f0 * (1 - weight) + f90 * weight;  // exactly f0 and f90 at the ends
}

glm::dvec3 F_Schlick(double VoH, const glm::dvec3& f0, double f90) {
  const double weight = schlickWeight(VoH);
  return f0 * (1 - weight) + glm::dvec3(f90 * weight);
}

glm::dvec3 F_SchlickAverage(const glm::dvec3& f0, double f90) { return (f0 * 20.0 + glm::dvec3(f90)) / 21.0; }

double F_Dielectric(double VoH, double eta) {
  if (eta == 1) return 0;
  const double cosI = std::clamp(VoH, 0.0, 1.0);
  const double sin2T = (1 - cosI) * (1 + cosI) / (eta * eta);
  if (sin2T >= 1) return 1;
  const double cosT = std::sqrt(1 - sin2T);
  const double s = (cosI - eta * cosT) / (cosI + eta * cosT);
  const double p = (eta * cosI - cosT) / (eta * cosI + cosT);
  return (s * s + p * p) / 2;
}

}  // namespace facet::optics
