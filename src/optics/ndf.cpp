#include "optics/ndf.hpp"

#include <algorithm>
#include <cmath>

#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

const double rootPi = std::sqrt(pi);

// (exp(-a^2) / (a sqrt(pi)) - erfc(a)) / 2; beyond a = 5 the asymptotic series of erfc, whose first term cancels.
double lambdaOf(double a) {
  const double e = std::exp(-a * a);
  if (a < 5) return (e / (a * rootPi) - std::erfc(a)) / 2;
  const double x = 1 / (2 * a * a);
  return e / (a * rootPi) * x * (1 - 3 * x * (1 - 5 * x * (1 - 7 * x * (1 - 9 * x)))) / 2;
}

// cosine Lambda, finite at the horizon: alpha / (2 sqrt(pi)).
double cosineLambdaBeckmann(double cosine, double alpha) {
  const double sine = std::sqrt(sin2FromCos(cosine));
  if (alpha < smallestAlpha || sine == 0) return 0;
  const double a = cosine / (alpha * sine);
  if (a < 1e-8) return alpha * sine / (2 * rootPi);
  return cosine * lambdaOf(a);
}

double V_Schlick(double NoV, double NoL, double k) {
  if (NoV < 0 || NoL < 0) return 0;
  const double v = floored(NoV), l = floored(NoL);
  return 1 / (4 * (v + k * (1 - v)) * (l + k * (1 - l)));
}

}  // namespace

double D_BeckmannFromSin2(double sin2NoH, double alpha) {
  const double cos2 = 1 - sin2NoH;
  if (alpha < smallestAlpha || !(cos2 > 0)) return 0;
  const double slope = std::sqrt(sin2NoH / cos2) / alpha;
  if (slope > 38) return 0;  // exp(-1444) is 0
  return std::exp(-slope * slope) / (pi * alpha * alpha * cos2 * cos2);
}

double D_Beckmann(double NoH, double alpha) { return NoH <= 0 ? 0 : D_BeckmannFromSin2(sin2FromCos(NoH), alpha); }

double D_BlinnFromSin2(double sin2NoH, double alpha) {
  if (alpha < smallestAlpha) return 0;
  const double halfExponent = (1 / alpha - alpha) / alpha;  // 1 / alpha^2 - 1
  const double log = sin2NoH < 1 ? halfExponent * std::log1p(-sin2NoH) : (halfExponent > 0 ? -1e9 : 0);
  return std::exp(log) / (pi * alpha * alpha);
}

double D_Blinn(double NoH, double alpha) { return NoH <= 0 ? 0 : D_BlinnFromSin2(sin2FromCos(NoH), alpha); }

double Lambda_Beckmann(double cosine, double alpha) {
  const double c = floored(cosine);
  return cosineLambdaBeckmann(c, alpha) / c;
}

double G1_Beckmann(double cosine, double alpha) { return cosine < 0 ? 0 : 1 / (1 + Lambda_Beckmann(cosine, alpha)); }

double G2_Beckmann(double NoV, double NoL, double alpha) {
  if (NoV < 0 || NoL < 0) return 0;
  return 1 / (1 + Lambda_Beckmann(NoV, alpha) + Lambda_Beckmann(NoL, alpha));
}

double V_BeckmannCorrelated(double NoV, double NoL, double alpha) {
  if (NoV < 0 || NoL < 0) return 0;
  const double v = floored(NoV), l = floored(NoL);
  return 1 / (4 * (v * l + (l * cosineLambdaBeckmann(v, alpha) + v * cosineLambdaBeckmann(l, alpha))));
}

double D_BeckmannAnisotropic(const glm::dvec3& H, const AnisotropicAlpha& alpha) {
  const double t = std::max(alpha.t, smallestAlpha), b = std::max(alpha.b, smallestAlpha);
  if (!(H.z > 0)) return 0;
  const double slopeT = H.x / (H.z * t), slopeB = H.y / (H.z * b), cos2 = H.z * H.z;
  return std::exp(-(slopeT * slopeT + slopeB * slopeB)) / (pi * t * b * cos2 * cos2);
}

double V_BeckmannAnisotropic(const glm::dvec3& V, const glm::dvec3& L, const AnisotropicAlpha& alpha) {
  if (V.z < 0 || L.z < 0) return 0;
  const auto alphaTowards = [&](const glm::dvec3& d) {
    const double sine2 = d.x * d.x + d.y * d.y, x = d.x * alpha.t, y = d.y * alpha.b;
    return sine2 > 0 ? std::sqrt((x * x + y * y) / sine2) : alpha.t;
  };
  const double v = floored(V.z), l = floored(L.z);
  return 1 /
         (4 * (v * l + l * cosineLambdaBeckmann(v, alphaTowards(V)) + v * cosineLambdaBeckmann(l, alphaTowards(L))));
}

double D_GTR(double NoH, double alpha, double exponent) {
  if (!(NoH > 0) || alpha < smallestAlpha) return 0;
  // c = (exponent - 1) (alpha^2 - 1) / (pi (1 - alpha^(2 - 2 exponent))); at exponent 1 and alpha 1 its limits.
  const double log2 = 2 * std::log(alpha), above = exponent - 1;
  if (log2 == 0) return 1 / pi;
  const double tail = std::abs(above) < 1e-9 ? log2 : -std::expm1(-above * log2) / above;
  return std::expm1(log2) / (pi * tail) * std::pow(sin2FromCos(NoH) + alpha * alpha * NoH * NoH, -exponent);
}

double G1_BeckmannRational(double cosine, double alpha) {
  if (cosine < 0) return 0;
  const double sine = std::sqrt(sin2FromCos(cosine));
  if (alpha < smallestAlpha || cosine >= 1.6 * alpha * sine) return 1;
  const double a = cosine / (alpha * sine);
  return a * (3.535 + 2.181 * a) / (1 + a * (2.276 + 2.577 * a));
}

double V_BeckmannRational(double NoV, double NoL, double alpha) {
  if (NoV < 0 || NoL < 0) return 0;
  const double v = floored(NoV), l = floored(NoL);
  return G1_BeckmannRational(v, alpha) / v * (G1_BeckmannRational(l, alpha) / l) / 4;
}

double G1_Smith(const std::function<double(double sin2NoH)>& D, double alpha, double NoV) {
  const double sinV = std::sqrt(sin2FromCos(NoV));
  // int max(VoH, 0) dphi = 2 (VzHz phi0 + sinV sinH sin(phi0)), phi0 where VoH turns negative.
  const auto overTheta = [&](double w) {
    // tan(theta) = alpha tan(w): the lobe's width is the unit.
    const double slope = alpha * std::tan(w), cos2 = 1 / (1 + slope * slope);
    const double cosH = std::sqrt(cos2), sinH = slope * cosH;
    const double edge = NoV * cosH >= sinV * sinH ? pi : std::acos(-NoV * cosH / (sinV * sinH));
    const double visible = 2 * (NoV * cosH * edge + sinV * sinH * std::sin(edge));
    const double dTheta = alpha / (std::cos(w) * std::cos(w)) * cos2;
    return visible * D(sinH * sinH) * sinH * dTheta;
  };
  const double kink = sinV > 0 ? std::atan(NoV / (alpha * sinV)) : pi / 2;
  const double end = pi / 2 - 1e-9;
  const double total = integrateAdaptive<double>(overTheta, 0, std::min(kink, end), 1e-8 * NoV, 20) +
                       (kink < end ? integrateAdaptive<double>(overTheta, kink, end, 1e-8 * NoV, 20) : 0);
  return std::min(1.0, NoV / total);
}

double G1_SchlickGGX(double cosine, double alpha) {
  if (cosine < 0) return 0;
  const double c = floored(cosine), k = alpha / 2;
  return c / (c + k * (1 - c));
}

double V_SchlickGGX(double NoV, double NoL, double alpha) { return V_Schlick(NoV, NoL, alpha / 2); }

double V_SchlickRemapped(double NoV, double NoL, double alpha) {
  const double r = std::sqrt(alpha) + 1;
  return V_Schlick(NoV, NoL, r * r / 8);
}

double G_Cavity(const Angles& angles) {
  if (angles.NoV < 0 || angles.NoL < 0) return 0;
  const double smaller = 2 * std::max(angles.NoH, 0.0) * std::min(angles.NoV, angles.NoL);
  return smaller >= angles.VoH ? 1 : smaller / angles.VoH;
}

double V_Cavity(const Angles& angles) {
  if (angles.NoV < 0 || angles.NoL < 0) return 0;
  const double v = floored(angles.NoV), l = floored(angles.NoL);
  return std::min(1 / (4 * v * l), std::max(angles.NoH, 0.0) / (2 * floored(angles.VoH) * std::max(v, l)));
}

}  // namespace facet::optics
