#include "optics/energy.hpp"

#include <algorithm>
#include <cmath>

#include "optics/fresnel.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

// In slopes (p, q) of the microfacet, p towards -V: D_v dH = G1 (1 - p tan) P22 dp dq, with P22 the distribution of
// slopes (Heitz 2014 eq. 57 and 58). L is above the horizon exactly inside the disc (p + tan)^2 + q^2 < 1 / cos^2, so
// the domain has no edge inside it, and by symmetry half of it is enough:
//   E = 2 int_0^pi dphi int_0^rhoMax(phi) G2 (1 - rho cos(phi) tan) P22 rho drho.
// rho = alpha tan w makes P22 rho drho = sin w cos w dw / pi: smooth also where NoV -> 0 and the weight grows like rho.
struct Facet {
  double weight;  // of the integrand for F = 1
  double VoH;
  double NoL;
  double tangential;  // of L, on the side that faces away from V
};

struct SlopeIntegral {
  double cosV, sinV, alpha, tolerance;

  double rhoMax(double cosPhi) const {
    const double b = sinV * cosPhi;  // positive root of c rho^2 + 2 b rho - c = 0
    const double root = std::sqrt(b * b + cosV * cosV);
    return b > 0 ? cosV / (root + b) : (root - b) / cosV;
  }

  Facet facetAt(double w, double cosPhi, double lambdaV) const {
    const double sinW = std::sin(w), cosW = std::cos(w);
    const double rho = alpha * sinW / cosW;
    const double cosVoverCosH = cosV - rho * cosPhi * sinV;  // VoH sqrt(1 + rho^2)
    const double cos2H = 1 / (1 + rho * rho);
    const double NoL = std::clamp(2 * cosVoverCosH * cos2H - cosV, 0.0, 1.0);
    const double G2 = NoL > 0 ? 1 / (1 + lambdaV + Lambda_GGX(NoL, alpha)) : 0;
    const double value = 2 * sinW * cosW / pi * G2 * cosVoverCosH / cosV;
    return {value, cosVoverCosH * std::sqrt(cos2H), NoL, sinV + 2 * cosVoverCosH * cos2H * rho * cosPhi};
  }

  // Integral of weight * integrand(facet).
  template <class Integrand>
  glm::dvec2 total(const Integrand& integrand) const {
    const double lambdaV = Lambda_GGX(cosV, alpha);
    const auto overRadius = [&](double phi) {
      const double cosPhi = std::cos(phi);
      const auto f = [&](double w) {
        const Facet facet = facetAt(w, cosPhi, lambdaV);
        return facet.weight * integrand(facet);
      };
      return integrateAdaptive<glm::dvec2>(f, 0, std::atan(rhoMax(cosPhi) / alpha), tolerance * 0.1);
    };
    // The range of rho changes fastest at pi / 2 when V grazes.
    return integrateAdaptive<glm::dvec2>(overRadius, 0, pi / 2, tolerance / 2) +
           integrateAdaptive<glm::dvec2>(overRadius, pi / 2, pi, tolerance / 2);
  }
};

constexpr double smallestNoV = 1e-9;  // E(NoV) - E(0) is about NoV ln NoV at worst: 2e-8
constexpr double mirrorAlpha = 1e-12;

SlopeIntegral slopeIntegral(double NoV, double alpha, double tolerance) {
  const double cosV = std::clamp(NoV, smallestNoV, 1.0);
  return {cosV, std::sqrt((1 - cosV) * (1 + cosV)), alpha, tolerance};
}

}  // namespace

Dfg integrateDfg(double NoV, double alpha, double tolerance) {
  if (alpha < mirrorAlpha) {
    const double Fc = schlickWeight(NoV);
    return {1 - Fc, Fc};
  }
  const glm::dvec2 sum = slopeIntegral(NoV, alpha, tolerance).total([](const Facet& facet) {
    const double Fc = schlickWeight(facet.VoH);
    return glm::dvec2(1 - Fc, Fc);
  });
  return {sum.x, sum.y};
}

double meanDirectionSine(double NoV, double alpha, double tolerance) {
  const SlopeIntegral integral = slopeIntegral(NoV, alpha, tolerance);
  if (alpha < mirrorAlpha) return integral.sinV;
  const glm::dvec2 mean = integral.total([](const Facet& facet) { return glm::dvec2(facet.tangential, facet.NoL); });
  return mean.x / std::hypot(mean.x, mean.y);
}

SpecularEnergy energyFdezAguera(const Dfg& dfg, const glm::dvec3& f0, double f90) {
  const glm::dvec3 one(1);
  const double missing = 1 - (dfg.A + dfg.B);
  const glm::dvec3 average = F_SchlickAverage(f0, f90);
  SpecularEnergy energy;
  energy.single = f0 * dfg.A + glm::dvec3(f90 * dfg.B);
  // Geometric series of the bounces after the first, each losing `missing` again.
  energy.multiple = missing * energy.single * average / (one - missing * average);
  energy.diffuse = one - energy.single - energy.multiple;
  return energy;
}

glm::dvec3 compensationTurquin(const Dfg& dfg, const glm::dvec3& f0) {
  const double E = dfg.A + dfg.B;
  return glm::dvec3(1) + f0 * ((1 - E) / E);
}

glm::dvec3 specularAlbedoTurquin(const Dfg& dfg, const glm::dvec3& f0, double f90) {
  return (f0 * dfg.A + glm::dvec3(f90 * dfg.B)) * compensationTurquin(dfg, f0);
}

}  // namespace facet::optics
