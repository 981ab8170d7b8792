#include "optics/reference.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/parallel.hpp"
#include "optics/fresnel.hpp"
#include "optics/mapping.hpp"
#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"
#include "optics/sheen.hpp"

namespace facet::optics {

namespace {

constexpr double mirrorAlpha = 1e-9;

glm::dvec3 texel(const Environment& environment, int column, int row) {
  const int x = (column % environment.width + environment.width) % environment.width;
  const int y = std::clamp(row, 0, environment.height - 1);
  return glm::dvec3(environment.radiance[size_t(y) * size_t(environment.width) + size_t(x)]);
}

// A lobe's value: two components (1 - Fc and Fc; or one and nothing), or one of each channel.
template <class Lobe>
using ValueOf = decltype(std::declval<Lobe>().value(glm::dvec3()));

template <class Value>
struct Sum {
  glm::dvec3 radiance[2] = {glm::dvec3(0), glm::dvec3(0)};  // by component; by channel: the first
  Value weight{0};
  void add(const glm::dvec3& texel, const Value& value) {
    if constexpr (std::is_same_v<Value, glm::dvec3>) {
      radiance[0] += texel * value;
    } else {
      radiance[0] += texel * value.x;
      radiance[1] += texel * value.y;
    }
    weight += value;
  }
  void add(const Sum& other) {
    for (int k = 0; k < 2; ++k) radiance[k] += other.radiance[k];
    weight += other.weight;
  }
};

// Lobe against the four bilinear weights of a cell, corner = 2 * (lower row) + (right column).
template <class Value>
struct Moments {
  Value corner[4] = {};
};

struct Range {
  double a, b;
  double size() const { return b - a; }
  double middle() const { return a + (b - a) / 2; }
};

// One cell of the reconstruction, in longitude phi = 2 pi u and polar angle theta = pi (1 - v).
struct Cell {
  Range phi, theta;        // what of it is integrated
  Range phiAll, thetaAll;  // where the corner texels lie
};

const Quadrature& rule(size_t n) {
  static const Quadrature two = gaussLegendre(2), four = gaussLegendre(4);
  return n == 2 ? two : four;
}

glm::dvec3 fromAngles(double phi, double theta) { return directionFromEquirect({phi / (2 * pi), 1 - theta / pi}); }

template <class Lobe>
void integrate(const Cell& cell, const Lobe& lobe, size_t n, Moments<ValueOf<Lobe>>& moments) {
  const Quadrature& nodes = rule(n);
  for (size_t i = 0; i < n; ++i) {
    const double theta = cell.theta.a + cell.theta.size() * nodes.nodes[i];
    const double sine = std::sin(theta), cosine = std::cos(theta);
    const double t = std::clamp((theta - cell.thetaAll.a) / cell.thetaAll.size(), 0.0, 1.0);
    const double area = cell.theta.size() * cell.phi.size() * sine * nodes.weights[i];
    for (size_t k = 0; k < n; ++k) {
      const double phi = cell.phi.a + cell.phi.size() * nodes.nodes[k];
      const double s = (phi - cell.phiAll.a) / cell.phiAll.size();
      const glm::dvec3 direction(-sine * std::cos(phi), cosine, -sine * std::sin(phi));  // u = 1/2 is +X
      const ValueOf<Lobe> value = lobe.value(direction) * (area * nodes.weights[k]);
      moments.corner[0] += value * ((1 - s) * (1 - t));
      moments.corner[1] += value * (s * (1 - t));
      moments.corner[2] += value * ((1 - s) * t);
      moments.corner[3] += value * (s * t);
    }
  }
}

template <class Lobe>
void refine(const Cell& cell, const Lobe& lobe, int depth, Moments<ValueOf<Lobe>>& moments) {
  const double widest =
      cell.theta.a < pi / 2 && cell.theta.b > pi / 2 ? 1 : std::max(std::sin(cell.theta.a), std::sin(cell.theta.b));
  const double width = cell.phi.size() * widest, height = cell.theta.size();
  const double radius = (width + height) / 2;
  const glm::dvec3 centre = fromAngles(cell.phi.middle(), cell.theta.middle());
  if (glm::dot(centre, lobe.normal) < -radius) return;  // all below the horizon
  const double scale = lobe.scale(centre, radius);
  const double extent = std::max(width, height);
  // A long arc of longitudes turns even where it is short, at a pole.
  const bool arc = cell.phi.size() > 0.8;
  if (depth > 0 && (extent > 0.5 * scale || arc)) {
    Cell first = cell, second = cell;
    if (width > height || arc) {
      first.phi.b = second.phi.a = cell.phi.middle();
    } else {
      first.theta.b = second.theta.a = cell.theta.middle();
    }
    refine(first, lobe, depth - 1, moments);
    refine(second, lobe, depth - 1, moments);
    return;
  }
  integrate(cell, lobe, extent > 0.05 * scale ? 4 : 2, moments);
}

template <class Lobe>
Sum<ValueOf<Lobe>> overRow(const Environment& environment, const Lobe& lobe, int row) {
  const double dPhi = 2 * pi / environment.width, dTheta = pi / environment.height;
  using Value = ValueOf<Lobe>;
  Sum<Value> sum;
  for (int column = 0; column < environment.width; ++column) {
    Cell cell;
    cell.phiAll = cell.phi = {(column + 0.5) * dPhi, (column + 1.5) * dPhi};
    cell.thetaAll = {(row - 0.5) * dTheta, (row + 0.5) * dTheta};
    cell.theta = {std::max(cell.thetaAll.a, 0.0), std::min(cell.thetaAll.b, pi)};
    Moments<Value> moments;
    refine(cell, lobe, 64, moments);
    for (int corner = 0; corner < 4; ++corner)
      if (moments.corner[corner] != Value(0))
        sum.add(texel(environment, column + corner % 2, row - 1 + corner / 2), moments.corner[corner]);
  }
  return sum;
}

// Rows in parallel, added up in order: the same bits every time.
template <class Lobe>
Sum<ValueOf<Lobe>> overSphere(const Environment& environment, const Lobe& lobe) {
  std::vector<Sum<ValueOf<Lobe>>> rows(size_t(environment.height) + 1);
  parallelFor(rows.size(), [&](size_t row) { rows[row] = overRow(environment, lobe, static_cast<int>(row)); });
  Sum<ValueOf<Lobe>> sum;
  for (const auto& row : rows) sum.add(row);
  return sum;
}

// Scale near the horizon, where max(NoL, 0) has its kink: cells that straddle it are at most half of `atHorizon` wide.
double horizonScale(const glm::dvec3& direction, const glm::dvec3& normal, double radius, double atHorizon) {
  return std::max(std::abs(glm::dot(direction, normal)) - radius, 0.0) + atHorizon;
}

struct CosineLobe {
  glm::dvec3 normal;
  glm::dvec2 value(const glm::dvec3& l) const { return {std::max(glm::dot(normal, l), 0.0), 0}; }
  double scale(const glm::dvec3& l, double radius) const {
    return std::min(1.0, horizonScale(l, normal, radius, 0.02));
  }
};

// D / 4 times w, V = N: the half vector bisects N and L. Its angle from |N - L| rather than from NoL.
struct PrefilterLobe {
  glm::dvec3 normal;
  double alpha;
  LobeWeight weight;

  glm::dvec2 value(const glm::dvec3& l) const {
    const glm::dvec3 chord = l - normal;
    const double sin2 = glm::dot(chord, chord) / 4;
    const double NoL = 1 - 2 * sin2;
    if (NoL <= 0) return glm::dvec2(0);
    return {D_GGXFromSin2(sin2, alpha) / 4 * (weight == LobeWeight::NoL ? NoL : G1_GGX(NoL, alpha)), 0};
  }
  double scale(const glm::dvec3& l, double radius) const {
    const double sine = std::max(glm::length(l - normal) - radius, 0.0) / 2;
    const double atHorizon = weight == LobeWeight::NoL ? 0.02 : 0.02 * std::max(alpha, 0.05);
    return std::min({1.0, 2 * std::sqrt(alpha * alpha + sine * sine), horizonScale(l, normal, radius, atHorizon)});
  }
};

struct SpecularLobe {
  glm::dvec3 normal, view;
  double alpha, atHorizon;

  SpecularLobe(const glm::dvec3& n, const glm::dvec3& v, double a) : normal(n), view(v), alpha(a) {
    // V NoL rises from 0 to its plateau over NoL = alpha NoV / (NoV + sqrt(NoV^2 + alpha^2 sin^2)).
    const double NoV = glm::dot(n, v);
    const double rise = alpha * NoV / (NoV + std::sqrt(NoV * NoV + alpha * alpha * (1 - NoV * NoV)));
    atHorizon = std::clamp(0.1 * rise, 1e-4, 0.02);
  }
  glm::dvec2 value(const glm::dvec3& l) const {
    if (glm::dot(normal, l) <= 0) return glm::dvec2(0);
    const Angles angles = anglesBetween(normal, view, l);
    const double f = D_GGX(angles, alpha) * V_SmithGGXCorrelated(angles.NoV, angles.NoL, alpha) * angles.NoL;
    const double Fc = schlickWeight(angles.VoH);
    return {f * (1 - Fc), f * Fc};
  }
  double scale(const glm::dvec3& l, double radius) const {
    // L moves H by half in the plane of V and L, and by 1 / (2 VoH) across it.
    const Angles angles = anglesBetween(normal, view, l);
    const double VoH = std::max(angles.VoH - radius / 2, 0.01);
    const double sine = std::max(std::sqrt(angles.sin2NoH) - radius / (2 * VoH), 0.0);
    return std::min(
        {VoH, 2 * VoH * std::sqrt(alpha * alpha + sine * sine), horizonScale(l, normal, radius, atHorizon)});
  }
};

struct AnisotropicLobe {
  glm::dvec3 normal, tangent, bitangent, view;
  AnisotropicAlpha alpha;

  glm::dvec3 local(const glm::dvec3& d) const {
    return {glm::dot(tangent, d), glm::dot(bitangent, d), glm::dot(normal, d)};
  }
  glm::dvec2 value(const glm::dvec3& l) const {
    const Angles angles = anglesBetween(normal, view, l);
    if (angles.NoL <= 0) return glm::dvec2(0);
    return {D_GGXAnisotropic(local(angles.H), alpha) * V_GGXAnisotropic(local(view), local(l), alpha) * angles.NoL, 0};
  }
  double scale(const glm::dvec3& l, double radius) const {
    const Angles angles = anglesBetween(normal, view, l);
    const double VoH = std::max(angles.VoH - radius / 2, 0.01);
    const double across = std::max(std::abs(glm::dot(bitangent, angles.H)) - radius / (2 * VoH), 0.0);
    return std::min({VoH, 2 * VoH * std::sqrt(alpha.b * alpha.b + across * across),
                     horizonScale(l, normal, radius, std::clamp(0.1 * alpha.b, 1e-4, 0.02))});
  }
};

// The table's interpolation has kinks at each of its cells: what is left of them is the error of the nodes.
struct MeasuredLobe {
  const MeasuredBrdf& brdf;
  MeasuredProxy proxy;
  glm::dvec3 normal, tangent, bitangent, view;  // view in the frame of the three
  LookUp lookUp;

  glm::dvec3 local(const glm::dvec3& d) const {
    return {glm::dot(tangent, d), glm::dot(bitangent, d), glm::dot(normal, d)};
  }
  glm::dvec3 value(const glm::dvec3& l) const {
    const glm::dvec3 L = local(l);
    return L.z > 0 ? measuredBrdf(brdf, view, L, lookUp) * L.z : glm::dvec3(0);
  }
  double scale(const glm::dvec3& l, double radius) const {
    const glm::dvec3 S = view + local(l), H = S / std::max(glm::length(S), smallestCosine);
    const double VoH = std::max(glm::dot(view, H) - radius / 2, 0.01);
    const double narrow = std::min(proxy.alpha.t, proxy.alpha.b);
    const double sine = std::max(std::sqrt(H.x * H.x + H.y * H.y) - radius / (2 * VoH), 0.0);
    // One lobe's width across is as good as the other's along only where both are the same.
    const double distance = narrow / std::max(proxy.alpha.t, proxy.alpha.b) * sine;
    return std::min({1.0, VoH, 2 * VoH * std::sqrt(narrow * narrow + distance * distance),
                     horizonScale(l, normal, radius, std::clamp(0.1 * narrow, 1e-3, 0.02))});
  }
};

struct SheenLobe {
  glm::dvec3 normal, view;
  double alpha;

  glm::dvec2 value(const glm::dvec3& l) const {
    const Angles angles = anglesBetween(normal, view, l);
    if (angles.NoL <= 0) return glm::dvec2(0);
    return {D_Charlie(angles.NoH, alpha) * V_Charlie(angles.NoV, angles.NoL, alpha) * angles.NoL, 0};
  }
  // D varies over angles of sqrt(alpha), and where L nears -V within NoV.
  double scale(const glm::dvec3& l, double radius) const {
    const double sum = std::max(glm::length(view + l) - radius, 0.02);
    return std::min({0.5 * std::sqrt(alpha), 0.5 * sum, horizonScale(l, normal, radius, 0.01)});
  }
};

// int D w / 4 dl in closed form up to a smooth integral in one variable: u = tan^2 / (tan^2 + alpha^2) of the half
// angle, NoL = (1 - tan^2) / (1 + tan^2).
double prefilterWeight(double alpha, LobeWeight weight) {
  const double a = alpha * alpha;
  const auto f = [&](double u) {
    const double tan2 = a * u / (1 - u);
    const double NoL = std::max((1 - tan2) / (1 + tan2), 0.0);
    return weight == LobeWeight::NoL ? NoL : G1_GGX(NoL, alpha);
  };
  return integrateAdaptive<double>(f, 0, 1 / (1 + a), 1e-10);
}

}  // namespace

glm::dvec3 radianceAt(const Environment& environment, const glm::dvec3& direction) {
  const glm::dvec2 uv = equirectFromDirection(direction);
  const double x = uv.x * environment.width - 0.5, y = (1 - uv.y) * environment.height - 0.5;
  const double column = std::floor(x), row = std::floor(y);
  const int i = static_cast<int>(column), k = static_cast<int>(row);
  const auto across = [&](int r) {
    return glm::mix(texel(environment, i, r), texel(environment, i + 1, r), x - column);
  };
  return glm::mix(across(k), across(k + 1), y - row);
}

Reference irradiance(const Environment& environment, const glm::dvec3& n) {
  const auto sum = overSphere(environment, CosineLobe{n});
  return {sum.radiance[0] * (pi / sum.weight.x), sum.weight.x / pi};
}

Reference prefiltered(const Environment& environment, const glm::dvec3& n, double alpha, LobeWeight weight) {
  if (alpha < mirrorAlpha) return {radianceAt(environment, n), 1};
  const auto sum = overSphere(environment, PrefilterLobe{n, alpha, weight});
  return {sum.radiance[0] / sum.weight.x, sum.weight.x / prefilterWeight(alpha, weight)};
}

SpecularReference specular(const Environment& environment, const glm::dvec3& N, const glm::dvec3& V, double alpha) {
  if (alpha < mirrorAlpha) {
    const Dfg dfg = integrateDfg(glm::dot(N, V), 0);
    const glm::dvec3 mirrored = radianceAt(environment, glm::reflect(-V, N));
    return {mirrored * dfg.A, mirrored * dfg.B, dfg};
  }
  const auto sum = overSphere(environment, SpecularLobe(N, V, alpha));
  return {sum.radiance[0], sum.radiance[1], {sum.weight.x, sum.weight.y}};
}

Reference anisotropic(const Environment& environment, const glm::dvec3& N, const glm::dvec3& T, const glm::dvec3& V,
                      const AnisotropicAlpha& alpha) {
  const auto sum = overSphere(environment, AnisotropicLobe{N, T, glm::cross(N, T), V, alpha});
  return {sum.radiance[0] / sum.weight.x, sum.weight.x};
}

Reference sheen(const Environment& environment, const glm::dvec3& N, const glm::dvec3& V, double alpha) {
  const auto sum = overSphere(environment, SheenLobe{N, V, alpha});
  return {sum.radiance[0] / sum.weight.x, sum.weight.x};
}

MeasuredReference measured(const Environment& environment, const glm::dvec3& N, const glm::dvec3& T,
                           const glm::dvec3& V, const MeasuredBrdf& brdf, const MeasuredProxy& proxy, LookUp lookUp) {
  MeasuredLobe lobe{brdf, proxy, N, T, glm::cross(N, T), V, lookUp};
  lobe.view = lobe.local(V);
  const auto sum = overSphere(environment, lobe);
  return {sum.radiance[0], sum.weight};
}

}  // namespace facet::optics
