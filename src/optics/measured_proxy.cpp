#include "optics/measured_proxy.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "optics/anisotropy.hpp"
#include "optics/color.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

namespace facet::optics {

namespace {

constexpr int iterations = 4;

glm::dvec3 direction(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// Pairs in which Fresnel's term is still near its value at normal incidence, so that D is what changes.
std::vector<Directions> steepPairs(const MeasuredBrdf& brdf) {
  std::vector<Directions> pairs;
  const int turns = brdf.kind == MeasuredKind::merl ? 1 : 16;
  for (int turn = 0; turn < turns; ++turn) {
    for (const double thetaH : {0.0, 1.0, 2.0, 4.0, 7.0, 12.0, 18.0, 25.0, 35.0, 45.0, 55.0, 65.0}) {
      for (const double thetaD : {3.0, 15.0, 30.0}) {
        const Directions pair = directionsFrom({thetaH * degree, thetaD * degree, pi / 2});
        const double phi = -2 * pi * turn / turns;
        pairs.push_back({turned(pair.V, phi), turned(pair.L, phi)});
      }
    }
  }
  return pairs;
}

// Normals [theta][phi] with what each counts: solid angle.
struct Normals {
  std::vector<double> theta, weight;  // weight [sr] of one azimuth
  int azimuths = 1;
  size_t size() const { return theta.size() * static_cast<size_t>(azimuths); }
  double phi(int j) const { return 2 * pi * j / azimuths; }
};

Normals normalsOf(const MeasuredBrdf& brdf) {
  constexpr double merlEnd = 80 * degree, utiaEnd = utiaLastTheta * degree;
  Normals normals;
  const auto add = [&](double from, double to) {
    normals.theta.push_back((from + to) / 2);
    normals.weight.push_back(2 * pi * (std::cos(from) - std::cos(to)) / normals.azimuths);
  };
  if (brdf.kind == MeasuredKind::merl) {
    for (int k = 0; merlAngles({k + 1, 0, 0}).thetaH < merlEnd; ++k)
      add(merlAngles({k, 0, 0}).thetaH, merlAngles({k + 1, 0, 0}).thetaH);
  } else {
    normals.azimuths = utiaPhiSteps / 2;
    constexpr int steps = 15;
    for (int k = 0; k < steps; ++k) add(utiaEnd * k / steps, utiaEnd * (k + 1) / steps);
  }
  return normals;
}

// f(o, o) over the normals. MERL: of V and L 6 degrees apart, because the database has few measurements at theta_d = 0.
std::vector<double> backscattered(const MeasuredBrdf& brdf, const Normals& normals) {
  std::vector<double> values;
  values.reserve(normals.size());
  for (const double theta : normals.theta) {
    for (int j = 0; j < normals.azimuths; ++j) {
      Directions pair{direction(theta, normals.phi(j)), direction(theta, normals.phi(j))};
      if (brdf.kind == MeasuredKind::merl) pair = directionsFrom({theta, 3 * degree, pi / 2});
      values.push_back(luminance(measuredBrdf(brdf, pair.V, pair.L, LookUp::interpolated)));
    }
  }
  return values;
}

// Mean over the azimuths between o and m of max(o.m, 0).
double meanCosine(double thetaO, double thetaM) {
  const double a = std::cos(thetaO) * std::cos(thetaM), b = std::sin(thetaO) * std::sin(thetaM);
  if (a >= b) return a;
  const double end = std::acos(-a / b);
  return (a * end + b * std::sin(end)) / pi;
}

// int D(m) <o, m> dm for all normals o.
std::vector<double> projectedAreas(const Normals& normals, const std::vector<double>& D) {
  const size_t n = normals.size();
  std::vector<double> result(n, 0.0);
  const auto azimuths = static_cast<size_t>(normals.azimuths);
  if (azimuths == 1) {
    for (size_t o = 0; o < n; ++o)
      for (size_t m = 0; m < n; ++m)
        result[o] += D[m] * normals.weight[m] * meanCosine(normals.theta[o], normals.theta[m]);
    return result;
  }
  std::vector<glm::dvec3> directions;
  for (const double theta : normals.theta)
    for (int j = 0; j < normals.azimuths; ++j) directions.push_back(direction(theta, normals.phi(j)));
  for (size_t o = 0; o < n; ++o)
    for (size_t m = 0; m < n; ++m)
      result[o] += D[m] * normals.weight[m / azimuths] * std::max(glm::dot(directions[o], directions[m]), 0.0);
  return result;
}

// Slopes with the share D cos of normals that has them.
using Shares = std::vector<std::pair<double, double>>;

double median(Shares shares) {
  std::sort(shares.begin(), shares.end());
  double total = 0, sum = 0;
  for (const auto& [slope, share] : shares) total += share;
  double before = 0;
  for (const auto& [slope, share] : shares) {
    if (sum + share >= total / 2) return before + (slope - before) * (share > 0 ? (total / 2 - sum) / share : 1);
    sum += share;
    before = slope;
  }
  return before;
}

// The share of slopes below t is t^2 / (alpha^2 + t^2); only those up to `end` are there.
double isotropicAlpha(const Normals& normals, const std::vector<double>& D) {
  Shares shares;
  double sum = 0, total = 0;
  for (size_t i = 0; i < D.size(); ++i) total += D[i] * normals.weight[i] * std::cos(normals.theta[i]);
  const double end = 80 * degree;
  double previous = 0;
  for (size_t i = 0; i < D.size(); ++i) {
    const double share = D[i] * normals.weight[i] * std::cos(normals.theta[i]);
    // The outer edge of the ring, between its centre and the next one's.
    const double next = i + 1 < D.size() ? (normals.theta[i] + normals.theta[i + 1]) / 2 : end;
    const double slope = std::tan(next);
    if (sum + share >= total / 2) {
      const double part = share > 0 ? (total / 2 - sum) / share : 1;
      const double m = std::sqrt(previous * previous + part * (slope * slope - previous * previous));
      const double T = std::tan(end);
      return T * T > 2 * m * m ? m * T / std::sqrt(T * T - 2 * m * m) : 1;
    }
    sum += share;
    previous = slope;
  }
  return 1;
}

void fitAnisotropic(const Normals& normals, const std::vector<double>& D, MeasuredProxy& proxy) {
  double c2 = 0, s2 = 0;
  std::vector<double> share(D.size());
  const auto azimuths = static_cast<size_t>(normals.azimuths);
  for (size_t i = 0; i < D.size(); ++i) {
    const double theta = normals.theta[i / azimuths], phi = normals.phi(static_cast<int>(i % azimuths));
    share[i] = D[i] * normals.weight[i / azimuths] * std::cos(theta);
    c2 += share[i] * std::cos(2 * phi);
    s2 += share[i] * std::sin(2 * phi);
  }
  proxy.phi = std::atan2(s2, c2) / 2;
  if (proxy.phi < 0) proxy.phi += pi;
  const auto along = [&](double axis) {
    Shares shares;
    for (size_t i = 0; i < D.size(); ++i) {
      const double phi = normals.phi(static_cast<int>(i % azimuths));
      shares.emplace_back(std::abs(std::tan(normals.theta[i / azimuths]) * std::cos(phi - axis)), share[i]);
    }
    return std::sqrt(3.0) * median(std::move(shares));  // of |x| where x has GGX' slopes: alpha / sqrt(3)
  };
  proxy.alpha = {along(proxy.phi), along(proxy.phi + pi / 2)};
}

}  // namespace

namespace {

// f(o, o) cos without a constant -> D by power iterations -> alpha. Kernels that are all 0 leave alpha as it is.
void fitLobe(const MeasuredBrdf& brdf, const Normals& normals, const std::vector<double>& back, double constant,
             MeasuredProxy& proxy) {
  const auto azimuths = static_cast<size_t>(normals.azimuths);
  std::vector<double> kernel(back.size());
  for (size_t o = 0; o < back.size(); ++o)
    kernel[o] = std::max(back[o] - constant, 0.0) * std::cos(normals.theta[o / azimuths]);
  std::vector<double> D = kernel;
  for (int i = 0; i < iterations; ++i) {
    const std::vector<double> areas = projectedAreas(normals, D);
    double largest = 0;
    for (size_t o = 0; o < D.size(); ++o) largest = std::max(largest, D[o] = kernel[o] * areas[o]);
    if (largest <= 0) return;
    for (double& d : D) d /= largest;
  }
  const bool merl = brdf.kind == MeasuredKind::merl;
  if (merl) {
    const double alpha = isotropicAlpha(normals, D);
    proxy.alpha = {alpha, alpha};
  } else {
    fitAnisotropic(normals, D, proxy);
  }
  const double smallest = merl ? 1e-3 : 0.1;
  proxy.alpha = {std::clamp(proxy.alpha.t, smallest, 1.0), std::clamp(proxy.alpha.b, smallest, 1.0)};
}

// Least squares of constant + s D V to f, relative to f, over s >= 0: the mean square that is left.
double misfit(const MeasuredProxy& proxy, double constant, const std::vector<Directions>& pairs,
              const std::vector<double>& values) {
  double numerator = 0, denominator = 0;
  std::vector<double> lobe(pairs.size());
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (values[i] <= 0) continue;
    const glm::dvec3 V = turned(pairs[i].V, proxy.phi), L = turned(pairs[i].L, proxy.phi);
    lobe[i] = D_GGXAnisotropic(glm::normalize(V + L), proxy.alpha) * V_GGXAnisotropic(V, L, proxy.alpha) / values[i];
    numerator += lobe[i] * (1 - constant / values[i]);
    denominator += lobe[i] * lobe[i];
  }
  const double s = denominator > 0 ? std::max(numerator / denominator, 0.0) : 0;
  double sum = 0;
  for (size_t i = 0; i < pairs.size(); ++i) {
    if (values[i] <= 0) continue;
    const double off = constant / values[i] + s * lobe[i] - 1;
    sum += off * off;
  }
  return sum;
}

}  // namespace

MeasuredProxy fitProxy(const MeasuredBrdf& brdf) {
  const std::vector<Directions> pairs = steepPairs(brdf);
  std::vector<double> values;
  glm::dvec3 least{1e300};
  for (const Directions& pair : pairs) {
    const glm::dvec3 f = measuredBrdf(brdf, pair.V, pair.L, LookUp::interpolated);
    values.push_back(luminance(f));
    if (f != glm::dvec3(0)) least = glm::min(least, f);
  }
  MeasuredProxy best{.alpha = {1, 1}, .diffuse = glm::dvec3(0)};
  if (least.x >= 1e300) return best;
  const Normals normals = normalsOf(brdf);
  const std::vector<double> back = backscattered(brdf, normals);
  best.diffuse = pi * least;
  if (*std::max_element(back.begin(), back.end()) <= (1 + 1e-6) * luminance(least)) return best;
  double smallest = 1e300;
  for (const double share : {0.0, 0.2, 0.4, 0.6, 0.7, 0.8, 0.85, 0.9, 0.95, 0.98, 1.0}) {
    MeasuredProxy proxy{.alpha = {1, 1}, .diffuse = pi * share * least};
    fitLobe(brdf, normals, back, share * luminance(least), proxy);
    const double left = misfit(proxy, share * luminance(least), pairs, values);
    if (left < smallest) smallest = left, best = proxy;
  }
  best.diffuseShare = 0.5;  // of the samples that find out
  const double albedo = luminance(measuredAlbedo(brdf, best, direction(30 * degree, 0), LookUp::interpolated, 1024));
  best.diffuseShare = albedo > 0 ? std::clamp(luminance(best.diffuse) / albedo, 0.0, 1.0) : 1;
  return best;
}

double cosineChance(const MeasuredProxy& proxy) {
  return std::clamp(proxy.diffuseShare, 0.1, proxy.diffuseShare > 0.97 ? 1.0 : 0.5);
}

glm::dvec3 sampleProxy(const MeasuredProxy& proxy, const glm::dvec3& V, const glm::dvec2& u, double choice) {
  if (choice < cosineChance(proxy)) {
    const double r = std::sqrt(u.x), phi = 2 * pi * u.y;
    return {r * std::cos(phi), r * std::sin(phi), std::sqrt(std::max(1 - u.x, 0.0))};
  }
  const glm::dvec3 local = turned(V, proxy.phi);
  const glm::dvec3 H = turned(sampleVisibleGGXAnisotropic(local, proxy.alpha, u), -proxy.phi);
  return 2 * glm::dot(V, H) * H - V;
}

double pdfProxy(const MeasuredProxy& proxy, const glm::dvec3& V, const glm::dvec3& L) {
  if (!(L.z > 0 && V.z > 0)) return 0;
  const double cosine = cosineChance(proxy);
  const glm::dvec3 S = V + L, H = S / std::max(glm::length(S), smallestCosine);
  const double VoH = std::max(glm::dot(V, H), smallestCosine);
  const double lobe = pdfVisibleGGXAnisotropic(turned(V, proxy.phi), turned(H, proxy.phi), proxy.alpha) / (4 * VoH);
  return cosine * L.z / pi + (1 - cosine) * lobe;
}

namespace {

template <class Value>
glm::dvec3 albedoOf(const MeasuredProxy& proxy, const glm::dvec3& V, uint32_t n, const Value& value) {
  glm::dvec3 sum{0};
  for (uint32_t i = 0; i < n; ++i) {
    const glm::dvec2 u = hammersley(i, n);
    // The choice: the golden ratio's multiples, apart from both of Hammersley's axes.
    const double choice = std::fmod((i + 0.5) * 0.6180339887498949, 1.0);
    const glm::dvec3 L = sampleProxy(proxy, V, u, choice);
    const double pdf = pdfProxy(proxy, V, L);
    if (pdf > 0) sum += value(L) * (L.z / pdf);
  }
  return sum / static_cast<double>(n);
}

}  // namespace

glm::dvec3 measuredAlbedo(const MeasuredBrdf& brdf, const MeasuredProxy& proxy, const glm::dvec3& V, LookUp lookUp,
                          uint32_t n) {
  return albedoOf(proxy, V, n, [&](const glm::dvec3& L) { return measuredBrdf(brdf, V, L, lookUp); });
}

glm::dvec3 analyticAlbedo(const AnalyticBrdf& brdf, const MeasuredProxy& proxy, const glm::dvec3& V, uint32_t n) {
  return albedoOf(proxy, V, n, [&](const glm::dvec3& L) { return analyticBrdf(brdf, V, L); });
}

}  // namespace facet::optics
