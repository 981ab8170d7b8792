#include "optics/light_profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace facet::optics {

namespace {

constexpr double degree = std::numbers::pi / 180;

// Between knots[at] and knots[at + 1]; share of the latter.
struct Between {
  size_t at = 0;
  double share = 0;
  bool inside = false;
};

Between locate(std::span<const float> knots, double x) {
  if (!(x >= knots.front() && x <= knots.back())) return {};
  const auto above = std::ranges::upper_bound(knots, x, {}, [](float k) { return double{k}; });
  const size_t at = std::min(static_cast<size_t>(above - knots.begin()), knots.size() - 1) - 1;
  return {at, (x - knots[at]) / (double{knots[at + 1]} - knots[at]), true};
}

bool goesRound(const LightProfile& p) { return p.azimuth.back() - p.azimuth.front() >= 360; }

double mix(double a, double b, double share) { return a + share * (b - a); }

// The integral of the straight line from f0 at a to f1 at b times the sine, angles [rad].
double lineTimesSine(double a, double b, double f0, double f1) {
  const double slope = (f1 - f0) / (b - a);
  return f0 * std::cos(a) - f1 * std::cos(b) + slope * (std::sin(b) - std::sin(a));
}

}  // namespace

ProfileAngles profileAngles(Photometry photometry, const glm::dvec3& d) {
  glm::dvec3 local(d.x, d.y, -d.z);  // x where the azimuth is 0, y where it is 90 degrees, z the axis
  if (photometry == Photometry::a) local = glm::dvec3(-d.z, -d.y, d.x);
  if (photometry == Photometry::b) local = glm::dvec3(-d.z, d.x, -d.y);
  return {std::atan2(std::hypot(local.x, local.y), local.z) / degree, std::atan2(local.y, local.x) / degree};
}

double candela(const LightProfile& p, const glm::dvec3& direction) {
  const ProfileAngles angles = profileAngles(p.photometry, direction);
  const Between polar = locate(p.polar, angles.polar);
  if (!polar.inside) return 0;
  const auto along = [&](size_t azimuth) {
    const float* row = p.candela.data() + azimuth * p.polar.size() + polar.at;
    return mix(row[0], row[1], polar.share);
  };
  if (p.azimuth.size() == 1) return along(0);
  double azimuth = angles.azimuth;
  if (goesRound(p)) azimuth -= 360 * std::floor((azimuth - p.azimuth.front()) / 360);
  const Between side = locate(p.azimuth, azimuth);
  return side.inside ? mix(along(side.at), along(side.at + 1), side.share) : 0;
}

double lumens(const LightProfile& p) {
  const auto meridian = [&](size_t azimuth) {
    const float* row = p.candela.data() + azimuth * p.polar.size();
    double sum = 0;
    for (size_t i = 0; i + 1 < p.polar.size(); ++i)
      sum += lineTimesSine(p.polar[i] * degree, p.polar[i + 1] * degree, row[i], row[i + 1]);
    return sum;
  };
  if (p.azimuth.size() == 1) return 2 * std::numbers::pi * meridian(0);
  double sum = 0, before = meridian(0);
  for (size_t i = 1; i < p.azimuth.size(); ++i) {
    const double next = meridian(i);
    sum += (double{p.azimuth[i]} - p.azimuth[i - 1]) * degree * (before + next) / 2;
    before = next;
  }
  return sum;
}

}  // namespace facet::optics
