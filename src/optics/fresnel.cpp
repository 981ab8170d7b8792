#include "optics/fresnel.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "optics/quadrature.hpp"

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

double f0FromIor(double ior) {
  if (std::isinf(ior)) return 1;
  const double ratio = (ior - 1) / (ior + 1);
  return ratio * ratio;  // ior = 0 gives 1
}

double iorFromF0(double f0) {
  const double root = std::sqrt(std::clamp(f0, 0.0, 1.0));
  return root < 1 ? (1 + root) / (1 - root) : 0;
}

double F_Dielectric(double VoH, double eta) {
  if (eta == 1) return 0;
  if (eta <= 0 || std::isinf(eta)) return 1;
  const double cosI = std::clamp(VoH, 0.0, 1.0);
  const double sin2T = (1 - cosI) * (1 + cosI) / (eta * eta);
  if (sin2T >= 1) return 1;
  const double cosT = std::sqrt(1 - sin2T);
  const double s = (cosI - eta * cosT) / (cosI + eta * cosT);
  const double p = (eta * cosI - cosT) / (eta * cosI + cosT);
  return (s * s + p * p) / 2;
}

double F_DielectricAverage(double eta) {
  if (eta <= 0) return 1;
  const auto f = [&](double mu) { return 2 * mu * F_Dielectric(mu, eta); };
  if (eta >= 1) return integrateAdaptive<double>(f, 0, 1, 1e-12);
  const double critical = std::sqrt((1 - eta) * (1 + eta));
  // x^2 takes the root at the critical angle out of the integrand.
  const auto transformed = [&](double x) { return f(critical + (1 - critical) * x * x) * 2 * x * (1 - critical); };
  return critical * critical + integrateAdaptive<double>(transformed, 0, 1, 1e-12);
}

double F_DielectricAverageFit(double eta) {
  if (eta <= 0) return 1;
  if (eta >= 1) return (std::min(eta, 400.0) - 1) / (4.08567 + 1.00071 * std::min(eta, 400.0));
  const double e = std::max(eta, 0.25);
  return std::clamp(0.997118 + e * (0.1014 - e * (0.965241 + e * 0.130607)), 0.0, 1.0);
}

double F_Conductor(double VoH, double eta, double k) {
  if (eta == 1 && k == 0) return 0;
  const double cosI = std::clamp(VoH, 0.0, 1.0);
  const std::complex<double> index(eta, k);
  const std::complex<double> sin2T = (1 - cosI) * (1 + cosI) / (index * index);
  if (k == 0 && sin2T.real() >= 1) return 1;
  const std::complex<double> cosT = std::sqrt(1.0 - sin2T);
  const std::complex<double> s = (cosI - index * cosT) / (cosI + index * cosT);
  const std::complex<double> p = (index * cosI - cosT) / (index * cosI + cosT);
  return (std::norm(s) + std::norm(p)) / 2;
}

glm::dvec3 F_Conductor(double VoH, const glm::dvec3& eta, const glm::dvec3& k) {
  return {F_Conductor(VoH, eta.x, k.x), F_Conductor(VoH, eta.y, k.y), F_Conductor(VoH, eta.z, k.z)};
}

glm::dvec3 F_ConductorAverage(const glm::dvec3& eta, const glm::dvec3& k) {
  glm::dvec3 mean;
  for (int i = 0; i < 3; ++i)
    mean[i] = integrateAdaptive<double>([&](double mu) { return 2 * mu * F_Conductor(mu, eta[i], k[i]); }, 0, 1, 1e-12);
  return mean;
}

namespace {

// (1 - tint) F_Schlick(1/7) / (1/7 (6/7)^6)
glm::dvec3 strength82(const glm::dvec3& f0, const glm::dvec3& tint) {
  return (glm::dvec3(1) - tint) * F_Schlick(cosine82, f0, 1) / (cosine82 * std::pow(1 - cosine82, 6));
}

}  // namespace

glm::dvec3 F_82Tint(double VoH, const glm::dvec3& f0, const glm::dvec3& tint) {
  const double mu = std::clamp(VoH, 0.0, 1.0);
  return glm::max(F_Schlick(mu, f0, 1) - strength82(f0, tint) * (mu * std::pow(1 - mu, 6)), glm::dvec3(0));
}

glm::dvec3 F_82TintAverage(const glm::dvec3& f0, const glm::dvec3& tint) {
  return F_SchlickAverage(f0, 1) - strength82(f0, tint) / 126.0;
}

glm::dvec3 tintFromF82(const glm::dvec3& f0, const glm::dvec3& f82) {
  return glm::clamp(f82 / F_Schlick(cosine82, f0, 1), 0.0, 1.0);
}

}  // namespace facet::optics
