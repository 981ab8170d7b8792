#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdio>
#include <functional>

#include "optics/bsdf.hpp"
#include "optics/iridescence.hpp"
#include "optics/normal_spread.hpp"
#include "optics/quadrature.hpp"
#include "optics/reference.hpp"
#include "optics/sheen.hpp"
#include "scene/usage.hpp"
#include "support/picture.hpp"

using namespace facet;
using frame::PictureSettings;
using test::at, test::emptyScene;
using test::GltfBuilder;

namespace {

struct Extension {
  const char* name;
  std::function<void(scene::Material&, float roughness)> apply;
};

void coat(scene::Material& m, float roughness) { m.clearcoatFactor = 1, m.clearcoatRoughnessFactor = roughness; }
void halfCoat(scene::Material& m, float roughness) { m.clearcoatFactor = 0.5f, m.clearcoatRoughnessFactor = roughness; }
void cloth(scene::Material& m, float roughness) {
  m.sheenColorFactor = glm::vec3(1, 0.5f, 0.2f), m.sheenRoughnessFactor = roughness;
}
void film(scene::Material& m, float) { m.iridescenceFactor = 1, m.iridescenceThicknessMaximum = 350; }
void grain(scene::Material& m, float) { m.anisotropyStrength = 0.8f; }
void specular(scene::Material& m, float) { m.ior = 2, m.specularWeight = 0.7f, m.specularColorFactor = {1, 0.4f, 2}; }
void metal(scene::Material& m, float) { m.metallicFactor = 1; }

const Extension extensions[] = {
    {"none", [](scene::Material&, float) {}},
    {"specular, ior", specular},
    {"ior 0", [](scene::Material& m, float) { m.ior = 0; }},
    {"clearcoat", coat},
    {"sheen", cloth},
    {"iridescence", film},
    {"anisotropy", grain},
    {"metal", metal},
    {"metal, clearcoat", [](scene::Material& m, float r) { metal(m, r), coat(m, r); }},
    {"metal, sheen", [](scene::Material& m, float r) { metal(m, r), cloth(m, r); }},
    {"metal, iridescence", [](scene::Material& m, float r) { metal(m, r), film(m, r); }},
    {"metal, anisotropy", [](scene::Material& m, float r) { metal(m, r), grain(m, r); }},
    {"metal, anisotropy, clearcoat", [](scene::Material& m, float r) { metal(m, r), grain(m, r), coat(m, 0); }},
    {"metal, anisotropy, iridescence", [](scene::Material& m, float r) { metal(m, r), grain(m, r), film(m, r); }},
    {"clearcoat, sheen", [](scene::Material& m, float r) { halfCoat(m, 0), cloth(m, r); }},
    {"clearcoat, iridescence", [](scene::Material& m, float r) { coat(m, 0.2f), film(m, r); }},
    {"specular, sheen", [](scene::Material& m, float r) { specular(m, r), cloth(m, r); }},
    {"specular, iridescence", [](scene::Material& m, float r) { specular(m, r), film(m, r); }},
    {"specular, clearcoat, anisotropy", [](scene::Material& m, float r) { specular(m, r), coat(m, r), grain(m, r); }},
    {"sheen, iridescence, clearcoat", [](scene::Material& m, float r) { cloth(m, r), film(m, r), halfCoat(m, r); }},
    {"diffuse roughness", [](scene::Material& m, float) { m.diffuseRoughnessFactor = 1; }},
    {"diffuse roughness, sheen, clearcoat",
     [](scene::Material& m, float r) { m.diffuseRoughnessFactor = 0.5f, cloth(m, r), halfCoat(m, r); }},
    {"all", [](scene::Material& m, float r) { specular(m, r), coat(m, r), cloth(m, r), film(m, r), grain(m, r); }},
    {"half metal, all",
     [](scene::Material& m, float r) {
       specular(m, r), coat(m, r), cloth(m, r), film(m, r), grain(m, r), m.metallicFactor = 0.5f;
     }},
};

const float roughnesses[] = {0, 0.1f, 0.4f, 0.7f, 1};
constexpr int columns = 5, patch = 40;

// Spheres of a white material, one for each roughness, in a row; tangents as MikkTSpace would give for longitude.
io::LoadedModel sphereRow(const Extension& extension) {
  GltfBuilder builder = emptyScene();
  for (int i = 0; i < columns; ++i)
    test::addMeshNode(builder, test::addSphere(builder, 0.5, 48, 96),
                      builder.append("materials", test::material({1, 1, 1, 1}, 0, double(roughnesses[i]))),
                      at(i - 2, 0, 0));
  test::addOrthographicCamera(builder, columns / 2.0, 0.5);
  io::LoadedModel model = test::loadBuilt(builder);
  for (int i = 0; i < columns; ++i) extension.apply(model.model.materials[size_t(i)], roughnesses[i]);
  for (scene::Mesh& mesh : model.model.meshes)
    for (scene::Primitive& primitive : mesh.primitives) {
      primitive.tangents.clear();
      for (const glm::vec3& n : primitive.normals)
        primitive.tangents.emplace_back(std::hypot(n.x, n.z) > 0 ? glm::normalize(glm::vec3(n.z, 0, -n.x)) : n, 1.0f);
    }
  return model;
}

PictureSettings rowSettings(const char* environment) {
  PictureSettings settings = test::bareSettings(columns * patch, patch);
  settings.viewpoint.camera = "0";
  settings.sources.environment = environment;
  return settings;
}

// The sphere's normal at a pixel's centre; false off the sphere or on its rim.
bool normalAt(int x, int y, glm::dvec3& N) {
  const double u = (x % patch + 0.5) / patch * 2 - 1, v = 1 - (y + 0.5) / patch * 2, r2 = u * u + v * v;
  if (r2 > 0.98) return false;
  N = {u, v, std::sqrt(1 - r2)};
  return true;
}

// How far the normal turns within the two by two pixels that a GPU takes derivatives of; false near the rim.
bool turnAt(int x, int y, glm::dvec3& dNdx, glm::dvec3& dNdy) {
  glm::dvec3 left, right, upper, lower;
  if (!normalAt(x & ~1, y, left) || !normalAt(x | 1, y, right)) return false;
  if (!normalAt(x, y & ~1, upper) || !normalAt(x, y | 1, lower)) return false;
  dNdx = right - left, dNdy = lower - upper;
  return true;
}

struct Range {
  float low = 1e9f, high = -1e9f;
};
Range rangeOf(const io::RadianceImage& image) {
  Range range;
  for (const glm::vec4& p : image.pixels)
    if (p.w == 1) range.low = std::min({range.low, p.x, p.y, p.z}), range.high = std::max({range.high, p.x, p.y, p.z});
  return range;
}

}  // namespace

TEST_CASE("Layers: no furnace gains, by any extension or sum of them") {
  test::Studio studio;
  std::printf("%-34s %8s %8s   %8s %8s\n", "white furnace", "split", "sum", "sampled", "");
  for (const Extension& extension : extensions) {
    const io::LoadedModel model = sphereRow(extension);
    PictureSettings settings = rowSettings("builtin:white");
    const frame::Picture split = studio.render(model, settings);
    settings.quality.samples = 8;
    const frame::Picture sampled = studio.render(model, settings);
    const Range a = rangeOf(split.radiance), b = rangeOf(sampled.radiance);
    std::printf("%-34s %8.4f %8.4f   %8.4f %8.4f\n", extension.name, a.low, a.high, b.low, b.high);
    INFO(extension.name);
    CHECK(split.statistics.nonFinitePixels == 0);
    CHECK(sampled.statistics.nonFinitePixels == 0);
    CHECK(a.high <= 1.001f);
  }
}

namespace {

optics::Surface surfaceOf(const scene::Material& m, const glm::dvec3& N, const glm::dvec3& dNdx,
                          const glm::dvec3& dNdy) {
  const auto overPixel = [&](float r) { return optics::roughnessOverPixel(double(r), dNdx, dNdy); };
  optics::Surface s{glm::dvec3(1), double(m.metallicFactor), overPixel(m.perceptualRoughnessFactor)};
  if (has(m, scene::Effect::dielectricSpecular))
    optics::setDielectricSpecular(s, double(m.ior), double(m.specularWeight), glm::dvec3(m.specularColorFactor));
  s.coat = {double(m.clearcoatFactor), overPixel(m.clearcoatRoughnessFactor), N};
  s.sheen = {glm::dvec3(m.sheenColorFactor), double(m.sheenRoughnessFactor)};
  s.film = {double(m.iridescenceFactor), double(m.iridescenceIor), double(m.iridescenceThicknessMaximum)};
  s.grain = {double(m.anisotropyStrength), glm::normalize(glm::dvec3(N.z, 0, -N.x))};
  if (has(m, scene::Effect::diffuseRoughness)) s.diffuseRoughness = double(m.diffuseRoughnessFactor);
  return s;
}

}  // namespace

TEST_CASE("Layers: one light on spheres is what the twin says") {
  test::Studio studio;
  const glm::dvec3 V(0, 0, 1), L = glm::normalize(glm::dvec3(0.5, 0.4, 0.77));
  double worst = 0;
  for (const Extension& extension : extensions) {
    io::LoadedModel model = sphereRow(extension);
    scene::Light light;
    light.type = scene::LightType::directional;
    light.intensity = 1;
    model.model.lights.push_back(light);
    scene::Node node;
    node.light = int(model.model.lights.size()) - 1;
    node.rotation = glm::normalize(glm::dquat(1 + L.z, glm::cross(glm::dvec3(0, 0, 1), L)));
    model.model.scenes[0].nodes.push_back(int(model.model.nodes.size()));
    model.model.nodes.push_back(node);
    const frame::Picture picture = studio.render(model, rowSettings("none"));
    double largest = 0, sharpest = 0;  // of roughness 0.1
    for (int y = 5; y < patch; y += 7)
      for (int x = 2; x < columns * patch; x += 7) {
        glm::dvec3 N, dNdx, dNdy;
        if (!normalAt(x, y, N) || !turnAt(x, y, dNdx, dNdy) || glm::dot(N, L) < 0.02) continue;
        if (x / patch == 0) continue;  // nearly a mirror: the rounding of its normals counts
        const optics::Surface surface = surfaceOf(model.model.materials[size_t(x / patch)], N, dNdx, dNdy);
        const glm::dvec3 expected = optics::evaluate(surface, optics::albedosOf(surface, N, V, L), N, V, L);
        const glm::vec4& got = test::pixel(picture.radiance, x, y);
        double error = 0;
        for (int i = 0; i < 3; ++i)
          error = std::max(error, std::abs(double(got[i]) - expected[i]) / (expected[i] + 0.02));
        double& worstThere = x / patch == 1 ? sharpest : largest;
        worstThere = std::max(worstThere, error);
      }
    std::printf("one light, %-34s off by %.4f, of roughness 0.1 by %.4f\n", extension.name, largest, sharpest);
    INFO(extension.name);
    CHECK(largest < 0.05);
    CHECK(sharpest < 0.3);  // there the normal's turn is that of the sphere's triangles
    worst = std::max(worst, largest);
  }
  CHECK(worst > 0);
}

TEST_CASE("Layers: what shines by itself looks alike where nothing lights it and where a light of no intensity does") {
  constexpr int cell = 32;
  std::vector<Extension> all(std::begin(extensions), std::end(extensions));
  const auto glass = [](scene::Material& m, float) { m.transmissionFactor = 0.7f; };
  all.push_back({"transmission", glass});
  all.push_back({"transmission, all", [&](scene::Material& m, float r) { all[22].apply(m, r), glass(m, r); }});
  all.push_back({"volume", [&](scene::Material& m, float r) { glass(m, r), m.thicknessFactor = 0.1f; }});
  all.push_back({"diffuse transmission", [](scene::Material& m, float) { m.diffuseTransmissionFactor = 0.5f; }});
  test::Studio studio;
  double darkest = 1;
  for (const Extension& extension : all) {
    io::LoadedModel model = sphereRow(extension);
    for (scene::Material& m : model.model.materials) m.emissiveFactor = {1, 0.5f, 0.25f};
    PictureSettings settings = rowSettings("none");
    settings.frame.background = frame::Background::color;
    settings.frame.backgroundColor = {0.2f, 0.4f, 0.1f};
    const frame::Picture alone = studio.render(model, settings);
    scene::Light light;
    light.intensity = 0;
    model.model.lights.push_back(light);
    scene::Node node;
    node.light = int(model.model.lights.size()) - 1;
    model.model.scenes[0].nodes.push_back(int(model.model.nodes.size()));
    model.model.nodes.push_back(node);
    const frame::Picture lit = studio.render(model, settings);
    REQUIRE(alone.radiance.pixels.size() == lit.radiance.pixels.size());
    float most = 0;
    for (size_t i = 0; i < alone.radiance.pixels.size(); ++i)
      for (int c = 0; c < 4; ++c)
        most = std::max(most, std::abs(alone.radiance.pixels[i][c] - lit.radiance.pixels[i][c]));
    INFO(extension.name);
    CHECK(most < 1e-3f);  // a half's rounding
    darkest = std::min(darkest, double(test::pixel(alone.radiance, 2 * cell + cell / 2, cell / 2).r));
  }
  CHECK(darkest < 0.97);  // a coat takes its share
}

TEST_CASE("Layers: a plain material costs the same beside one that has them all") {
  const io::LoadedModel plain = sphereRow(extensions[0]);
  io::LoadedModel mixed = sphereRow(extensions[0]);
  std::prev(std::end(extensions))->apply(mixed.model.materials[1], 0.4f);
  const auto listOf = [](const io::LoadedModel& model) {
    return frame::buildDrawList(model.model, 0, frame::drawOptions(rowSettings("builtin:white"), true));
  };
  const auto textOf = [](const frame::DrawList& list, int material) {
    for (const frame::Draw& draw : list.opaque)
      if (draw.material == material) {
        const auto defines = shading::variantDefines(draw.key);
        const auto assembled = shading::assemble("passes/mesh.frag.glsl", defines, shading::shaderReader());
        REQUIRE(assembled);
        return assembled->text;
      }
    return std::string();
  };
  const frame::DrawList a = listOf(plain), b = listOf(mixed);
  CHECK_FALSE(textOf(a, 0).empty());
  CHECK(textOf(a, 0) == textOf(b, 0));
  CHECK(textOf(b, 0) != textOf(b, 1));
  CHECK_FALSE(a.needs(false).sheen);
  CHECK(b.needs(false).sheen);
  test::Studio studio;
  const frame::Picture picture = studio.render(plain, rowSettings("builtin:white"));
  for (const ibl::TableStatistics& table : picture.statistics.tables) CHECK(table.name != "sheen");
}
