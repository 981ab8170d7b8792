#include "optics/presets.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>
#include <vector>

using namespace facet::optics;

TEST_CASE("Metals: F at normal incidence against published Rec. 709 values") {
  // Lagarde 2011/2014; he took other measurements for some.
  const std::pair<const char*, glm::dvec3> published[] = {
      {"gold", {1.000, 0.766, 0.336}},      {"silver", {0.972, 0.960, 0.915}},   {"copper", {0.955, 0.637, 0.538}},
      {"aluminium", {0.913, 0.921, 0.925}}, {"iron", {0.560, 0.570, 0.580}},     {"chromium", {0.550, 0.556, 0.554}},
      {"nickel", {0.660, 0.609, 0.526}},    {"titanium", {0.542, 0.497, 0.449}}, {"cobalt", {0.662, 0.655, 0.634}},
      {"platinum", {0.672, 0.637, 0.585}}};
  double worst = 0;
  for (const auto& [name, f0] : published) {
    const MetalPreset* metal = findMetal(name);
    REQUIRE(metal != nullptr);
    const glm::dvec3 difference = glm::abs(metal->f0() - f0);
    INFO(name << ": " << metal->f0().x << ", " << metal->f0().y << ", " << metal->f0().z);
    CHECK(std::max({difference.x, difference.y, difference.z}) < 0.105);
    worst = std::max({worst, difference.x, difference.y, difference.z});
  }
  CHECK(worst == Approx(0.101).margin(0.001));  // titanium
}

// n^2 - 1 = c0 + sum b l^2 / (l^2 - c): the authors' Sellmeier coefficients, wavelengths in micrometres.
struct Sellmeier {
  const char* name;
  double constant;
  std::vector<std::pair<double, double>> terms;
  double index(double um) const {
    double n2 = 1 + constant;
    for (const auto& [b, c] : terms) n2 += b * um * um / (um * um - c);
    return std::sqrt(n2);
  }
};

TEST_CASE("Dielectrics: index and Abbe number from the sources' dispersion formulas") {
  const auto squared = [](double x) { return x * x; };
  const Sellmeier formulas[] = {
      {"water",
       0,
       {{0.5684027565, 5.101829712e-3},
        {0.1726177391, 1.821153936e-2},
        {2.086189578e-2, 2.620722293e-2},
        {0.1130748688, 10.69792721}}},
      {"fused silica",
       0,
       {{0.6961663, squared(0.0684043)}, {0.4079426, squared(0.1162414)}, {0.8974794, squared(9.896161)}}},
      {"quartz", 0.28604141, {{1.07044083, 1.00585997e-2}, {1.10202242, 100}}},
      {"glass bk7", 0, {{1.03961212, 0.00600069867}, {0.231792344, 0.0200179144}, {1.01046945, 103.560653}}},
      {"glass f2", 0, {{1.34533359, 0.00997743871}, {0.209073176, 0.0470450767}, {0.937357162, 111.886764}}},
      {"glass sf11", 0, {{1.73759695, 0.013188707}, {0.313747346, 0.0623068142}, {1.89878101, 155.23629}}},
      {"acrylic", 0, {{1.1819, 0.011313}}},
      {"polycarbonate", 0, {{1.4182, 0.021304}}},
      {"polystyrene", 0, {{1.4435, 0.020216}}},
      {"sapphire",
       0,
       {{1.4313493, squared(0.0726631)}, {0.65054713, squared(0.1193242)}, {5.3414021, squared(18.028251)}}},
      {"cubic zirconia",
       0,
       {{1.347091, squared(0.062543)}, {2.117788, squared(0.166739)}, {9.452943, squared(24.320570)}}},
      {"diamond", 0, {{0.3306, squared(0.1750)}, {4.3356, squared(0.1060)}}},
  };
  for (const Sellmeier& formula : formulas) {
    const DielectricPreset* preset = findDielectric(formula.name);
    REQUIRE(preset != nullptr);
    const double d = formula.index(0.5875618);
    INFO(formula.name << ": " << d);
    CHECK(preset->ior == Approx(d).margin(1.2e-4));
    CHECK(preset->abbe == Approx((d - 1) / (formula.index(0.4861327) - formula.index(0.6562725))).margin(0.1));
  }
  // Cauchy's form, no glass: n = a + b / l^2 + c / l^4.
  const auto cauchy = [](double a, double b, double c) {
    const double l2 = 0.5875618 * 0.5875618;
    return a + b / l2 + c / (l2 * l2);
  };
  CHECK(findDielectric("ethanol")->ior == Approx(cauchy(1.35265, 0.00306, 0.00002)).margin(5e-5));
  CHECK(findDielectric("glycerol")->ior == Approx(cauchy(1.45797, 0.00598, -0.00036)).margin(5e-5));
}

TEST_CASE("Presets: names are unique, figures possible, sources given, unknown names") {
  std::set<std::string_view> names;
  for (const MetalPreset& metal : metalPresets()) {
    CHECK(names.insert(metal.name).second);
    CHECK_FALSE(metal.source.empty());
    CHECK((metal.wavelengthNm.x > metal.wavelengthNm.y && metal.wavelengthNm.y > metal.wavelengthNm.z));
    for (int i = 0; i < 3; ++i) {
      CHECK((metal.f0()[i] > 0.3 && metal.f0()[i] < 1));
      CHECK((metal.f82()[i] > 0.3 && metal.f82()[i] < 1));
    }
  }
  CHECK(metalPresets().size() == 12);
  for (const DielectricPreset& dielectric : dielectricPresets()) {
    CHECK(names.insert(dielectric.name).second);
    CHECK_FALSE(dielectric.source.empty());
    CHECK((dielectric.ior > 1.3 && dielectric.ior < 2.5));
  }
  CHECK(findDielectric("glass bk7")->f0() == Approx(0.0422).margin(1e-4));
  CHECK(findDielectric("diamond")->f0() == Approx(0.172).margin(1e-3));
  CHECK(findDielectric("diamond")->dispersion() == Approx(0.3617).margin(1e-4));
  CHECK(findDielectric("ice")->dispersion() == 0);
  CHECK(findMetal("unobtainium") == nullptr);
}
