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
constexpr double narrowestAlpha = 1e-12;
constexpr double leastMissing = 0.011;  // roughness 0.24: what the shaders' half floats hold well

SlopeIntegral slopeIntegral(double NoV, double alpha, double tolerance) {
  const double cosV = std::clamp(NoV, smallestNoV, 1.0);
  return {cosV, std::sqrt((1 - cosV) * (1 + cosV)), alpha, tolerance};
}

}  // namespace

Dfg integrateDfg(double NoV, double alpha, double tolerance) {
  if (alpha < narrowestAlpha) {
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
  if (alpha < narrowestAlpha) return integral.sinV;
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

double missingOnAverage(double alpha) {
  // mu = u^2: E has an infinite slope at the horizon. Most is lost where NoV is about alpha.
  const double tolerance = 1e-6 * alpha * alpha;
  const auto f = [&](double u) {
    const Dfg dfg = integrateDfg(u * u, alpha, std::max(tolerance / 10, 1e-12));
    return 4 * u * u * u * (1 - dfg.A - dfg.B);
  };
  const double split = std::min(0.9, std::sqrt(3 * alpha));
  return integrateAdaptive<double>(f, 0, split, tolerance, 12) + integrateAdaptive<double>(f, split, 1, tolerance, 12);
}

double missingOnAverageFit(double alpha) {
  const double a = std::max(alpha, 1e-3), a2 = a * a;
  const double even = 0.488068 - 0.268273 * a2 - 0.179286 * a2 * a2, odd = 0.073123 + 0.477188 * a2;
  return a2 * (even + a * odd + std::log(1 / a));
}

EnergyModel distantEnergy(EnergyModel chosen) {
  return chosen == EnergyModel::automatic ? EnergyModel::fdezAguera : chosen;
}
EnergyModel lightEnergy(EnergyModel chosen) { return chosen == EnergyModel::automatic ? EnergyModel::turquin : chosen; }

Compensation compensationOf(EnergyModel model, const Dfg& dfg, double alpha, const glm::dvec3& f0, double f90) {
  Compensation made;
  if (model == EnergyModel::turquin) made.gain = compensationTurquin(dfg, f0);
  if (model == EnergyModel::fdezAguera) made.multiple = energyFdezAguera(dfg, f0, f90).multiple;
  if (model != EnergyModel::kullaConty) return made;
  // Bounces after the first: a share Eavg leaves, the rest meets a facet again. The first facet's Favg counts, too
  // (Hill 2018, "A Multi-Faceted Exploration", part 2).
  const double missing = missingOnAverageFit(alpha);
  const glm::dvec3 average = F_SchlickAverage(f0, f90);
  const glm::dvec3 series = average * (1 - missing) / (glm::dvec3(1) - missing * average);
  made.multiple = (1 - dfg.A - dfg.B) * average * series;
  return made;
}

glm::dvec3 specularAlbedo(EnergyModel model, const Dfg& dfg, double alpha, const glm::dvec3& f0, double f90) {
  const Compensation made = compensationOf(model, dfg, alpha, f0, f90);
  return (f0 * dfg.A + glm::dvec3(f90 * dfg.B)) * made.gain + made.multiple;
}

double multipleShape(EnergyModel model, double albedoL, double alpha) {
  if (model != EnergyModel::kullaConty) return 1;
  const double missing = missingOnAverageFit(alpha), flat = std::max(1 - missing / leastMissing, 0.0);
  return flat + (1 - flat) * std::max(1 - albedoL, 0.0) / missing;
}

}  // namespace facet::optics
