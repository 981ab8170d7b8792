#include "optics/diffuse.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/microfacet.hpp"
#include "optics/quadrature.hpp"

using namespace facet::optics;

namespace {

struct Range {
  double low = 1e9, high = -1e9;
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

Range furnace(DiffuseModel model) {
  Range range;
  for (double r : {0.0, 0.25, 0.5, 0.75, 1.0})
    for (double NoV : {1e-3, 0.05, 0.2, 0.5, 0.8, 1.0}) range.add(diffuseAlbedo(model, NoV, r));
  return range;
}

const DiffuseModel models[] = {DiffuseModel::lambert,   DiffuseModel::burley, DiffuseModel::frostbite,
                               DiffuseModel::orenNayar, DiffuseModel::eon,    DiffuseModel::callOfDuty};

}  // namespace

TEST_CASE("Diffuse models: known values") {
  const DiffuseAngles facing{1, 1, 1}, grazing{0, 0, 1}, across{0.5, 0.5, -0.5};
  CHECK(Fd_Burley(facing, 0.3) == Approx(1 / pi));
  CHECK(Fd_Burley(grazing, 1) == Approx(6.25 / pi));  // f90 = 2.5 twice
  CHECK(Fd_Burley(grazing, 0) == Approx(0.25 / pi));  // f90 = 0.5 twice
  CHECK(Fd_Frostbite(facing, 1) == Approx(1 / (1.51 * pi)));
  CHECK(Fd_Frostbite(grazing, 1) == Approx(6.25 / (1.51 * pi)));
  CHECK(Fd_Frostbite(grazing, 0) == Approx(0).margin(1e-15));
  // By hand: sigma = 30 degrees, both at 60 degrees, opposite azimuths: only A is left.
  const double s2 = pi * pi / 36;
  CHECK(Fd_OrenNayar(across, pi / 6) == Approx((1 - 0.5 * s2 / (s2 + 0.33)) / pi));
  // Same azimuth: B sin(60) tan(60) = 1.5 B.
  CHECK(Fd_OrenNayar({0.5, 0.5, 1}, pi / 6) ==
        Approx((1 - 0.5 * s2 / (s2 + 0.33) + 1.5 * 0.45 * s2 / (s2 + 0.09)) / pi));
  CHECK(Fd_OrenNayar(facing, 0) == Approx(1 / pi));
  CHECK(sigmaOrenNayar(1) == Approx(0.70710678));
  CHECK(Fd_Eon(across, 0, 0.3) == Approx(0.3 / pi));  // smooth: Lambert
  // First bounce of r = 1: A = 1 / (1 + 1/2 - 2/(3 pi)); facing, and 1 + s / t with s = 0.75, t = 0.5.
  CHECK(Fd_Eon(facing, 1, 1e-9) == Approx(0.776522e-9 / pi).epsilon(1e-5));
  CHECK(Fd_Eon({0.5, 0.5, 1}, 1, 1e-9) == Approx(2.5 * 0.776522e-9 / pi).epsilon(1e-5));
  // alpha = 1: g = 0, the rough branch alone: VoH + (1 - VoH)^5 = 1 and 24.5 2^-8.9 when all coincide.
  CHECK(Fd_CallOfDuty(facing, 1) == Approx((1 + 24.5 * std::exp2(-8.9)) / pi));
  // alpha -> 0: g = 1, the smooth branch and no backscatter: 24.5 - 59 + 34.5 = 0.
  CHECK(Fd_CallOfDuty({0, 1, 0}, 0) == Approx(0.25 / pi));
}

TEST_CASE("Diffuse models are reciprocal, and finite at the horizon") {
  for (DiffuseModel model : models)
    for (double r : {0.0, 0.4, 1.0})
      for (double a : {0.0, 1e-12, 0.3, 1.0})
        for (double b : {0.0, 1e-6, 0.8}) {
          const double VoL = a * b - 0.7 * std::sqrt((1 - a * a) * (1 - b * b));
          const double value = diffuseBrdf(model, {a, b, VoL}, r);
          CHECK(value == Approx(diffuseBrdf(model, {b, a, VoL}, r)).margin(1e-15));
          CHECK((std::isfinite(value) && value >= 0));
          CHECK(std::isfinite(diffuseBrdf(model, {a, a, 1}, r)));
          CHECK(std::isfinite(diffuseBrdf(model, {a, a, -1}, r)));
        }
}

TEST_CASE("Diffuse models in a white furnace: where they gain and lose") {
  const auto check = [](DiffuseModel model, double low, double high) {
    const Range range = furnace(model);
    INFO("model " << static_cast<int>(model) << ": " << range.low << " .. " << range.high);
    CHECK(range.low == Approx(low).margin(0.005));
    CHECK(range.high == Approx(high).margin(0.005));
  };
  check(DiffuseModel::lambert, 1, 1);
  check(DiffuseModel::burley, 0.491, 1.556);
  check(DiffuseModel::frostbite, 0.005, 1.030);
  check(DiffuseModel::orenNayar, 0.699, 1.015);
  check(DiffuseModel::eon, 1, 1);
  check(DiffuseModel::callOfDuty, 0.245, 1.156);
}

TEST_CASE("EON: first bounce's albedo is its integral, the whole is white at albedo 1 and loses below") {
  for (double r : {0.2, 1.0})
    for (double NoV : {1e-4, 0.3, 1.0}) {
      const double sinV = std::sqrt(1 - NoV * NoV);
      const auto total = [&](const auto& brdf) {
        const auto ring = [&](double NoL) {
          const double sinL = std::sqrt(1 - NoL * NoL);
          const auto f = [&](double phi) {
            return brdf(DiffuseAngles{NoV, NoL, NoV * NoL + sinV * sinL * std::cos(phi)});
          };
          return 2 * NoL *
                 (integrateAdaptive<double>(f, 0, pi / 2, 1e-8, 14) +
                  integrateAdaptive<double>(f, pi / 2, pi, 1e-8, 14));
        };
        return integrateAdaptive<double>(ring, 0, NoV, 1e-8, 14) + integrateAdaptive<double>(ring, NoV, 1, 1e-8, 14);
      };
      CHECK(total([&](const DiffuseAngles& a) { return Fd_Eon(a, r, 1); }) == Approx(1).margin(1e-6));
      // To first order in the albedo only the first bounce is left.
      CHECK(total([&](const DiffuseAngles& a) { return Fd_Eon(a, r, 1e-9); }) / 1e-9 ==
            Approx(albedoFujii(NoV, r)).margin(1e-6));
      CHECK(total([&](const DiffuseAngles& a) { return Fd_Eon(a, r, 0.5); }) < 0.5);
    }
}
