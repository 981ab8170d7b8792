#include "optics/presets.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <set>

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

TEST_CASE("Presets: names are unique, figures possible, sources given; unknown names") {
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
