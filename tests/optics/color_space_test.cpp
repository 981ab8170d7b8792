#include "optics/color_space.hpp"

#include <catch2/catch.hpp>

namespace {

using namespace facet::optics;

// Rows, as tables print them.
void checkMatrix(const glm::dmat3& m, const double (&rows)[9], double margin) {
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      INFO(row << ", " << column);
      CHECK(m[column][row] == Approx(rows[3 * row + column]).margin(margin));
    }
}

const Chromaticities rec2020{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}, {0.3127, 0.3290}};
const Chromaticities displayP3{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}, {0.3127, 0.3290}};
const Chromaticities ap0{{0.7347, 0.2653}, {0, 1}, {0.0001, -0.0770}, {0.32168, 0.33767}};

}  // namespace

TEST_CASE("Rec. 709's XYZ is that of its standard", "[optics][color]") {
  // IEC 61966-2-1, to its four digits.
  checkMatrix(*xyzFromRgb({}), {0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505}, 6e-5);
  CHECK(isRec709({}));
  CHECK(isRec709({{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}, {0.31271, 0.32902}}));
  CHECK_FALSE(isRec709(rec2020));
}

TEST_CASE("Other primaries become Rec. 709 by the published matrices", "[optics][color]") {
  // ITU-R BT.2087-0, table 2 inverted (BT.2407, annex 1): Rec. 2020 to Rec. 709.
  checkMatrix(*rec709FromRgb(rec2020), {1.6605, -0.5876, -0.0728, -0.1246, 1.1329, -0.0083, -0.0182, -0.1006, 1.1187},
              1e-4);
  checkMatrix(*rec709FromRgb(displayP3), {1.2249, -0.2249, 0, -0.0420, 1.0420, 0, -0.0197, -0.0786, 1.0983}, 1e-4);
  // ACES AP0 with Bradford from D60 (colour-science and OpenColorIO print these).
  checkMatrix(*rec709FromRgb(ap0), {2.5217, -1.1341, -0.3876, -0.2765, 1.3727, -0.0962, -0.0154, -0.1530, 1.1684},
              2e-3);
}

TEST_CASE("White stays white, and Rec. 709 what it is", "[optics][color]") {
  for (const Chromaticities& c : {rec2020, displayP3, ap0, Chromaticities{}}) {
    const glm::dvec3 white = *rec709FromRgb(c) * glm::dvec3(1);
    for (int i = 0; i < 3; ++i) CHECK(white[i] == Approx(1).epsilon(1e-12));
  }
  checkMatrix(*rec709FromRgb({}), {1, 0, 0, 0, 1, 0, 0, 0, 1}, 1e-12);
  const glm::dvec3 d65 = rec709FromXyz() * glm::dvec3(0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290);
  for (int i = 0; i < 3; ++i) CHECK(d65[i] == Approx(1).epsilon(1e-12));
}

TEST_CASE("Primaries that span nothing are none", "[optics][color]") {
  CHECK_FALSE(rec709FromRgb({{0, 0}, {0, 0}, {0, 0}, {0, 0}}));
  CHECK_FALSE(rec709FromRgb({{0.3, 0.3}, {0.4, 0.4}, {0.5, 0.5}, {0.3127, 0.3290}}));   // on a line
  CHECK_FALSE(rec709FromRgb({{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.9, 0.05}}));  // white outside
  CHECK_FALSE(rec709FromRgb({{0.64, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0}}));
  CHECK_FALSE(rec709FromRgb({{NAN, 0.33}, {0.30, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}}));
  CHECK_FALSE(rec709FromRgb({{0.64, 0.33}, {INFINITY, 0.60}, {0.15, 0.06}, {0.3127, 0.3290}}));
}
