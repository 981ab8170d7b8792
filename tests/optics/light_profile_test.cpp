#include "optics/light_profile.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "base/angle.hpp"
#include "io/ies.hpp"

namespace facet::test::light_profiles {

using optics::LightProfile;
using optics::Photometry;

namespace {

LightProfile read(const std::string& text) {
  Notes notes;
  const auto profile =
      io::readIes({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "lamp.ies", "/p", notes);
  INFO((profile ? std::string() : describe(profile.error())));
  REQUIRE(profile.has_value());
  CHECK(notes.empty());
  return *profile;
}

// type: 1 C, 2 B, 3 A.
std::string ies(int type, const std::vector<double>& vertical, const std::vector<double>& horizontal,
                const std::function<double(double v, double h)>& candela, const char* factors = "1 1 0") {
  std::string text = "IESNA:LM-63-2002\r\n[TEST] made here\r\nTILT=NONE\r\n1 -1 2 " + std::to_string(vertical.size()) +
                     " " + std::to_string(horizontal.size()) + " " + std::to_string(type) + " 2 0.1 0.1 0\r\n" +
                     factors + "\r\n";
  const auto add = [&](double value) { text += std::to_string(value) + "\r\n"; };
  for (const double v : vertical) add(v);
  for (const double h : horizontal) add(h);
  for (const double h : horizontal)
    for (const double v : vertical) add(candela(v, h));
  return text;
}

std::vector<double> steps(double from, double to, double step) {
  std::vector<double> out;
  for (double x = from; x <= to + 1e-9; x += step) out.push_back(x);
  return out;
}

// Type C: of the angles [degrees], as EXT_lights_ies puts them: aimed along -Z, from +X to +Y.
glm::dvec3 directionC(double v, double h) {
  v *= pi / 180, h *= pi / 180;
  return {std::sin(v) * std::cos(h), std::sin(v) * std::sin(h), -std::cos(v)};
}

// The integral over the sphere by a sum over many directions.
double flux(const LightProfile& profile) {
  constexpr int rows = 720;
  double sum = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < 2 * rows; ++column) {
      const double v = 180 * (row + 0.5) / rows, h = 180 * (column + 0.5) / rows;
      sum += optics::candela(profile, directionC(v, h)) * std::sin(v * pi / 180) * (pi / rows) * (pi / rows);
    }
  return sum;
}

}  // namespace

TEST_CASE("Light profiles: between angles the intensity is bilinear, at them it is the file's", "[optics]") {
  const auto measured = [](double v, double h) { return 10 + v * 0.5 + h * 0.25 + v * h * 0.01; };
  const LightProfile p = read(ies(1, {0, 30, 45, 90, 180}, {0, 50, 200, 360}, measured));
  CHECK(p.mostCandela == Approx(2 * measured(180, 360)));
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  double worst = 0;
  for (int i = 0; i < 10000; ++i) {
    const double v = 180 * uniform(random), h = 359.9 * uniform(random);
    const double expected = 2 * measured(v, h);  // bilinear itself; the multiplier is 2
    worst = std::max(worst, std::abs(optics::candela(p, directionC(v, h)) / expected - 1));
  }
  CHECK(worst < 1e-6);
  CHECK(optics::candela(p, 17.0 * directionC(30, 50)) == Approx(2 * measured(30, 50)).epsilon(1e-7));
}

TEST_CASE("Light profiles: one that is constant is the constant, and its flux 4 pi of it", "[optics]") {
  const LightProfile p = read(ies(1, {0, 90, 180}, {0, 90, 180, 270, 360}, [](double, double) { return 3.7; }));
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 1000; ++i)
    CHECK(optics::candela(p, {normal(random), normal(random), normal(random)}) == double{7.4f});
  CHECK(optics::lumens(p) == Approx(4 * pi * 7.4).epsilon(1e-7));
}

TEST_CASE("Light profiles: horizontal angles that end early stand for their mirror images", "[optics]") {
  const std::vector<double> v = {0, 60, 90};
  // Even under the mirrors that each range stands for.
  const auto quadrants = [](double vertical, double h) { return 5 + vertical / 90 * std::cos(2 * h * pi / 180); };
  const auto halves = [](double vertical, double h) { return 5 + vertical / 90 * std::cos(h * pi / 180); };
  const auto sideways = [](double vertical, double h) { return 5 + vertical / 90 * std::sin(h * pi / 180); };
  const LightProfile q = read(ies(1, v, steps(0, 90, 10), quadrants)),
                     q360 = read(ies(1, v, steps(0, 360, 10), quadrants));
  const LightProfile h = read(ies(1, v, steps(0, 180, 10), halves)), h360 = read(ies(1, v, steps(0, 360, 10), halves));
  const LightProfile s = read(ies(1, v, steps(90, 270, 10), sideways)),
                     s360 = read(ies(1, v, steps(0, 360, 10), sideways));
  const LightProfile all = read(ies(1, v, {0}, [](double vertical, double) { return 1 + vertical; }));
  for (double vertical = 1; vertical < 90; vertical += 7.3)
    for (double angle = 0.5; angle < 360; angle += 3.1) {
      const glm::dvec3 d = directionC(vertical, angle);
      CHECK(optics::candela(q, d) == Approx(optics::candela(q360, d)).epsilon(1e-6));
      CHECK(optics::candela(h, d) == Approx(optics::candela(h360, d)).epsilon(1e-6));
      CHECK(optics::candela(s, d) == Approx(optics::candela(s360, d)).epsilon(1e-6));
      CHECK(optics::candela(all, d) == Approx(2 * (1 + vertical)).epsilon(1e-6));
    }
  CHECK(optics::lumens(q) == Approx(optics::lumens(q360)).epsilon(1e-6));
  CHECK(optics::candela(q, directionC(91, 20)) == 0);  // nothing was measured there
}

TEST_CASE("Light profiles: lumens are the integral over the sphere", "[optics]") {
  // Lambert's lamp of 100 cd: pi * 100 lm, but for what lines between 1 degree leave.
  const LightProfile lambert =
      read(ies(1, steps(0, 90, 1), {0}, [](double v, double) { return 50 * std::cos(v * pi / 180); }));
  CHECK(optics::lumens(lambert) == Approx(100 * pi).epsilon(1e-4));
  const auto odd = [](double a, double b) { return 200 + a + 0.3 * b; };
  for (const LightProfile& p : {lambert, read(ies(1, {0, 20, 90, 120}, {0, 30, 180, 300, 360}, odd)),
                                read(ies(2, steps(-90, 90, 30), steps(-90, 90, 45), odd)),
                                read(ies(3, steps(-90, 90, 30), steps(0, 90, 45), odd))})
    CHECK(flux(p) == Approx(optics::lumens(p)).epsilon(2e-4));
}

TEST_CASE("Light profiles: photometry of types A and B turns about the other axes", "[optics]") {
  const auto measured = [](double v, double h) { return 1000 + v + 3 * h; };
  const std::vector<double> v = steps(-90, 90, 15), h = steps(-90, 90, 30);
  const LightProfile a = read(ies(3, v, h, measured)), b = read(ies(2, v, h, measured));
  CHECK(a.photometry == Photometry::a);
  CHECK(b.photometry == Photometry::b);
  const double rad = pi / 180;
  for (double vertical = -80; vertical <= 80; vertical += 16.3)
    for (double horizontal = -80; horizontal <= 80; horizontal += 13.7) {
      const double cv = std::cos(vertical * rad), sv = std::sin(vertical * rad), ch = std::cos(horizontal * rad),
                   sh = std::sin(horizontal * rad);
      // Horizontal angles are clockwise seen from above, where up is +X of a lamp that is aimed at the horizon (A), and
      // +Z of one that is aimed down (B).
      const double expected = 2 * measured(vertical, horizontal);
      CHECK(optics::candela(a, {sv, -sh * cv, -ch * cv}) == Approx(expected).epsilon(1e-6));
      CHECK(optics::candela(b, {ch * sv, -sh, -ch * cv}) == Approx(expected).epsilon(1e-6));
    }
  CHECK(optics::candela(a, {0, 0.1, 1}) == 0);
  CHECK(optics::candela(b, {0, 0.1, 1}) == 0);
  // From 0 on: laterally symmetric.
  const LightProfile half = read(ies(2, v, steps(0, 90, 30), [](double, double angle) { return 10 + angle; }));
  CHECK(optics::candela(half, {0.1, 0.4, -1}) == Approx(optics::candela(half, {0.1, -0.4, -1})));
}

TEST_CASE("Light profiles: the ballast's factors count, the lamp's tilt does not", "[io]") {
  const auto two = [](double, double) { return 2.0; };
  CHECK(read(ies(1, {0, 90}, {0}, two, "0.5 0.8 100")).mostCandela == Approx(2 * 2 * 0.5 * 0.8));
  Notes notes;
  const std::string text =
      "\xEF\xBB\xBFTILT=INCLUDE\n1\n2\n0 90\n1 0.5\n1,1000,1,2,1,1,1,0,0,0\n1 1 +60\n0 90\n0\n3 -1\n";
  const auto profile =
      io::readIes({reinterpret_cast<const uint8_t*>(text.data()), text.size()}, "old.ies", "/p", notes);
  REQUIRE(profile.has_value());
  CHECK(profile->candela == std::vector<float>{3, 0});
  REQUIRE(notes.size() == 3);
  CHECK(notes[0].text == "old.ies: has no first line that names LM-63: read as of 1986");
  CHECK(notes[1].text == "old.ies: its tilt of the lamp is not looked at");
  CHECK(notes[2].text == "old.ies: 1 intensities are negative: they count as 0");
}

TEST_CASE("Light profiles: what is broken is one sentence", "[io]") {
  const std::string head = "IESNA:LM-63-2002\nTILT=NONE\n";
  const struct {
    std::string text;
    const char* says;
  } rows[] = {
      {"", "lamp.ies: has no line TILT=, so it is no IES file (LM-63); name a light profile that is one."},
      {head + "1 1000 1 2",
       "lamp.ies: line 3: ends before the number of horizontal angles; get the file again from its maker."},
      {head + "1 x 1",
       "lamp.ies: line 3: the lumens of a lamp is no number: \"x\"; get the file again from its maker."},
      {head + "1 1 1 2.5",
       "lamp.ies: line 3: the number of vertical angles is no whole number; get the file again from its maker."},
      {head + "1 1 1 2 1 4",
       "lamp.ies: line 3: the photometric type is out of range: 4; get the file again from its maker."},
      {head + "1 1 nan",
       "lamp.ies: line 3: the candela multiplier is out of range: nan; get the file again from its maker."},
      {head + "1 1 1 2000 2000 1 1 0 0 0 1 1 1\n0 90",
       "lamp.ies: line 3: has 2000 by 2000 intensities, more than it holds; get the file again from its maker."},
      {head + "1 1 1 4000000 2000 1 1 0 0 0 1 1 1\n0 90",
       "lamp.ies: line 3: has 4000000 by 2000 intensities, more than are read; get the file again from its maker."},
      {head + "1 1 1 2 1 1 1 0 0 0 1 1 1\n90 90\n0\n1 2",
       "lamp.ies: line 4: a vertical angle does not rise above the one before; get the file again from its maker."},
      {head + "1 1 1 2 1 1 1 0 0 0 1 1 1\n0 270\n0\n1 2",
       "lamp.ies: its vertical angles are not within 0 to 180 degrees; get the file again from its maker."},
      {head + "1 1 1 2 2 1 1 0 0 0 1 1 1\n0 90\n0 45\n1 2 3 4",
       "lamp.ies: its horizontal angles go from 0 to 45 degrees: no symmetry fills the rest; use one that ends at 0, "
       "90, 180 or 360."},
      {head + "1 1 1 2 1 2 1 0 0 0 1 1 1\n0 90\n0\n1 2",
       "lamp.ies: its angles are not within -90 to 90 degrees, two of each at least; get the file again from its "
       "maker."},
      {head + "1 1 1 2 1 1 1 0 0 0 1 1 1\n0 90\n0\n1",
       "lamp.ies: line 6: ends before an intensity; get the file again from its maker."},
      {head + "1 1 1e30 2 1 1 1 0 0 0 1 1 1\n0 90\n0\n1e30 1",
       "lamp.ies: line 6: an intensity times its factors is out of range; get the file again from its maker."},
  };
  for (const auto& row : rows) {
    Notes notes;
    const auto profile =
        io::readIes({reinterpret_cast<const uint8_t*>(row.text.data()), row.text.size()}, "lamp.ies", "/p", notes);
    REQUIRE(!profile.has_value());
    CHECK(describe(profile.error()) == row.says);
  }
  // A circle that is not closed is, with a warning.
  Notes notes;
  const std::string open = head + "1 1 1 2 3 1 1 0 0 0 1 1 1\n0 90\n0 120 240\n1 1 2 2 3 3";
  const auto profile =
      io::readIes({reinterpret_cast<const uint8_t*>(open.data()), open.size()}, "lamp.ies", "/p", notes);
  REQUIRE(profile.has_value());
  CHECK(optics::candela(*profile, directionC(45, 300)) == Approx(2));
  REQUIRE(notes.size() == 1);
  CHECK(notes[0].text == "lamp.ies: its horizontal angles go from 0 to 240 degrees: the rest is interpolated");
}

}  // namespace facet::test::light_profiles
