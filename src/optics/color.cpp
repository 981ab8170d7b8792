#include "optics/color.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

namespace {

double cleaned(double x) { return x > 0 ? std::min(x, largestRadiance) : 0; }  // NaN > 0 is false
double saturate(double x) { return x > 0 ? std::min(x, 1.0) : 0; }

template <class Function>
glm::dvec3 each(const glm::dvec3& v, const Function& f) {
  return {f(v.x), f(v.y), f(v.z)};
}

// Hable's curve ((x (A x + C B) + D E) / (x (A x + B) + D F)) - E / F over one denominator, so that 0 gives 0.
double hable(double x) {
  constexpr double A = 0.15, B = 0.50, C = 0.10, D = 0.20, E = 0.02, F = 0.30;
  return x * (A * (F - E) * x + B * (C * F - E)) / (F * (x * (A * x + B) + D * F));
}

// glm matrices are by columns: each line below is a column.
const glm::dmat3 acesInput(0.59719, 0.07600, 0.02840,  //
                           0.35458, 0.90834, 0.13383,  //
                           0.04823, 0.01566, 0.83777);
const glm::dmat3 acesOutput(1.60475, -0.10208, -0.00327,  //
                            -0.53108, 1.10813, -0.07276,  //
                            -0.07367, -0.00605, 1.07602);

double acesCurve(double v) { return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081); }

const glm::dmat3 agxInset(0.842479062253094, 0.0423282422610123, 0.0423756549057051,  //
                          0.0784335999999992, 0.878468636469772, 0.0784336,           //
                          0.0792237451477643, 0.0791661274605434, 0.879142973793104);
const glm::dmat3 agxOutset(1.19687900512017, -0.0528968517574562, -0.0529716355144438,  //
                           -0.0980208811401368, 1.15190312990417, -0.0980434501171241,  //
                           -0.0990297440797205, -0.0989611768448433, 1.15107367264116);

// Position of log2(x) in the range of exposures, then the polynomial in Horner form. Black: below the range.
double agxCurve(double x) {
  constexpr double lowest = -12.47393, highest = 4.026069;
  const double stops = x > 0 ? std::clamp(std::log2(x), lowest, highest) : lowest;
  const double t = (stops - lowest) / (highest - lowest);
  return ((((((15.5 * t - 40.14) * t + 31.96) * t - 6.868) * t + 0.4298) * t + 0.1191) * t - 0.00232);
}

glm::dvec3 pbrNeutral(const glm::dvec3& c) {
  constexpr double F90 = 0.04, start = 0.8 - F90, desaturation = 0.15, d = 1 - start;
  const double x = std::min({c.x, c.y, c.z});
  // Fresnel toe: the smallest channel x becomes x^2 / (4 F90) below 2 F90.
  const double offset = x < 2 * F90 ? x - x * x / (4 * F90) : F90;
  const glm::dvec3 shifted = c - glm::dvec3(offset);
  const double peak = std::max({shifted.x, shifted.y, shifted.z});
  if (peak < start) return shifted;
  const double newPeak = 1 - d * d / (peak - start + d);
  const double kept = 1 / (desaturation * (peak - newPeak) + 1);
  return shifted * (newPeak / peak * kept) + glm::dvec3(newPeak * (1 - kept));
}

}  // namespace

double luminance(const glm::dvec3& rgb) { return glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722)); }

double encodeSRGB(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

double decodeSRGB(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

glm::dvec3 encodeSRGB(const glm::dvec3& linear) {
  return each(linear, [](double x) { return encodeSRGB(x); });
}

glm::dvec3 decodeSRGB(const glm::dvec3& encoded) {
  return each(encoded, [](double x) { return decodeSRGB(x); });
}

// From viridis (van der Walt and Smith 2015), a stop for each eighth.
glm::dvec3 falseColor(double share) {
  if (std::isnan(share)) return {1, 0, 1};
  constexpr std::array stops = {
#define STOP(r, g, b) std::array<double, 3>{r, g, b},
#include "false_color_stops.inc"
#undef STOP
  };
  const double at = std::clamp(share, 0.0, 1.0) * (stops.size() - 1);
  const auto first = std::min(static_cast<size_t>(at), stops.size() - 2);
  const auto color = [&](size_t i) { return glm::dvec3(stops[i][0], stops[i][1], stops[i][2]) / 255.0; };
  return glm::mix(color(first), color(first + 1), at - static_cast<double>(first));
}

glm::dvec3 toneMap(ToneMapper mapper, const glm::dvec3& radiance) {
  const glm::dvec3 c = each(radiance, cleaned);
  switch (mapper) {
    case ToneMapper::none:
      return each(c, saturate);
    case ToneMapper::reinhard:
      return each(c, [](double x) { return x / (1 + x); });
    case ToneMapper::reinhardPower:
      return each(c, [](double x) { return decodeSRGB(std::pow(x / (1 + x), 1 / 2.2)); });
    case ToneMapper::uncharted2:
      return each(c, [](double x) { return saturate(hable(2 * x) / hable(11.2)); });
    case ToneMapper::aces:
      return each(acesOutput * each(acesInput * c, acesCurve), saturate);
    case ToneMapper::agx:
      return each(agxOutset * each(agxInset * c, agxCurve), [](double x) { return std::pow(saturate(x), 2.2); });
    case ToneMapper::pbrNeutral:
      return each(pbrNeutral(c), saturate);
  }
  return c;
}

}  // namespace facet::optics
