// Fits the specular lobe of a GGX surface by K look-ups in the LD chain, in the plane of N and V, and writes the table
// src/ibl/taps_table.inc. Not part of the program:
//   g++ -std=c++20 -O2 -Isrc -I. tools/fit_taps.cpp src/optics/{microfacet,quadrature}.cpp -o fit_taps
//   ./fit_taps > src/ibl/taps_table.inc
// For each (u = sqrt(NoV), perceptual roughness): the taps' tilt (sine of the angle to N over that of the mirror
// direction), perceptual roughness and weight (they sum to 1) that minimise, with p the lobe D V NoL / E (F = 1) and q
// the taps' kernels (D NoL of N = V = R),
//   int (p - q)^2 / int p^2 + |mean direction of p - of q|^2 / variance of p + a pull to the neighbours' parameters.
// Nelder-Mead from the mean of the neighbours that are there, from the middle outwards.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet;
using optics::pi;

namespace {

constexpr int size = 16;
// One tap has to meet the mean direction above all; several have the shape to follow.
double momentWeightOf(size_t taps) { return taps == 1 ? 3 : 0.5; }
constexpr double smoothness = 3e-3;
constexpr double unit = 65536;  // the table's 1

// tilt, roughness over the surface's, weight (the last tap's weight is what the others leave)
using Parameters = std::vector<double>;
struct Tap {
  double tilt, roughness, weight;
};

std::vector<Tap> tapsOf(const Parameters& p, double r, double sinV) {
  std::vector<Tap> taps;
  const size_t count = (p.size() + 1) / 3;
  double left = 1;
  for (size_t k = 0; k < count; ++k) {
    const double weight = k + 1 < count ? p[3 * k + 2] : left;
    left -= weight;
    taps.push_back({std::clamp(p[3 * k], -1 / sinV, 1 / sinV), std::clamp(p[3 * k + 1] * r, 1e-3, 1.0), weight});
  }
  return taps;
}

// Density over directions at NoL = mu of the kernel D NoL of N = V = R; its norm in closed form (src/ibl/kernel.cpp).
struct Kernel {
  double b, scale;
  explicit Kernel(double alpha) : b(std::min(alpha * alpha, 0.98)) {
    const double k = 1 - b, y = b + k / 2;
    const double total = b / (k * k) * ((1 + b) * (1 / b - 1 / y) - 2 * std::log(y / b));
    scale = b / (4 * pi * total);
  }
  double at(double mu) const {
    if (mu <= 0) return 0;
    const double y = b + (1 - b) * (1 - mu) / 2;
    return scale * mu / (y * y);
  }
};

struct Node {
  glm::dvec3 L;
  double p, weight;
};
struct Lobe {
  double r, sinV;
  std::vector<Node> nodes;
  double norm = 0, variance = 0, energy = 0;
  glm::dvec3 mean{0};
};

// Nodes in polar coordinates about the mirror direction, dense there and in the plane of N and V; one half (y > 0).
Lobe lobeOf(double NoV, double r) {
  Lobe lobe;
  lobe.r = r;
  lobe.sinV = std::max(std::sqrt(1 - NoV * NoV), 1e-3);
  const glm::dvec3 N(0, 0, 1), V(-lobe.sinV, 0, std::sqrt(1 - lobe.sinV * lobe.sinV));
  const glm::dvec3 R(-V.x, 0, V.z), X(R.z, 0, -R.x), Y(0, 1, 0);
  const double alpha = r * r, width = std::min(1.5 * alpha, 1.0);
  const optics::Quadrature radial = optics::gaussLegendre(44);
  constexpr int azimuths = 28;
  for (size_t i = 0; i < radial.nodes.size(); ++i) {
    const double s = pi / 2 * radial.nodes[i], tangent = width * std::tan(s);  // tan(t / 2)
    const double t = 2 * std::atan(tangent);
    const double dt = 2 / (1 + tangent * tangent) * width / (std::cos(s) * std::cos(s)) * pi / 2 * radial.weights[i];
    for (int j = 0; j < azimuths; ++j) {
      const double v = (j + 0.5) / azimuths;
      const double phi = pi * (v - std::sin(2 * pi * v) / (2 * pi)), dphi = pi * (1 - std::cos(2 * pi * v)) / azimuths;
      const glm::dvec3 L = std::cos(t) * R + std::sin(t) * (std::cos(phi) * X + std::sin(phi) * Y);
      double p = 0;
      if (L.z > 0) {
        const optics::Angles a = optics::anglesBetween(N, V, L);
        p = optics::D_GGX(a, alpha) * optics::V_SmithGGXCorrelated(a.NoV, a.NoL, alpha) * a.NoL;
      }
      const double weight = 2 * std::sin(t) * dt * dphi;
      lobe.nodes.push_back({L, p, weight});
      lobe.energy += p * weight;
    }
  }
  for (Node& n : lobe.nodes) {
    n.p /= lobe.energy;
    lobe.norm += n.p * n.p * n.weight;
    lobe.mean += n.p * n.weight * glm::dvec3(n.L.x, 0, n.L.z);
  }
  lobe.variance = std::max(1 - glm::dot(lobe.mean, lobe.mean), 1e-6);
  return lobe;
}

double cost(const Lobe& lobe, const Parameters& p, const Parameters* near) {
  const std::vector<Tap> taps = tapsOf(p, lobe.r, lobe.sinV);
  std::vector<Kernel> kernels;
  std::vector<glm::dvec3> directions;
  double penalty = 0;
  for (const Tap& tap : taps) {
    const double sine = std::clamp(tap.tilt * lobe.sinV, -1.0, 1.0);
    directions.emplace_back(sine, 0, std::sqrt(1 - sine * sine));
    kernels.emplace_back(tap.roughness * tap.roughness);
    if (tap.weight < 0.05) penalty += (0.05 - tap.weight) * (0.05 - tap.weight) * 100;
  }
  for (size_t k = 0; k < taps.size(); ++k) {
    const double over = std::max(p[3 * k + 1] * lobe.r - 1, 0.0), under = std::max(0.3 - p[3 * k + 1], 0.0);
    const double beyond = std::max(std::abs(p[3 * k] * lobe.sinV) - 1, 0.0);
    penalty += over * over + under * under + beyond * beyond;
  }
  double sum = 0;
  glm::dvec3 mean(0);
  for (const Node& n : lobe.nodes) {
    double q = 0;
    for (size_t k = 0; k < taps.size(); ++k) q += taps[k].weight * kernels[k].at(glm::dot(n.L, directions[k]));
    sum += (n.p - q) * (n.p - q) * n.weight;
    mean += q * n.weight * glm::dvec3(n.L.x, 0, n.L.z);
  }
  const glm::dvec3 off = mean - lobe.mean;
  double value = sum / lobe.norm + momentWeightOf(taps.size()) * glm::dot(off, off) / lobe.variance + penalty;
  if (near)
    for (size_t i = 0; i < p.size(); ++i) value += smoothness * (p[i] - (*near)[i]) * (p[i] - (*near)[i]);
  return value;
}

template <class F>
Parameters nelderMead(const F& f, const Parameters& start, double step, int evaluations) {
  const size_t n = start.size();
  struct Point {
    Parameters x;
    double y;
  };
  std::vector<Point> s{{start, f(start)}};
  for (size_t i = 0; i < n; ++i) {
    Parameters x = start;
    x[i] += step;
    s.push_back({x, f(x)});
  }
  const auto less = [](const Point& a, const Point& b) { return a.y < b.y; };
  for (int used = 0; used < evaluations;) {
    std::sort(s.begin(), s.end(), less);
    if (s.back().y - s.front().y < 1e-7) break;
    Parameters centre(n, 0);
    for (size_t i = 0; i < n; ++i)
      for (size_t k = 0; k < n; ++k) centre[k] += s[i].x[k] / static_cast<double>(n);
    const auto along = [&](double t) {
      Parameters x(n);
      for (size_t k = 0; k < n; ++k) x[k] = centre[k] + t * (s[n].x[k] - centre[k]);
      ++used;
      return Point{x, f(x)};
    };
    Point reflected = along(-1);
    if (reflected.y < s[0].y) {
      const Point expanded = along(-2);
      s[n] = expanded.y < reflected.y ? expanded : reflected;
    } else if (reflected.y < s[n - 1].y) {
      s[n] = reflected;
    } else {
      const Point contracted = along(reflected.y < s[n].y ? -0.5 : 0.5);
      if (contracted.y < std::min(reflected.y, s[n].y)) {
        s[n] = contracted;
      } else {
        for (size_t i = 1; i <= n; ++i) {
          for (size_t k = 0; k < n; ++k) s[i].x[k] = (s[i].x[k] + s[0].x[k]) / 2;
          s[i].y = f(s[i].x);
        }
        used += static_cast<int>(n);
      }
    }
  }
  return std::min_element(s.begin(), s.end(), less)->x;
}

std::vector<Parameters> fit(int count) {
  struct At {
    int x, y;
  };
  std::vector<At> order;
  for (int y = 1; y < size; ++y)
    for (int x = 0; x < size; ++x) order.push_back({x, y});
  const auto distance = [](const At& a) { return std::hypot(a.x - 0.55 * size, a.y - 0.5 * size); };
  std::sort(order.begin(), order.end(), [&](const At& a, const At& b) { return distance(a) < distance(b); });
  std::vector<Parameters> made(size * size);
  double worst = 0, total = 0;
  for (const At& at : order) {
    const double u = at.x / (size - 1.0);
    const Lobe lobe = lobeOf(std::clamp(u * u, 0.002, 0.9995), at.y / (size - 1.0));
    Parameters near(static_cast<size_t>(3 * count - 1), 0.0);
    int found = 0;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        const int x = at.x + dx, y = at.y + dy;
        if (x < 0 || y < 0 || x >= size || y >= size || made[size_t(y * size + x)].empty()) continue;
        for (size_t i = 0; i < near.size(); ++i) near[i] += made[size_t(y * size + x)][i];
        ++found;
      }
    Parameters best;
    if (found > 0) {
      for (double& p : near) p /= found;
      best = nelderMead([&](const Parameters& p) { return cost(lobe, p, &near); }, near, 0.04, 130 * count);
    } else {
      const Parameters starts[] = {{0.8, 1}, {0.6, 1.1, 0.5, 0.95, 0.8}, {0.4, 1.1, 0.3, 0.8, 0.9, 0.4, 1.0, 0.7}};
      best = nelderMead([&](const Parameters& p) { return cost(lobe, p, nullptr); }, starts[count - 1], 0.1, 2000);
    }
    made[size_t(at.y * size + at.x)] = best;
    const double left = cost(lobe, best, nullptr);
    worst = std::max(worst, left), total += left;
  }
  for (int x = 0; x < size; ++x) made[size_t(x)] = made[size_t(size + x)];
  std::fprintf(stderr, "%d taps: cost %.4f mean, %.4f worst\n", count, total / (size * (size - 1)), worst);
  return made;
}

}  // namespace

int main(int argc, char** argv) {
  const int only = argc > 1 ? std::atoi(argv[1]) : 0;
  for (int count = 1; count <= 3; ++count) {
    if (only != 0 && only != count) continue;
    const std::vector<Parameters> made = fit(count);
    for (int k = 0; k < count; ++k) {
      for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
          const double u = x / (size - 1.0), NoV = std::clamp(u * u, 0.002, 0.9995);
          const double sinV = std::sqrt(1 - NoV * NoV), r = y / (size - 1.0);
          Tap tap = tapsOf(made[size_t(y * size + x)], r, sinV)[size_t(k)];
          if (y == 0) tap.tilt = 1, tap.roughness = 0;
          std::printf("%.0f,%.0f,%.0f,", tap.tilt * unit, tap.roughness * unit, tap.weight * unit);
        }
        std::printf("\n");
      }
    }
  }
}
