#include "optics/mapping.hpp"

#include <cmath>

#include "optics/microfacet.hpp"

namespace facet::optics {

namespace {

// Solid angle between the face's axis and the point (x, y) on the plane at distance 1, signed like x y.
double cornerSolidAngle(double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); }

}  // namespace

glm::dvec2 equirectFromDirection(const glm::dvec3& direction) {
  // asin(y / length) as atan2, which stays exact near the poles.
  const double level = std::hypot(direction.x, direction.z);
  return {std::atan2(direction.z, direction.x) / (2 * pi) + 0.5, std::atan2(direction.y, level) / pi + 0.5};
}

glm::dvec3 directionFromEquirect(const glm::dvec2& uv) {
  const double phi = (uv.x - 0.5) * 2 * pi, polar = (1 - uv.y) * pi;
  return {std::sin(polar) * std::cos(phi), std::cos(polar), std::sin(polar) * std::sin(phi)};
}

glm::dvec2 equirectTexelCentre(int column, int row, int width, int height) {
  return {(column + 0.5) / width, 1 - (row + 0.5) / height};
}

double equirectTexelSolidAngle(int row, int width, int height) {
  // cos a - cos b = 2 sin((a + b) / 2) sin((b - a) / 2)
  return 2 * pi / width * 2 * std::sin(pi * (row + 0.5) / height) * std::sin(pi / (2.0 * height));
}

double equirectTentSolidAngle(int row, int width, int height) {
  // One flank of the tent, of length s, from theta = a on: int_0^s (1 - t / s) sin(a + t) dt = cos a - (sin(a + s) -
  // sin a) / s, without the cancellation for small s; the flank towards smaller angles likewise with s < 0.
  const double s = pi / height, middle = s * (row + 0.5);
  const auto flank = [&](double side) {
    // cos a (1 - sin s / s) + sin a (1 - cos s) / s
    const double half = std::sin(s / 2);
    const double gap = s < 0.1 ? s * s / 6 * (1 - s * s / 20 * (1 - s * s / 42)) : 1 - std::sin(s) / s;
    return side * std::cos(middle) * gap + std::sin(middle) * 2 * half * half / s;
  };
  const double pole = 2 * std::sin(middle / 2) * std::sin(middle / 2);  // from the pole to the first row's centre
  const double above = row == 0 ? pole : flank(-1);
  const double below = row == height - 1 ? 2 * std::pow(std::sin((pi - middle) / 2), 2) : flank(1);
  return 2 * pi / width * (above + below);
}

CubePoint cubeFromDirection(const glm::dvec3& d) {
  const glm::dvec3 size = glm::abs(d);
  CubePoint point;
  double s = 0, t = 0, major = 0;
  if (size.x >= size.y && size.x >= size.z) {
    point.face = d.x >= 0 ? 0 : 1;
    s = d.x >= 0 ? -d.z : d.z;
    t = -d.y;
    major = size.x;
  } else if (size.y >= size.z) {
    point.face = d.y >= 0 ? 2 : 3;
    s = d.x;
    t = d.y >= 0 ? d.z : -d.z;
    major = size.y;
  } else {
    point.face = d.z >= 0 ? 4 : 5;
    s = d.z >= 0 ? d.x : -d.x;
    t = -d.y;
    major = size.z;
  }
  if (!(major > 0)) return {};
  point.uv = {(s / major + 1) / 2, (t / major + 1) / 2};
  return point;
}

glm::dvec3 directionFromCube(const CubePoint& point) {
  // Axes of the table: direction = major + s * right + t * down.
  static const glm::dvec3 axes[6][3] = {{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}}, {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},   {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                        {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},  {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}};
  const auto& [major, right, down] = axes[point.face];
  return glm::normalize(major + (2 * point.uv.x - 1) * right + (2 * point.uv.y - 1) * down);
}

double cubeTexelSolidAngle(int column, int row, int size) {
  const double x0 = 2.0 * column / size - 1, x1 = 2.0 * (column + 1) / size - 1;
  const double y0 = 2.0 * row / size - 1, y1 = 2.0 * (row + 1) / size - 1;
  return cornerSolidAngle(x1, y1) - cornerSolidAngle(x0, y1) - cornerSolidAngle(x1, y0) + cornerSolidAngle(x0, y0);
}

glm::dmat3 frameAround(const glm::dvec3& n) {
  const double s = n.z >= 0 ? 1 : -1, a = -1 / (s + n.z), b = n.x * n.y * a;
  return {{1 + s * n.x * n.x * a, s * b, -s * n.x}, {b, s + n.y * n.y * a, -n.y}, n};
}

}  // namespace facet::optics
