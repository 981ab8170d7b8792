#include "optics/bsdf_sampling.hpp"

#include <catch2/catch.hpp>
#include <numeric>

#include "optics/energy.hpp"
#include "support/chi_squared.hpp"

using namespace facet;
using namespace facet::optics;

namespace {

const glm::dvec3 sampledN = glm::normalize(glm::dvec3(0.3, -0.5, 0.7));

glm::dvec3 viewAt(double NoV) {
  const double sine = std::sqrt((1 - NoV) * (1 + NoV));
  return frameAround(sampledN) * glm::dvec3(sine * std::cos(0.4), sine * std::sin(0.4), NoV);
}
glm::dvec3 tangent() { return frameAround(sampledN)[0]; }

struct Made {
  const char* name;
  Surface surface;
  Through through = {};
};

std::vector<Made> surfaces() {
  std::vector<Made> all = {
      {"white metal", {.baseColor = glm::dvec3(1), .metallic = 1, .perceptualRoughness = 0.5}},
      {"white dielectric", {.baseColor = glm::dvec3(1), .metallic = 0, .perceptualRoughness = 0.4}},
      {"white half metal", {.baseColor = glm::dvec3(1), .metallic = 0.5, .perceptualRoughness = 0.7}},
      {"coloured", {.baseColor = {0.8, 0.4, 0.1}, .metallic = 0.3, .perceptualRoughness = 0.5}},
  };
  Made coated{"white below a coat", {.baseColor = glm::dvec3(1), .metallic = 0.5, .perceptualRoughness = 0.6}};
  coated.surface.coat = {1, 0.5, sampledN};
  all.push_back(coated);
  Made layered{"all layers", {.baseColor = {0.9, 0.5, 0.2}, .metallic = 0.4, .perceptualRoughness = 0.6}};
  layered.surface.grain = {0.6, tangent()};
  layered.surface.film = {0.7, 1.4, 350};
  layered.surface.sheen = {{0.9, 0.3, 0.5}, 0.5};
  layered.surface.coat = {0.6, 0.4, glm::normalize(sampledN + 0.2 * tangent())};
  all.push_back(layered);
  Made thin{"thin glass", {.baseColor = glm::dvec3(1), .metallic = 0, .perceptualRoughness = 0.5, .diffuseShare = 0}};
  thin.through = {.share = glm::dvec3(0.7), .diffuse = glm::dvec3(0.3), .alpha = 0.25};
  all.push_back(thin);
  Made solid = thin;
  solid.name = "refracting";
  solid.through = {.share = {0.9, 0.7, 0.5}, .alpha = 0.25, .eta = 1.5};
  all.push_back(solid);
  return all;
}

struct At {
  glm::dvec3 V;
  Albedos albedos;
  Through through;
  LobeChances chances;
};
At prepare(const Made& made, double NoV) {
  At at{viewAt(NoV), {}, made.through, {}};
  at.albedos = albedosOf(made.surface, sampledN, at.V, at.V);  // sheen's E at L: as at V
  const Dfg dfg = integrateDfg(NoV, at.through.alpha);
  at.through.albedo = dfg.A + dfg.B;
  at.chances = lobeChances(made.surface, at.albedos, at.through, NoV);
  return at;
}

}  // namespace

TEST_CASE("BSDF samples follow their density, chi squared, significance 0.1 %") {
  for (const Made& made : surfaces())
    for (const double NoV : {0.3, 0.9}) {
      const At at = prepare(made, NoV);
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
  for (const Made& made : surfaces())
    for (const double NoV : {0.3, 0.9}) {
      const At at = prepare(made, NoV);
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
