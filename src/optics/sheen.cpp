#include "optics/sheen.hpp"

#include <algorithm>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

double counted(double cosine) { return std::clamp(cosine, 1e-4, 1.0); }

// Table 1: a, b, c, d, e for roughness 0 and 1.
struct Fit {
  double a, b, c, d, e;
  double operator()(double x) const { return a / (1 + b * std::pow(x, c)) + d * x + e; }
};
constexpr Fit sharp{25.3245, 3.32435, 0.16801, -1.27393, -4.85967};
constexpr Fit soft{21.5473, 3.82987, 0.19823, -1.97760, -4.32054};

Fit fitAt(double alpha) {
  const double s = (1 - alpha) * (1 - alpha), r = 1 - s;
  return {s * sharp.a + r * soft.a, s * sharp.b + r * soft.b, s * sharp.c + r * soft.c, s * sharp.d + r * soft.d,
          s * sharp.e + r * soft.e};
}

}  // namespace

double D_Charlie(double NoH, double alpha) {
  const double inverse = 1 / std::max(alpha, smallestSheenAlpha);
  const double c = std::clamp(NoH, 0.0, 1.0);
  return (2 + inverse) * std::pow(std::sqrt((1 - c) * (1 + c)), inverse) / (2 * pi);
}

double Lambda_Charlie(double cosine, double alpha) {
  const Fit L = fitAt(std::clamp(alpha, smallestSheenAlpha, 1.0));
  const double c = std::clamp(cosine, 0.0, 1.0);
  return std::exp(c < 0.5 ? L(c) : 2 * L(0.5) - L(1 - c));
}

double V_Charlie(double NoV, double NoL, double alpha) {
  const double v = counted(NoV), l = counted(NoL);
  return 1 / (4 * v * l * (1 + Lambda_Charlie(v, alpha) + Lambda_Charlie(l, alpha)));
}

double V_Ashikhmin(double NoV, double NoL) {
  const double v = counted(NoV), l = counted(NoL);
  return 1 / (4 * (l + v - l * v));
}

double sheenAlbedo(double NoV, double alpha) {
  const double v = counted(NoV), sinV = std::sqrt((1 - v) * (1 + v));
  const auto overAzimuth = [&](double root) {
    const double NoL = root * root;  // dense where the lobe is: at the horizon
    const double sinL = std::sqrt((1 - NoL) * (1 + NoL));
    const auto f = [&](double phi) {
      const double sumLength2 = 2 + 2 * (v * NoL + sinV * sinL * std::cos(phi));
      return sumLength2 > 1e-20 ? D_Charlie((v + NoL) / std::sqrt(sumLength2), alpha) : D_Charlie(0, alpha);
    };
    return 4 * root * NoL * V_Charlie(v, NoL, alpha) * integrateAdaptive<double>(f, 0, pi, 1e-7, 16);
  };
  return integrateAdaptive<double>(overAzimuth, 0, 0.3, 1e-6, 16) +
         integrateAdaptive<double>(overAzimuth, 0.3, 1, 1e-6, 16);
}

double sheenScaling(double maxSheenColor, double albedoV, double albedoL) {
  return std::clamp(1 - maxSheenColor * std::max(albedoV, albedoL), 0.0, 1.0);
}

double sheenGainGuard(double albedoV, double albedoL) { return 1 / std::max({1.0, albedoV, albedoL}); }

}  // namespace facet::optics
