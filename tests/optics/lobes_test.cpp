#include "optics/lobes.hpp"

#include <catch2/catch.hpp>
#include <functional>

#include "optics/energy.hpp"
#include "optics/layers.hpp"
#include "optics/measured_proxy.hpp"
#include "optics/sheen.hpp"
#include "optics/transmission.hpp"
#include "optics/transmitted.hpp"
#include "support/chi_squared.hpp"
#include "support/direction.hpp"

using namespace facet;
using namespace facet::optics;

using facet::test::direction;

namespace {

// One lobe at one V.
struct LobeCase {
  std::string name;
  glm::dvec3 axis;  // of the bins
  double width;
  std::function<LobeSample(const glm::dvec2& u)> sample;
  std::function<double(const glm::dvec3&L)> density, value;
  double albedo;  // the mean weight
};

std::vector<LobeCase> lobeCases() {
  std::vector<LobeCase> all;
  const glm::dvec3 up(0, 0, 1);
  for (const double NoV : {0.15, 0.9})
    for (const double alpha : {0.1, 0.6}) {
      const glm::dvec3 V = direction(NoV, 0.4), mirror(-V.x, -V.y, V.z);
      const std::string at = " alpha " + std::to_string(alpha) + " NoV " + std::to_string(NoV);
      const Dfg dfg = integrateDfg(NoV, alpha);
      all.push_back({"ggx" + at, mirror, alpha * alpha, [=](auto& u) { return sampleGgx(V, alpha, u); },
                     [=](auto& L) { return ggxDensity(V, L, alpha); }, [=](auto& L) { return ggxValue(V, L, alpha); },
                     dfg.A + dfg.B});
      const AnisotropicAlpha pair{alpha, 0.4};
      const Dfg along = integrateDfgAnisotropic(V, pair);
      all.push_back({"ggx along" + at, mirror, 0.1, [=](auto& u) { return sampleGgx(V, pair, u); },
                     [=](auto& L) { return ggxDensity(V, L, pair); }, [=](auto& L) { return ggxValue(V, L, pair); },
                     along.A + along.B});
      all.push_back({"coat" + at, mirror, alpha * alpha, [=](auto& u) { return sampleCoat(V, alpha, u); },
                     [=](auto& L) { return ggxDensity(V, L, alpha); },
                     [=](auto& L) {
                       return coatLobe({0, 0, 1}, V, L, alpha);
                     },
                     coatF0 * dfg.A + dfg.B});
      all.push_back({"transmitted" + at, -V, alpha * alpha, [=](auto& u) { return sampleTransmitted(V, alpha, u); },
                     [=](auto& L) { return transmittedDensity(V, L, alpha); },
                     [=](auto& L) { return transmittedLobe(V, L, alpha); }, dfg.A + dfg.B});
      all.push_back({"sheen" + at, up, 1e12, [=](auto& u) { return sampleSheen(V, alpha, u); },
                     [=](auto& L) { return sheenDensity(L); }, [=](auto& L) { return sheenValue(V, L, alpha); },
                     sheenAlbedo(NoV, alpha)});
      for (const double eta : {1.5, 1 / 1.5}) {
        glm::dvec3 straight;
        if (!refracted(V, up, eta, straight)) straight = {0, 0, -1};
        // The mean weight by quadrature of the visible normals.
        double passed = 0;
        for (uint32_t i = 0; i < 65536; ++i) {
          const glm::dvec3 H = sampleVisibleGGX(V, alpha, hammersley(i, 65536));
          glm::dvec3 L;
          if (refracted(V, H, eta, L) && L.z < 0) passed += G1_GGX(-L.z, alpha) / 65536;
        }
        all.push_back({"refraction " + std::to_string(eta) + at, straight, alpha * alpha,
                       [=](auto& u) { return sampleRefraction(V, alpha, eta, u); },
                       [=](auto& L) { return refractionDensity(V, L, alpha, eta); },
                       [=](auto& L) { return refractionValue(V, L, alpha, eta); }, passed});
      }
    }
  all.push_back({"cosine", up, 1e12, [](auto& u) { return sampleCosine(u); }, cosineDensity, cosineDensity, 1});
  return all;
}

}  // namespace

TEST_CASE("Lobes: samples follow their densities, chi squared, significance 0.1 %") {
  for (const LobeCase& c : lobeCases()) {
    const auto sample = [&](const glm::dvec3& u, glm::dvec3& L) {
      const LobeSample drawn = c.sample(glm::dvec2(u));
      L = drawn.L;
      return drawn.density > 0;
    };
    const test::ChiSquared chi = test::chiSquared({c.axis, c.width}, sample, c.density);
    INFO(c.name << ": chance " << chi.chance << ", density's integral " << chi.total << ", drawn " << chi.drawn);
    CHECK(chi.chance > 1e-3);
    CHECK(chi.total == Approx(chi.drawn).margin(4e-3));
  }
}

TEST_CASE("Lobes: a sample's weight is value over density, and its mean the albedo") {
  constexpr uint32_t count = 16384;
  for (const LobeCase& c : lobeCases()) {
    double mean = 0, largest = 0;
    for (uint32_t i = 0; i < count; ++i) {
      const LobeSample drawn = c.sample(hammersley(i, count));
      if (drawn.density <= 0) continue;
      REQUIRE(glm::length(drawn.L) == Approx(1).epsilon(1e-9));
      mean += drawn.weight / count;
      const double density = c.density(drawn.L), value = c.value(drawn.L);
      largest = std::max({largest, std::abs(density / drawn.density - 1),
                          std::abs(value - drawn.weight * density) / std::max(density, 1e-3)});
    }
    INFO(c.name << ": off by " << largest << ", mean " << mean << ", albedo " << c.albedo);
    CHECK(largest < 1e-7);
    CHECK(mean == Approx(c.albedo).epsilon(2e-3));
  }
}

TEST_CASE("Lobes: a measured BRDF's proxy follows its density, chi squared, significance 0.1 %") {
  for (const double phi : {0.0, 1.0})
    for (const double share : {0.0, 0.6}) {
      const MeasuredProxy proxy{.alpha = {0.3, 0.1}, .phi = phi, .diffuseShare = share};
      const glm::dvec3 V = direction(0.5, 0.4);
      const auto sample = [&](const glm::dvec3& u, glm::dvec3& L) {
        L = sampleProxy(proxy, V, glm::dvec2(u), u.z);
        return L.z > 0;
      };
      const auto density = [&](const glm::dvec3& L) { return pdfProxy(proxy, V, L); };
      const test::ChiSquared chi = test::chiSquared({glm::dvec3(-V.x, -V.y, V.z), 0.05}, sample, density);
      INFO("phi " << phi << " share " << share << ": chance " << chi.chance << " of " << chi.total);
      CHECK(chi.chance > 1e-3);
    }
}

TEST_CASE("Lobes: extremes are finite") {
  for (const double alpha : {1e-5, 1e-3, 1.0})
    for (const double NoV : {1e-4, 1.0})
      for (const double x : {0.0, 0.5, 1 - 1e-9})
        for (const double y : {0.0, 0.5, 1 - 1e-9}) {
          const glm::dvec3 V = direction(NoV, 0.1);
          const glm::dvec2 u(x, y);
          for (const LobeSample& drawn :
               {sampleGgx(V, alpha, u), sampleGgx(V, AnisotropicAlpha{1, alpha}, u), sampleCoat(V, alpha, u),
                sampleSheen(V, alpha, u), sampleTransmitted(V, alpha, u), sampleRefraction(V, alpha, 1.5, u),
                sampleRefraction(V, alpha, 0.6, u), sampleCosine(u)}) {
            CHECK(std::isfinite(drawn.density));
            CHECK(std::isfinite(drawn.weight));
            CHECK(glm::length(drawn.L) == Approx(1).epsilon(1e-6));
          }
        }
}
