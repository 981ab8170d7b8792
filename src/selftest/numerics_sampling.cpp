#include "optics/bsdf_sampling.hpp"
#include "optics/diffuse.hpp"
#include "optics/lobes.hpp"
#include "optics/measured_proxy.hpp"
#include "optics/quadrature.hpp"
#include "optics/sheen.hpp"
#include "optics/sobol.hpp"
#include "selftest/layered_surface.hpp"
#include "selftest/numerics_grid.hpp"

namespace facet::selftest {

namespace {

using optics::LobeSample;
using optics::pi;

// ---- points: in0 both halves of the index, of the pair; in1 of the seed
// ---------------------------------------------------------------------

uint32_t wordOf(double high, double low) { return static_cast<uint32_t>(high) << 16 | static_cast<uint32_t>(low); }

const std::vector<uint32_t> ordinaryAndExtremeWords = {0,     1,          2,          77,         4095,      65535,
                                                       65536, 0x7fffffff, 0x80000000, 0xdeadbeef, 0xffffffff};

std::vector<glm::vec4> words(const std::vector<uint32_t>& third) {
  std::vector<glm::vec4> inputs;
  for (const uint32_t a : ordinaryAndExtremeWords)
    for (const uint32_t b : ordinaryAndExtremeWords)
      for (const uint32_t c : third) {
        inputs.emplace_back(a >> 16, a & 0xffff, b >> 16, b & 0xffff);
        inputs.emplace_back(c >> 16, c & 0xffff, 0, 0);
      }
  return inputs;
}

const std::string wordsOfInputs =
    "uint a = uint(in0.x) << 16 | uint(in0.y), b = uint(in0.z) << 16 | uint(in0.w), "
    "c = uint(in1.x) << 16 | uint(in1.y);\n";

Check checkPoints() {
  Check check = absoluteCheck(
      "owenSobol2", "sobol.glsl", wordsOfInputs + "out0.xy = owenSobol2(a, b, c);",
      {"index / 65536", "index % 65536", "pair / 65536", "pair % 65536", "seed / 65536", "seed % 65536"}, 2);
  check.inputs = words(ordinaryAndExtremeWords);
  check.twin = [](CheckVectors in) {
    const glm::dvec2 p =
        optics::owenSobol2(wordOf(in[0].x, in[0].y), wordOf(in[0].z, in[0].w), wordOf(in[1].x, in[1].y));
    return CheckValues{p.x, p.y};
  };
  allow(check, 0, "whole numbers, and multiples of 2^-24 that a float holds");
  return check;
}

Check checkPixelSeed() {
  Check check = absoluteCheck(
      "pixelSeed", "sobol.glsl",
      wordsOfInputs + "uint seed = pixelSeed(uvec2(a, b), c);\nout0.xy = vec2(seed >> 16, seed & 65535u);",
      {"x / 65536", "x % 65536", "y / 65536", "y % 65536", "use / 65536", "use % 65536"}, 2);
  check.inputs = words({0, 1, 0xffffffff});
  check.twin = [](CheckVectors in) {
    const uint32_t seed =
        optics::pixelSeed({wordOf(in[0].x, in[0].y), wordOf(in[0].z, in[0].w)}, wordOf(in[1].x, in[1].y));
    return CheckValues{static_cast<double>(seed >> 16), static_cast<double>(seed & 0xffff)};
  };
  allow(check, 0, "whole numbers");
  return check;
}

// Points of pictures without noise.
Check checkSpiralPoint() {
  Check check =
      absoluteCheck("spiralPoint", "sequence.glsl", "out0.xy = spiralPoint(int(in0.x), int(in0.y));", {"i", "n"});
  for (const double n : {1.0, 4.0, 64.0, 1024.0})
    for (const double share : {0.0, 0.3, 0.99}) check.inputs.emplace_back(std::floor(share * n), n, 0, 0);
  check.twin = [](CheckVectors in) {
    const glm::dvec2 point = optics::spiralPoint(static_cast<uint32_t>(in[0].x), static_cast<uint32_t>(in[0].y));
    return CheckValues{point.x, point.y};
  };
  allow(check, 3, "a quotient; the golden ratio to 2^-32, 1024 times; a whole number of 32 bits becomes a float");
  return check;
}

// ---- samplers: in0 V, alpha; in1 u, eta, the second alpha
// -------------------------------------------------------------

const std::vector<std::string> samplerNames = {"V.x", "V.y", "V.z", "alpha", "u.x", "u.y", "eta", "alpha.b"};
using Sampler = std::function<LobeSample(CheckVectors in)>;

CheckValues samplerValues(const LobeSample& drawn) {
  if (drawn.density <= 0) return {0, 0, 0, 0, 0};
  return {drawn.L.x, drawn.L.y, drawn.L.z, 1, drawn.weight};
}

// Held against each other: L, the density over the twin's, and the weight.
Check checkSampler(const std::string& name, const std::string& chunk, const std::string& call, const Axis& alphas,
                   const Axis& etas, Sampler twin) {
  Check check = absoluteCheck(name, chunk,
                              "LobeSample drawn = " + call +
                                  ";\nout0 = vec4(drawn.L, drawn.density);\nout1 = vec4(drawn.weight, 0.0, 0.0, 0.0);",
                              samplerNames, 2);
  check.probe.outputs = 2;
  for (const double alpha : alphas)
    for (const double eta : etas)
      for (const double NoV : {minNoVFloat, 0.02, 0.5, 1.0})
        for (uint32_t i = 0; i < 16; ++i) {
          const glm::dvec2 u = optics::hammersley(i, 16);
          check.inputs.emplace_back(glm::vec3(around(NoV, 0.7)), alpha);
          check.inputs.emplace_back(u.x, u.y + 0.02, eta, 0.3);
        }
  check.twin = [twin](CheckVectors in) { return samplerValues(twin(in)); };
  check.observe = [twin](CheckVectors in, CheckVectors out) {
    const LobeSample expected = twin(in);
    const bool drawn = out[0].w > 0;
    if (!drawn) return CheckValues{0, 0, 0, 0, 0};
    return CheckValues{out[0].x, out[0].y, out[0].z, out[0].w / expected.density, out[1].x};
  };
  check.tolerance = floatEpsilon;
  return check;
}

// Roundings of L, sin and cos the driver's; the density and the weight lose where the normal or L come near the
// horizon.
void allowSampler(Check& check, const Sampler& twin) {
  check.conditioning = [twin](CheckVectors in) {
    const LobeSample drawn = twin(in);
    return 200 + 40 / std::max(in[0].z, minNoVFloat) * (in[0].z < 0.1 ? 1 : 0.1) +
           20 / std::max(std::abs(drawn.L.z), 1e-3);
  };
  check.reason = "64 roundings, sin and cos are the driver's; 1 / NoV and 1 / NoL of them where those near the horizon";
}

Check samplerCheck(const std::string& name, const std::string& chunk, const std::string& call, const Axis& alphas,
                   const Axis& etas, const Sampler& twin) {
  Check check = checkSampler(name, chunk, call, alphas, etas, twin);
  allowSampler(check, twin);
  return check;
}

glm::dvec2 pointOf(CheckVectors in) { return {in[1].x, in[1].y}; }

std::vector<Check> samplerChecks() {
  const Axis narrowToWide = {1e-5, 1e-3, 0.1, 0.5, 1}, wide = {1e-3, 0.1, 0.5, 1}, none = {0};
  return {
      samplerCheck("sampleGgx", "microfacet.glsl", "sampleGgx(in0.xyz, in0.w, in1.xy)", narrowToWide, none,
                   [](CheckVectors in) { return optics::sampleGgx(xyzOf(in[0]), in[0].w, pointOf(in)); }),
      samplerCheck("sampleGgx, anisotropic", "anisotropy.glsl", "sampleGgx(in0.xyz, vec2(in0.w, in1.w), in1.xy)", wide,
                   none,
                   [](CheckVectors in) {
                     return optics::sampleGgx(xyzOf(in[0]), optics::AnisotropicAlpha{in[0].w, in[1].w}, pointOf(in));
                   }),
      samplerCheck("sampleCoat", "layers.glsl", "sampleCoat(in0.xyz, in0.w, in1.xy)", wide, none,
                   [](CheckVectors in) { return optics::sampleCoat(xyzOf(in[0]), in[0].w, pointOf(in)); }),
      samplerCheck("sampleCosine", "diffuse.glsl", "sampleCosine(in1.xy)", {1}, none,
                   [](CheckVectors in) { return optics::sampleCosine(pointOf(in)); }),
      samplerCheck("sampleSheen", "sheen.glsl", "sampleSheen(in0.xyz, in0.w, in1.xy)", {0.05, 0.36, 1}, none,
                   [](CheckVectors in) { return optics::sampleSheen(xyzOf(in[0]), in[0].w, pointOf(in)); }),
      samplerCheck("sampleTransmitted", "transmitted.glsl", "sampleTransmitted(in0.xyz, in0.w, in1.xy)", wide, none,
                   [](CheckVectors in) { return optics::sampleTransmitted(xyzOf(in[0]), in[0].w, pointOf(in)); }),
      samplerCheck(
          "sampleRefraction", "transmission.glsl", "sampleRefraction(in0.xyz, in0.w, in1.z, in1.xy)",
          {0.01, 0.1, 0.5, 1}, {1.5, 0.7, 3},
          [](CheckVectors in) { return optics::sampleRefraction(xyzOf(in[0]), in[0].w, in[1].z, pointOf(in)); }),
  };
}

// ---- values and densities: in0 V, alpha; in1 L, eta
// -------------------------------------------------------------------

using OfPair = std::function<double(const glm::dvec3& V, const glm::dvec3& L, CheckVectors in)>;

Check pairCheck(const std::string& name, const std::string& chunk, const std::string& call, bool below,
                const OfPair& twin) {
  Check check = absoluteCheck(name, chunk, "float VoH;\nout0.x = " + call + ";",
                              {"V.x", "V.y", "V.z", "alpha", "L.x", "L.y", "L.z", "eta"}, 2);
  for (const double alpha : {1e-3, 0.03, 0.3, 1.0})
    for (const double NoV : {minNoVFloat, 0.05, 0.5, 1.0})
      for (const double NoL : {1.0, 0.5, 0.1, 1e-3, -0.3})
        for (const double phi : {0.1, 1.0, 0.1 + pi})
          for (const double eta : {1.5, 0.7}) {
            check.inputs.emplace_back(glm::vec3(around(NoV, 0.1)), alpha);
            check.inputs.emplace_back(glm::vec3(around(below ? -NoL : NoL, phi)), eta);
          }
  // Of the lobe's peak.
  const auto scale = [](CheckVectors in) {
    return std::max(1.0, 1 / (pi * in[0].w * in[0].w) / (4 * std::max(in[0].z, 0.01)));
  };
  check.twin = [=](CheckVectors in) {
    return CheckValues{twin(glm::normalize(xyzOf(in[0])), glm::normalize(xyzOf(in[1])), in) / scale(in)};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) { return CheckValues{out[0].x / scale(in)}; };
  check.tolerance = floatEpsilon;
  check.conditioning = [=](CheckVectors in) {
    const glm::dvec3 L = xyzOf(in[1]), V = xyzOf(in[0]);
    const double sum = std::min(
        {glm::length(V + L), glm::length(V + glm::dvec3(L.x, L.y, -L.z)), below ? glm::length(V + in[1].w * L) : 2.0});
    return 40 + 16 / (in[0].w * std::max(sum, 1e-3)) + 4 / std::max(in[0].z, minNoVFloat) +
           4 / std::max(std::abs(L.z), 1e-4);
  };
  check.reason =
      "of the lobe's peak; the half vector is off by 2 epsilon over its length, which D amplifies by 2 / alpha";
  return check;
}

std::vector<Check> pairChecks() {
  return {
      pairCheck("ggxValue", "microfacet.glsl", "ggxValue(in0.xyz, in1.xyz, in0.w)", false,
                [](auto& V, auto& L, CheckVectors in) { return optics::ggxValue(V, L, in[0].w); }),
      pairCheck("ggxDensity", "microfacet.glsl", "ggxDensity(in0.xyz, in1.xyz, in0.w)", false,
                [](auto& V, auto& L, CheckVectors in) { return optics::ggxDensity(V, L, in[0].w); }),
      pairCheck("ggxValue, anisotropic", "anisotropy.glsl", "ggxValue(in0.xyz, in1.xyz, vec2(0.4, in0.w))", false,
                [](auto& V, auto& L, CheckVectors in) {
                  return optics::ggxValue(V, L, optics::AnisotropicAlpha{double(0.4f), in[0].w});
                }),
      pairCheck("ggxDensity, anisotropic", "anisotropy.glsl", "ggxDensity(in0.xyz, in1.xyz, vec2(0.4, in0.w))", false,
                [](auto& V, auto& L, CheckVectors in) {
                  return optics::ggxDensity(V, L, optics::AnisotropicAlpha{double(0.4f), in[0].w});
                }),
      pairCheck("cosineDensity", "diffuse.glsl", "cosineDensity(in1.xyz)", false,
                [](auto&, auto& L, CheckVectors) { return optics::cosineDensity(L); }),
      pairCheck("sheenDensity", "sheen.glsl", "sheenDensity(in1.xyz)", false,
                [](auto&, auto& L, CheckVectors) { return optics::sheenDensity(L); }),
      pairCheck("transmittedDensity", "transmitted.glsl", "transmittedDensity(in0.xyz, in1.xyz, in0.w)", true,
                [](auto& V, auto& L, CheckVectors in) { return optics::transmittedDensity(V, L, in[0].w); }),
      pairCheck("refractionDensity", "transmission.glsl",
                "refractionDensity(vec3(0.0, 0.0, 1.0), in0.xyz, in1.xyz, in0.w, in1.w, VoH)", true,
                [](auto& V, auto& L, CheckVectors in) { return optics::refractionDensity(V, L, in[0].w, in[1].w); }),
      pairCheck("refractionValue", "transmission.glsl",
                "refractionValue(vec3(0.0, 0.0, 1.0), in0.xyz, in1.xyz, in0.w, in1.w)", true,
                [](auto& V, auto& L, CheckVectors in) { return optics::refractionValue(V, L, in[0].w, in[1].w); }),
  };
}

Check checkProxy() {
  Check check = absoluteCheck("sampleProxy, pdfProxy", "measured_sampling.glsl",
                              "vec4 lobe = vec4(in0.w, in1.w, 0.8, 0.6);\n"
                              "out0.xyz = sampleProxy(lobe, in1.z, in0.xyz, in1.xy);\n"
                              "out0.w = out0.z > 0.0 ? pdfProxy(lobe, in1.z, in0.xyz, out0.xyz) : 0.0;",
                              {"V.x", "V.y", "V.z", "alpha", "u.x", "u.y", "cosine's share", "alpha.b"}, 2);
  for (const double alpha : {0.01, 0.1, 1.0})
    for (const double share : {0.1, 0.5, 1.0})
      for (const double NoV : {0.02, 0.5, 1.0})
        for (uint32_t i = 0; i < 16; ++i) {
          const glm::dvec2 u = optics::hammersley(i, 16);
          check.inputs.emplace_back(glm::vec3(around(NoV, 0.7)), alpha);
          check.inputs.emplace_back(u.x + 0.02, u.y, share, 0.3);
        }
  const auto proxyOf = [](CheckVectors in) {
    return optics::MeasuredProxy{.alpha = {in[0].w, in[1].w}, .phi = std::atan2(0.6, 0.8), .diffuseShare = in[1].z};
  };
  const auto drawnBy = [=](CheckVectors in) {
    const bool cosine = in[1].x < in[1].z;
    const double x = cosine ? in[1].x / in[1].z : (in[1].x - in[1].z) / (1 - in[1].z);
    return optics::sampleProxy(proxyOf(in), xyzOf(in[0]), {x, in[1].y}, in[1].x);
  };
  check.twin = [=](CheckVectors in) {
    const glm::dvec3 L = drawnBy(in);
    return L.z > 0 ? CheckValues{L.x, L.y, L.z, 1} : CheckValues{0, 0, 0, 0};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) {
    if (out[0].z <= 0) return CheckValues{0, 0, 0, 0};
    return CheckValues{out[0].x, out[0].y, out[0].z,
                       out[0].w / optics::pdfProxy(proxyOf(in), xyzOf(in[0]), drawnBy(in))};
  };
  check.tolerance = floatEpsilon;
  check.conditioning = [=](CheckVectors in) { return 400 + 40 / std::min(in[0].w, in[1].w) / std::max(in[0].z, 0.02); };
  check.reason =
      "64 roundings, sin and cos are the driver's; the density from L, whose half vector D amplifies by 2 / alpha";
  return check;
}

// ---- the whole surface ----------------------------------------------------------------------------------------------

// in0: V, metallic; in1: u, perceptualRoughness; in2: layerNames;
// in3: L, sheen E; in4: alpha and eta of what is seen through, its share.
const std::string sampledBody = R"(
  vec3 V = in0.xyz, baseColor = vec3(0.9, 0.5, 0.1);
  float metallic = in0.w, perceptualRoughness = in1.w;
  vec4 layers = in2, dfg = vec4(0.7, 0.1, 0.9, 0.05);
  vec2 sheenAlbedo = in3.ww;
)" + std::string(layeredSurfaceText) +
                                R"(
  s.diffuseShare = 1.0 - in4.z - 0.2;
  Through t = Through(vec3(0.9, 0.8, 0.7) * in4.z, vec3(0.2, 0.1, 0.05), in4.x, 0.8, in4.y);
  BsdfSample drawn = sampleBsdf(s, t, in1.xyz);
  out0 = vec4(drawn.L, drawn.density);
  out1 = vec4(evaluateBsdf(s, t, in3.xyz), bsdfDensity(s, t, in3.xyz));
)";

struct SampledTwin {
  optics::Surface surface;
  optics::Albedos albedos;
  optics::Through through;
  optics::LobeChances chances;
  glm::dvec3 V;
};
SampledTwin sampledTwin(CheckVectors in) {
  SampledTwin twin;
  optics::Surface& surface = twin.surface;
  surface = layeredSurface({float(0.9), 0.5, float(0.1)}, in[0].w, in[1].w, in[2]);
  surface.diffuseShare = 1 - in[4].z - double(0.2f);
  twin.albedos = {{double(0.7f), double(0.1f)}, {double(0.9f), double(0.05f)}, in[3].w, in[3].w, 1};
  twin.through = {glm::dvec3(float(0.9), float(0.8), float(0.7)) * in[4].z,
                  glm::dvec3(float(0.2), float(0.1), float(0.05)), in[4].x, double(0.8f), in[4].y};
  twin.V = xyzOf(in[0]);
  twin.chances = optics::lobeChances(surface, twin.albedos, twin.through, twin.V.z);
  return twin;
}

Check checkWhole() {
  Check check{"sampleBsdf, bsdfDensity",
              {{"bsdf_sampling.glsl"}, sampledBody, 5, 2, allLayers},
              aroundLayers({"V.x", "V.y", "V.z", "metallic", "u.x", "u.y", "u.z", "perceptualRoughness"},
                           {"L.x", "L.y", "L.z", "sheen E", "alpha", "eta", "share"}),
              {}};
  uint32_t i = 0;
  for (const double NoV : {1.0, 0.6, 0.1})
    for (const double NoL : {1.0, 0.4, -0.3, -0.9})
      for (const double r : {0.2, 0.5, 1.0})
        for (const double eta : {0.0, 1.5})
          for (const double metallic : {0.0, 0.5})
            for (const glm::vec4& layers : {glm::vec4(0, 0.5, 0, 0.3), {1, 0.5, 1, 0.8}, {0.5, 0.3, 0.5, 1}}) {
              const glm::dvec2 u = optics::hammersley(i, 512);
              check.inputs.emplace_back(glm::vec3(around(NoV, 0.3)), metallic);
              check.inputs.emplace_back(u.x, u.y, std::fmod((i + 0.5) * 0.618034, 1.0), r);
              check.inputs.push_back(layers);
              check.inputs.emplace_back(glm::vec3(around(NoL, 2.5)), 0.4);
              check.inputs.emplace_back(r * r, eta, 0.5, 0);
              ++i;
            }
  const auto sampleOf = [](const SampledTwin& twin, CheckVectors in) {
    return optics::sampleBsdf(twin.surface, twin.through, twin.chances, {0, 0, 1}, twin.V, xyzOf(in[1]));
  };
  check.twin = [=](CheckVectors in) {
    const SampledTwin twin = sampledTwin(in);
    const optics::BsdfSample drawn = sampleOf(twin, in);
    const glm::dvec3 L = xyzOf(in[3]);
    const glm::dvec3 f = optics::evaluate(twin.surface, twin.albedos, twin.through, {0, 0, 1}, twin.V, L);
    const double density = optics::bsdfDensity(twin.surface, twin.through, twin.chances, {0, 0, 1}, twin.V, L);
    if (drawn.density <= 0) return CheckValues{0, 0, 0, 0, f.r, f.g, f.b, density};
    return CheckValues{drawn.L.x, drawn.L.y, drawn.L.z, 1, f.r, f.g, f.b, density};
  };
  check.observe = [=](CheckVectors in, CheckVectors out) {
    const optics::BsdfSample drawn = sampleOf(sampledTwin(in), in);
    const double ratio = drawn.density > 0 ? out[0].w / drawn.density : out[0].w;
    const glm::dvec3 L = out[0].w > 0 ? xyzOf(out[0]) : glm::dvec3(0);
    return CheckValues{L.x, L.y, L.z, ratio, out[1].x, out[1].y, out[1].z, out[1].w};
  };
  check.floor = 0.1;
  check.conditioning = [](CheckVectors in) { return 1 + 0.04 / std::max(in[1].w * in[1].w, minAnalyticAlphaFloat); };
  allow(
      check, 1000,
      "sums of lobes of up to 60 roundings, cosines of large phases among them; H off by 2 epsilon, which D amplifies "
      "by 2 / alpha; sin and cos are the driver's");
  return check;
}

}  // namespace

std::vector<Check> samplingChecks() {
  std::vector<Check> checks = samplerChecks();
  for (const auto& more : {pairChecks(), std::vector<Check>{checkProxy(), checkWhole(), checkPoints(), checkPixelSeed(),
                                                            checkSpiralPoint()}})
    checks.insert(checks.end(), more.begin(), more.end());
  return checks;
}

}  // namespace facet::selftest
