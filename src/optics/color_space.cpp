#include "optics/color_space.hpp"

#include <algorithm>
#include <cmath>

namespace facet::optics {

namespace {

// Of Y = 1.
glm::dvec3 xyz(const glm::dvec2& c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

bool isFinite(const glm::dmat3& m) {
  double sum = 0;  // NaN and Inf survive a product with zero
  for (int i = 0; i < 3; ++i) sum += glm::dot(m[i], glm::dvec3(0));
  return sum == 0;
}

glm::dmat3 adapted(const glm::dvec3& fromWhite, const glm::dvec3& toWhite) {
  const glm::dmat3 cones =
      glm::transpose(glm::dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const glm::dvec3 scale = (cones * toWhite) / (cones * fromWhite);
  return glm::inverse(cones) * glm::dmat3(scale.x, 0, 0, 0, scale.y, 0, 0, 0, scale.z) * cones;
}

}  // namespace

bool isRec709(const Chromaticities& c) {
  const Chromaticities r;
  const auto same = [](const glm::dvec2& a, const glm::dvec2& b) {
    return std::abs(a.x - b.x) < 5e-4 && std::abs(a.y - b.y) < 5e-4;
  };
  return same(c.red, r.red) && same(c.green, r.green) && same(c.blue, r.blue) && same(c.white, r.white);
}

std::optional<glm::dmat3> xyzFromRgb(const Chromaticities& c) {
  // Columns with x + y + z = 1, so that a primary with y = 0 (ACES has nearly one) is none of the ends.
  const auto column = [](const glm::dvec2& p) { return glm::dvec3(p.x, p.y, 1 - p.x - p.y); };
  const glm::dmat3 primaries(column(c.red), column(c.green), column(c.blue));
  if (!(std::abs(glm::determinant(primaries)) > 1e-4) || !(c.white.y > 1e-3)) return std::nullopt;
  const glm::dvec3 scale = glm::inverse(primaries) * xyz(c.white);
  const glm::dmat3 m(primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z);
  if (!isFinite(m) || !(std::min({scale.x, scale.y, scale.z}) > 0)) return std::nullopt;
  return m;
}

glm::dmat3 rec709FromXyz() { return glm::inverse(*xyzFromRgb({})); }

std::optional<glm::dmat3> rec709FromRgb(const Chromaticities& c) {
  const auto m = xyzFromRgb(c);
  if (!m) return std::nullopt;
  return rec709FromXyz() * adapted(xyz(c.white), xyz(Chromaticities{}.white)) * *m;
}

}  // namespace facet::optics
