#include "optics/bsdf_sampling.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "support/chi_squared.hpp"
#include "support/sampled_surfaces.hpp"

using namespace facet;
using namespace facet::optics;
using namespace facet::test;

TEST_CASE("BSDF samples follow their density, chi squared, significance 0.1 %") {
  for (const SampledSurface& made : sampledSurfaces())
    for (const double NoV : {0.3, 0.9}) {
      const SampledView at = sampledView(made, NoV);
      CHECK(std::accumulate(at.chances.begin(), at.chances.end(), 0.0) == Approx(1).epsilon(1e-12));
      const auto sample = [&](const glm::dvec3& u, glm::dvec3& L) {
        const BsdfSample drawn = sampleBsdf(made.surface, at.through, at.chances, sampledN, at.V, u);
        L = drawn.L;
        return drawn.density > 0;
      };
      const auto density = [&](const glm::dvec3& L) {
        return bsdfDensity(made.surface, at.through, at.chances, sampledN, at.V, L);
      };
      const test::ChiSquared chi = test::chiSquared({sampledN, 1e12}, sample, density, 50'000);
      INFO(made.name << " NoV " << NoV << ": chance " << chi.chance << ", density's integral " << chi.total
                     << ", drawn " << chi.drawn);
      CHECK(chi.chance > 1e-3);
    }
}

TEST_CASE("BSDF: the white furnace by sampling") {
  // The other way: the same value by points that are even over the sphere.
  constexpr uint32_t count = 1 << 15;
  for (const SampledSurface& made : sampledSurfaces())
    for (const double NoV : {0.3, 0.9}) {
      const SampledView at = sampledView(made, NoV);
      glm::dvec3 sampled(0), even(0);
      double largest = 0;
      for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec2 u = hammersley(i, count);
        const glm::dvec3 point(u, std::fmod((i + 0.5) * 0.6180339887498949, 1.0));
        const BsdfSample drawn = sampleBsdf(made.surface, at.through, at.chances, sampledN, at.V, point);
        if (drawn.density > 0) {
          const glm::dvec3 value = evaluate(made.surface, at.albedos, at.through, sampledN, at.V, drawn.L);
          sampled += value / drawn.density / double(count);
          largest = std::max(largest, value.r / drawn.density);
        }
        even += evaluate(made.surface, at.albedos, at.through, sampledN, at.V, goldenSpiral(i, count)) * 4.0 * pi /
                double(count);
      }
      INFO(made.name << " NoV " << NoV << ": sampled " << sampled.r << " " << sampled.g << " " << sampled.b << ", even "
                     << even.r << " " << even.g << " " << even.b << ", largest weight " << largest);
      for (int c = 0; c < 3; ++c) CHECK(sampled[c] == Approx(even[c]).epsilon(0.01));
      CHECK(largest < 6);
      if (std::string_view(made.name).starts_with("white")) CHECK(sampled.r == Approx(1).epsilon(5e-3));
      CHECK(sampled.r <= 1.005);
    }
}

TEST_CASE("BSDF: a black surface is sampled as a mirror would be") {
  const Surface black{
      .baseColor = glm::dvec3(0), .metallic = 0, .perceptualRoughness = 0.5, .f0 = glm::dvec3(0), .f90 = 0};
  const LobeChances chances = lobeChances(black, albedosOf(black, sampledN, sampledN, sampledN), {}, 1);
  CHECK(chances[specularLobe] == 1);
  CHECK(sampleBsdf(black, {}, chances, sampledN, sampledN, {0.3, 0.3, 0.9}).lobe == specularLobe);
}
