// The white furnace by sampling on the GPU: directions of sampleBsdf, each weighed with evaluateBsdf over its density.

#include <catch2/catch.hpp>
#include <cmath>

#include "optics/quadrature.hpp"
#include "selftest/layered_surface.hpp"
#include "selftest/shader_probe.hpp"
#include "support/sampled_surfaces.hpp"

using namespace facet;

namespace {

// in0 V, metallic; in1 base colour, perceptualRoughness; in2 weights of coat and film, roughness of coat and sheen; in3
// A, B of base and coat; in4 Through.share, alpha; in5 Through.diffuse, albedo; in6 eta, diffuseShare, sheen's E,
// anisotropy; in7 N, in8 tangent, in9 coat's N, in10 sheen's colour. The points: Hammersley's, and the golden ratio's
// for the lobe.
constexpr const char* furnace = R"(
  Surface s = makeSurface(in7.xyz, in0.xyz, in1.rgb, in0.w, in1.w, 1.0);
  s.dfg = vec3(in3.xy, 0.0);
  s.diffuseShare = in6.y;
  s.grain.T = in8.xyz;
  s.grain.B = cross(in7.xyz, in8.xyz);
  s.grain.alpha = alphaFromAnisotropy(s.alpha, in6.w);
  setFilm(s, in2.y, 1.4, 350.0);
  s.sheen.color = in10.rgb;
  s.sheen.perceptualRoughness = in2.w;
  s.sheen.alpha = in2.w * in2.w;
  s.sheen.albedoV = in6.z;
  s.sheen.albedoL = in6.z;
  s.coat.N = in9.xyz;
  s.coat.NoV = clamp(dot(s.coat.N, s.V), minNoV, 1.0);
  s.coat.weight = in2.x;
  s.coat.perceptualRoughness = in2.z;
  s.coat.alpha = in2.z * in2.z;
  s.coat.dfg = vec3(in3.zw, 0.0);
  Through t = Through(in4.rgb, in5.rgb, in4.w, in5.w, in6.x);
  const int count = 16384;
  vec3 sum = vec3(0.0);
  for (int i = 0; i < count; ++i) {
    vec3 u = vec3((float(i) + 0.5) / float(count), float(bitfieldReverse(uint(i)) >> 8) / 16777216.0,
                  float((uint(i) * 2654435769u) >> 8) / 16777216.0);
    BsdfSample drawn = sampleBsdf(s, t, u);
    if (drawn.density > 0.0) sum += evaluateBsdf(s, t, drawn.L) / drawn.density;
  }
  out0.rgb = sum / float(count);
)";

glm::dvec3 inDouble(const test::SampledSurface& made, const test::SampledView& at) {
  constexpr uint32_t count = 1 << 14;
  glm::dvec3 sum(0);
  for (uint32_t i = 0; i < count; ++i) {
    const glm::dvec3 u(optics::hammersley(i, count), std::fmod((i + 0.5) * 0.6180339887498949, 1.0));
    const optics::BsdfSample drawn = optics::sampleBsdf(made.surface, at.through, at.chances, test::sampledN, at.V, u);
    if (drawn.density > 0)
      sum += optics::evaluate(made.surface, at.albedos, at.through, test::sampledN, at.V, drawn.L) / drawn.density;
  }
  return sum / double(count);
}

}  // namespace

TEST_CASE("BSDF: the white furnace by sampling on the GPU", "[gl]") {
  struct Case {
    test::SampledSurface made;
    double NoV;
    test::SampledView at;
  };
  std::vector<Case> cases;
  std::vector<glm::vec4> inputs;
  for (const test::SampledSurface& made : test::sampledSurfaces())
    for (const double NoV : {0.3, 0.9}) {
      const Case& c = cases.emplace_back(Case{made, NoV, test::sampledView(made, NoV)});
      const optics::Surface& s = made.surface;
      const optics::Albedos& a = c.at.albedos;
      const optics::Through& t = c.at.through;
      const bool coated = s.coat.weight > 0;
      inputs.emplace_back(glm::vec3(c.at.V), s.metallic);
      inputs.emplace_back(glm::vec3(s.baseColor), s.perceptualRoughness);
      inputs.emplace_back(s.coat.weight, s.film.weight, s.coat.perceptualRoughness, s.sheen.perceptualRoughness);
      inputs.emplace_back(a.base.A, a.base.B, a.coat.A, a.coat.B);
      inputs.emplace_back(glm::vec3(t.share), t.alpha);
      inputs.emplace_back(glm::vec3(t.diffuse), t.albedo);
      inputs.emplace_back(t.eta, s.diffuseShare, a.sheenV, s.grain.strength);
      inputs.emplace_back(glm::vec3(test::sampledN), 0);
      inputs.emplace_back(glm::vec3(test::sampledTangent()), 0);
      inputs.emplace_back(glm::vec3(coated ? s.coat.normal : test::sampledN), 0);
      inputs.emplace_back(glm::vec3(s.sheen.color), 0);
    }
  const selftest::Probe probe{{"bsdf_sampling.glsl"}, furnace, 11, 1, selftest::allLayers};
  const auto values = selftest::runProbe(probe, inputs, shading::shaderReader());
  REQUIRE(values);
  for (size_t i = 0; i < cases.size(); ++i) {
    const glm::vec3 sampled = glm::vec3((*values)[i]);
    const glm::dvec3 expected = inDouble(cases[i].made, cases[i].at);
    INFO(cases[i].made.name << " NoV " << cases[i].NoV << ": " << sampled.r << " " << sampled.g << " " << sampled.b
                            << ", in double precision " << expected.r << " " << expected.g << " " << expected.b);
    for (int c = 0; c < 3; ++c) CHECK(sampled[c] == Approx(expected[c]).epsilon(3e-3));
    if (std::string_view(cases[i].made.name).starts_with("white"))
      for (int c = 0; c < 3; ++c) CHECK(sampled[c] == Approx(1).epsilon(5e-3));
  }
}
