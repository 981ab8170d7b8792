#include "optics/color.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

using namespace facet::optics;

TEST_CASE("sRGB: known values, round trip, join") {
  CHECK(encodeSRGB(0.0) == 0);
  CHECK(encodeSRGB(1.0) == Approx(1).epsilon(1e-15));
  CHECK(decodeSRGB(128.0 / 255) == Approx(0.2158605).epsilon(1e-6));
  CHECK(encodeSRGB(0.18) == Approx(0.4613561).epsilon(1e-6));
  CHECK(decodeSRGB(1.0 / 255) == Approx(1.0 / 255 / 12.92).epsilon(1e-15));
  for (int i = 0; i <= 255; ++i) CHECK(encodeSRGB(decodeSRGB(i / 255.0)) == Approx(i / 255.0).margin(1e-12));
  CHECK(encodeSRGB(0.0031308 + 1e-12) == Approx(encodeSRGB(0.0031308)).margin(1e-7));
  CHECK(encodeSRGB(-0.5) < 0);
}

TEST_CASE("Tone mappers: values from their publications") {
  const auto grey = [](ToneMapper mapper, double x) { return toneMap(mapper, glm::dvec3(x)).x; };
  CHECK(grey(ToneMapper::none, 0.3) == 0.3);
  CHECK(grey(ToneMapper::none, 3) == 1);
  CHECK(grey(ToneMapper::reinhard, 1) == 0.5);
  CHECK(grey(ToneMapper::reinhard, 3) == 0.75);
  CHECK(encodeSRGB(grey(ToneMapper::reinhardPower, 3)) == Approx(std::pow(0.75, 1 / 2.2)).epsilon(1e-13));
  CHECK(grey(ToneMapper::reinhardPower, 0) == 0);
  CHECK(grey(ToneMapper::reinhardPower, 1e300) == Approx(1));

  // Hable: 5.6 x 2 is the white point; 1 through the published expression, by hand:
  // f(2) = (2 (0.3 + 0.05) + 0.004) / (2 (0.3 + 0.5) + 0.06) - 1 / 15, f(11.2) likewise.
  CHECK(grey(ToneMapper::uncharted2, 5.6) == Approx(1).epsilon(1e-14));
  const double f2 = 0.704 / 1.66 - 1.0 / 15, f11 = (11.2 * 1.73 + 0.004) / (11.2 * 2.18 + 0.06) - 1.0 / 15;
  CHECK(grey(ToneMapper::uncharted2, 1) == Approx(f2 / f11).epsilon(1e-13));

  // Hill: the matrices keep grey (rows add up to 1), so grey goes through the curve alone.
  CHECK(grey(ToneMapper::aces, 1) ==
        Approx((1.0245786 - 0.000090537) / (0.983729 + 0.4329510 + 0.238081)).epsilon(2e-5));
  CHECK(grey(ToneMapper::aces, 0.18) ==
        Approx((0.18 * 0.2045786 - 0.000090537) / (0.18 * (0.983729 * 0.18 + 0.4329510) + 0.238081)).epsilon(1e-4));
  // A pure red, by hand: inset (0.59719, 0.076, 0.0284).
  const glm::dvec3 red = toneMap(ToneMapper::aces, {1, 0, 0});
  const auto curve = [](double v) {
    return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.432951) + 0.238081);
  };
  const double r = curve(0.59719), g = curve(0.076), b = curve(0.0284);
  CHECK(red.x == Approx(1.60475 * r - 0.53108 * g - 0.07367 * b).epsilon(1e-12));
  CHECK(red.y == Approx(std::max(0.0, -0.10208 * r + 1.10813 * g - 0.00605 * b)).margin(1e-12));

  // AgX: middle grey lies at (log2 0.18 + 12.47393) / 16.499999 = 0.606060 of the range, where the sigmoid passes
  // 0.5 in the display's 2.2 encoding (the fit: within 0.01).
  CHECK(std::pow(grey(ToneMapper::agx, 0.18), 1 / 2.2) == Approx(0.5).margin(0.01));
  CHECK(grey(ToneMapper::agx, 16.3) == Approx(1).margin(5e-3));  // 2^4.026: the top of the range
  // Both matrix pairs keep grey: rows add up to 1 (AgX: within 1.4e-4). A slip in any one entry shows.
  for (double x : {0.05, 0.18, 0.5, 1.0}) {
    const glm::dvec3 aces = toneMap(ToneMapper::aces, glm::dvec3(x)), agx = toneMap(ToneMapper::agx, glm::dvec3(x));
    CHECK(glm::length(aces - glm::dvec3(aces.y)) < 2e-5);
    CHECK(glm::length(agx - glm::dvec3(agx.y)) < 3e-4);
  }
  // Red becomes lighter in all channels towards the end, never pure.
  const glm::dvec3 hot = toneMap(ToneMapper::agx, {1000, 0, 0});
  CHECK(hot.x > 0.9);
  CHECK(hot.y > 0.1);

  // PBR Neutral: colours up to 0.8 keep hue and saturation, lowered by F90 = 0.04; x^2 / 0.16 in the toe; peaks
  // compressed along 1 - 0.24^2 / (peak - 0.76 + 0.24).
  CHECK(grey(ToneMapper::pbrNeutral, 0.5) == Approx(0.46).epsilon(1e-14));
  CHECK(grey(ToneMapper::pbrNeutral, 0.04) == Approx(0.01).epsilon(1e-13));
  CHECK(grey(ToneMapper::pbrNeutral, 1) == Approx(1 - 0.0576 / 0.44).epsilon(1e-14));
  const glm::dvec3 sunset = toneMap(ToneMapper::pbrNeutral, {2.04, 0.54, 0.04});
  // offset = 0.03: peak 2.01, new peak p = 1 - 0.0576 / 1.49, desaturation g = 1 - 1 / (0.15 (2.01 - p) + 1).
  const double p = 1 - 0.0576 / 1.49, d = 1 - 1 / (0.15 * (2.01 - p) + 1);
  CHECK(sunset.x == Approx(p).epsilon(1e-13));
  CHECK(sunset.y == Approx(0.51 * p / 2.01 * (1 - d) + p * d).epsilon(1e-13));
  CHECK(sunset.z == Approx(0.01 * p / 2.01 * (1 - d) + p * d).epsilon(1e-13));
}

TEST_CASE("Tone mappers: black is black, greys are monotone, everything is in [0, 1]") {
  const double infinity = std::numeric_limits<double>::infinity(), nan = std::nan("");
  const double hostile[] = {0, -0.0, -1, -infinity, nan, 1e-320, 1e-30, 0.5, 65504, 1e15, 1e38, 1e308, infinity};
  for (const auto& [mapper, word, label, note] : toneMappers) {
    INFO(word);
    CHECK(toneMap(mapper, glm::dvec3(0)) == glm::dvec3(0));
    CHECK(toneMap(mapper, glm::dvec3(nan)) == glm::dvec3(0));
    CHECK(toneMap(mapper, glm::dvec3(infinity)).y > 0.98);
    double last = 0, drop = 0;
    for (int i = 0; i <= 4000; ++i) {
      const glm::dvec3 c = toneMap(mapper, glm::dvec3(std::exp2(-20 + 0.01 * i)));
      drop = std::max(drop, last - c.x);
      last = c.x;
    }
    CHECK(drop <= 1e-12);
    size_t outside = 0;
    for (double r : hostile)
      for (double g : hostile)
        for (double b : hostile) {
          const glm::dvec3 c = toneMap(mapper, {r, g, b});
          for (int k = 0; k < 3; ++k) outside += !(c[k] >= 0 && c[k] <= 1);
        }
    CHECK(outside == 0);
  }
}
