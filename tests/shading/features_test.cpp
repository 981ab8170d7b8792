#include "shading/features.hpp"

#include <bit>
#include <catch2/catch.hpp>
#include <set>

using namespace facet;
using scene::Material;
using scene::Primitive;
using shading::FrameFeatures;

namespace {

constexpr FrameFeatures lit{.punctualLights = true, .environment = true};

// A triangle with everything that a file can give it.
Primitive fullPrimitive() {
  Primitive p;
  p.positions.resize(3);
  p.normals.resize(3);
  p.tangents.resize(3);
  p.texCoords[0].resize(3);
  p.texCoords[1].resize(3);
  return p;
}

Material fullMaterial() {
  Material m;
  for (scene::TextureRef* ref : {&m.baseColor, &m.metallicRoughness, &m.normal, &m.occlusion, &m.emissive})
    ref->texture = 0;
  m.emissiveFactor = glm::vec3(1);
  return m;
}

std::string variant(const Material& m, const Primitive& p, const FrameFeatures& frame) {
  return shading::variantName(shading::variantKey({m, p, frame}));
}

FrameFeatures view(const char* channel) {
  FrameFeatures frame = lit;
  frame.channel = shading::channelIndex(channel);
  return frame;
}

}  // namespace

TEST_CASE("Variants hold what material, vertices and frame use, and nothing else") {
  const Primitive full = fullPrimitive();
  CHECK(variant({}, full, {}) == "normals");
  CHECK(variant({}, full, lit) == "normals, punctual lights, environment");
  CHECK(variant(fullMaterial(), full, lit) ==
        "normals, tangents, uv0, base colour texture, metallic-roughness texture, normal texture, occlusion texture, "
        "emissive texture, punctual lights, environment");

  Material second = {};
  second.baseColor.texture = 0;
  second.baseColor.texCoord = 1;
  CHECK(variant(second, full, {}) == "normals, uv1, base colour texture");
  second.baseColor.transform.scale = glm::vec2(2);
  CHECK(variant(second, full, {}) == "normals, uv1, base colour texture, texture transform");

  Primitive sets = full;
  sets.texCoords[7].resize(3);
  second.emissive = {.texture = 0, .texCoord = 7, .transform = {}};
  second.emissiveFactor = glm::vec3(1);
  CHECK(variant(second, sets, {}) == "normals, uv1, uv7, base colour texture, emissive texture, texture transform");
  const auto key = shading::variantKey({second, sets, {}});
  const auto defines = shading::variantDefines(key);
  CHECK(defines.back().name == "EACH_TEXCOORD(DO)");
  CHECK(defines.back().value == "DO(1) DO(7) ");
  // One bit each for the normals and the two sets.
  CHECK(std::popcount(static_cast<uint64_t>(shading::attributeBits(key))) == 3);
  // A normal texture is no attribute, though its define begins like the normals'.
  const auto bumped = shading::variantKey({fullMaterial(), full, lit});
  REQUIRE(shading::usesFeature(bumped, shading::Feature::normalTexture));
  CHECK(std::popcount(static_cast<uint64_t>(shading::attributeBits(bumped))) == 3);  // normals, tangents, uv0

  Material shiny = fullMaterial();
  shiny.specularGlossiness = true;
  CHECK(variant(shiny, full, lit) ==
        "normals, tangents, uv0, specular-glossiness, base colour texture, metallic-roughness texture, normal texture, "
        "occlusion texture, emissive texture, punctual lights, environment");
  CHECK(variant(shiny, full, view("roughness")) ==
        "uv0, specular-glossiness, metallic-roughness texture, unlit, view of roughness");
  CHECK(variant(shiny, full, view("metallic")) == "specular-glossiness, unlit, view of metallic");
  CHECK(variant(shiny, full, view("uv")) == "uv0, unlit, view of uv");
  shiny.specularFactor = glm::vec3(0);
  CHECK(shading::samplesSlot({shiny, full, lit}, scene::TextureSlot::metallicRoughness));
  shiny.glossinessFactor = 0;
  CHECK_FALSE(shading::samplesSlot({shiny, full, lit}, scene::TextureSlot::metallicRoughness));

  Material glass;
  glass.alphaMode = scene::AlphaMode::blend;
  glass.doubleSided = true;
  CHECK(variant(glass, full, lit) == "normals, alpha blend, double-sided, punctual lights, environment");
  glass.alphaMode = scene::AlphaMode::mask;
  CHECK(variant(glass, full, {}) == "normals, alpha mask, double-sided");

  Primitive colored = full;
  colored.colors.resize(3);
  CHECK(variant({}, colored, {}) == "normals, vertex colours");
}

TEST_CASE("Variants: combinations without sense fold") {
  const Primitive full = fullPrimitive();
  // Unlit: no light, none of the textures that only light shows.
  Material unlit = fullMaterial();
  unlit.unlit = true;
  CHECK(variant(unlit, full, lit) == "uv0, base colour texture, unlit");
  // Lines without normals cannot be lit, and show what they emit.
  Primitive lines = full;
  lines.normals.clear();
  lines.topology = scene::Topology::lines;
  CHECK(variant(fullMaterial(), lines, lit) ==
        "uv0, base colour texture, emissive texture, unlit, emission of what has no normals");
  CHECK(variant(unlit, lines, lit) == "uv0, base colour texture, unlit");
  // A normal texture without tangents, textures without coordinates.
  Primitive plain = full;
  plain.tangents.clear();
  Material bumpy;
  bumpy.normal.texture = 0;
  CHECK(variant(bumpy, plain, {}) == "normals");
  plain.texCoords[0].clear();
  CHECK(variant(fullMaterial(), plain, lit) == "normals, punctual lights, environment");
  // Occlusion dims distant light only, and can be switched off.
  Material dim;
  dim.occlusion.texture = 0;
  CHECK(variant(dim, full, {.punctualLights = true}) == "normals, punctual lights");
  CHECK(variant(dim, full, {.environment = true}) == "normals, uv0, occlusion texture, environment");
  CHECK(variant(dim, full, {.environment = true, .occlusion = false}) == "normals, environment");
  // Double-sided without a normal to turn round.
  Material bothSides;
  bothSides.doubleSided = true;
  CHECK(variant(bothSides, lines, {}) == "unlit");
  // A transform of a texture that is not read.
  Material moved;
  moved.occlusion.texture = 0;
  moved.occlusion.transform.rotation = 1;
  CHECK(variant(moved, full, {}) == "normals");
}

TEST_CASE("Variants: nothing of an extension where no light reaches it") {
  const Primitive full = fullPrimitive();
  Material m;
  m.clearcoatFactor = m.sheenColorFactor.r = m.iridescenceFactor = m.diffuseTransmissionFactor = 1;
  m.clearcoatRoughnessFactor = 1;
  m.clearcoatRoughness.texture = m.sheenColor.texture = 0;
  CHECK(variant(m, full, {}) == "normals");
  CHECK_FALSE(shading::samplesSlot({m, full, {}}, scene::TextureSlot::clearcoatRoughness));
  // What shines by itself shines through the coat.
  m.emissiveFactor = glm::vec3(1);
  CHECK(variant(m, full, {}) == "normals, uv0, clearcoat, clearcoat roughness texture");
  CHECK(shading::readsDfgTable(shading::variantKey({m, full, {}})));
  m.emissiveStrength = 0;
  CHECK(variant(m, full, {}) == "normals");
  CHECK_FALSE(shading::readsDfgTable(shading::variantKey({m, full, {}})));
  // What is behind shines through all of them.
  m.transmissionFactor = 1;
  CHECK(variant(m, full, {}) ==
        "normals, uv0, clearcoat, sheen, iridescence, transmission, diffuse transmission, clearcoat roughness texture, "
        "sheen colour texture");
  CHECK(shading::readsDfgTable(shading::variantKey({m, full, {}})));
}

TEST_CASE("Debug views read what they show and nothing else") {
  const Primitive full = fullPrimitive();
  const Material all = fullMaterial();
  CHECK(variant(all, full, view("roughness")) == "uv0, metallic-roughness texture, unlit, view of roughness");
  CHECK(variant(all, full, view("baseColor")) == "uv0, base colour texture, unlit, view of baseColor");
  CHECK(variant(all, full, view("uv")) == "uv0, unlit, view of uv");
  CHECK(variant(all, full, view("geometryNormal")) == "normals, unlit, view of geometryNormal");
  CHECK(variant(all, full, view("normal")) == "normals, tangents, uv0, normal texture, unlit, view of normal");
  CHECK(variant(all, full, view("occlusion")) == "uv0, occlusion texture, unlit, view of occlusion");
  // Mask still cuts, blend does not mix.
  Material cut = all;
  cut.alphaMode = scene::AlphaMode::mask;
  CHECK(variant(cut, full, view("uv")) == "uv0, base colour texture, alpha mask, unlit, view of uv");
  cut.alphaMode = scene::AlphaMode::blend;
  CHECK(variant(cut, full, view("uv")) == "uv0, unlit, view of uv");
}

TEST_CASE("The feature table: one define and one bit each, keys compare by value") {
  const auto table = shading::featureTable();
  CHECK(table.size() <= 8 * sizeof(shading::FeatureBits));
  std::set<std::string> names, defines;
  for (const shading::FeatureRow& row : table) names.insert(row.name), defines.insert(row.define);
  CHECK(names.size() == table.size());
  for (size_t i = 0; i < table.size(); ++i) CHECK(table[i].feature == shading::Feature(i));
  for (const scene::TextureSlot slot : scene::textureSlots)
    CHECK(table[size_t(shading::Feature::baseColorTexture) + size_t(slot)].role == shading::FeatureRole::texture);
  CHECK(defines.size() == table.size());

  const Primitive full = fullPrimitive();
  const auto key = shading::variantKey({fullMaterial(), full, lit});
  CHECK(key == shading::variantKey({fullMaterial(), full, lit}));
  CHECK(key != shading::variantKey({fullMaterial(), full, {}}));
  CHECK(shading::usesFeature(key, shading::Feature::environment));
  CHECK_FALSE(shading::usesFeature(key, shading::Feature::unlit));
  const auto shown = shading::variantKey({Material{}, full, view("metallic")});
  const auto list = shading::variantDefines(shown);
  REQUIRE(list.size() == 4);
  CHECK(list[0].name == "UNLIT");
  CHECK(list[1].name == "EACH_TEXTURE(DO)");
  CHECK(list[1].value == "");
  CHECK(list[2].name == "EACH_ABSENT_TEXTURE(DO)");
  CHECK(
      list[2].value.starts_with("DO(baseColor, vec4(1.0)) DO(metallicRoughness, vec4(1.0)) DO(normal, vec4(0.5, 0.5,"));
  CHECK(list[3].name == "CHANNEL");
  CHECK(list[3].value == std::to_string(shading::channelIndex("metallic")));
  Material worn;  // each texture on its own unit
  worn.normal.texture = worn.emissive.texture = 0;
  worn.emissiveFactor = glm::vec3(1);
  for (const shading::Define& define : shading::variantDefines(shading::variantKey({worn, full, lit})))
    if (define.name == "EACH_TEXTURE(DO)") CHECK(define.value == "DO(normal, 2) DO(emissive, 4) ");
  CHECK(shading::channelIndex("colour") == -1);
  CHECK(shading::channelKind(shading::channelIndex("emissive")) == shading::ChannelKind::color);
  CHECK(shading::channelKind(shading::channelIndex("normal")) == shading::ChannelKind::direction);
}

TEST_CASE("Models: only what the draw can show enters its key, and the defaults add no define") {
  const Primitive full = fullPrimitive();
  const auto definesOf = [&](const Material& m, const FrameFeatures& frame) {
    std::set<std::string> names;
    for (const shading::Define& define : shading::variantDefines(shading::variantKey({m, full, frame})))
      names.insert(define.name);
    return names;
  };
  Material dielectric, metal, gold;
  dielectric.metallicFactor = 0;
  gold.conductor = "gold";
  const std::set<std::string> plain = definesOf(dielectric, lit);
  for (const char* name : {"DIFFUSE_MODEL", "FRESNEL_MODEL", "NDF_MODEL", "MASKING_MODEL", "CONDUCTOR_F0"})
    CHECK(plain.count(name) == 0);

  FrameFeatures diffuse = lit;
  diffuse.models.diffuse = optics::DiffuseModel::eon;
  CHECK(variant(dielectric, full, diffuse) == "normals, punctual lights, environment, EON");
  CHECK(shading::variantKey({metal, full, diffuse}) == shading::variantKey({metal, full, lit}));
  Material unlit = dielectric;
  unlit.unlit = true;
  CHECK(shading::variantKey({unlit, full, diffuse}) == shading::variantKey({unlit, full, lit}));

  FrameFeatures exact = lit;
  exact.models.fresnel = optics::FresnelModel::exact;
  CHECK(definesOf(dielectric, exact).count("FRESNEL_MODEL") == 1);
  CHECK(definesOf(dielectric, exact).count("CONDUCTOR_F0") == 0);
  CHECK(definesOf(metal, exact).count("FRESNEL_MODEL") == 0);
  CHECK(definesOf(gold, exact).count("CONDUCTOR_F0") == 1);
  CHECK(variant(gold, full, exact) == "normals, punctual lights, environment, exact Fresnel of gold");
  exact.models.fresnel = optics::FresnelModel::f82Tint;
  CHECK(definesOf(dielectric, exact).count("FRESNEL_MODEL") == 0);
  CHECK(definesOf(gold, exact).count("FRESNEL_MODEL") == 1);
  exact.punctualLights = false;  // the environment's tables are Schlick's
  CHECK(definesOf(gold, exact).count("FRESNEL_MODEL") == 0);
  exact.imageLightSamples = 4;
  CHECK(definesOf(gold, exact).count("FRESNEL_MODEL") == 1);

  FrameFeatures lobes = lit;
  lobes.models.distribution = optics::NormalDistribution::beckmann;
  lobes.models.masking = optics::Masking::cavity;
  CHECK(variant(metal, full, lobes) == "normals, punctual lights, environment, Beckmann, V-cavities");
  Material brushed = metal;  // a grain is GGX's
  brushed.anisotropyStrength = 0.5f;
  CHECK(shading::variantKey({brushed, full, lobes}) == shading::variantKey({brushed, full, lit}));
  metal.microfacets = scene::Microfacets::ggx;  // the material's own word counts
  CHECK(variant(metal, full, lobes) == "normals, punctual lights, environment, V-cavities");
  metal.microfacets = scene::Microfacets::blinn;
  CHECK(variant(metal, full, lit) == "normals, punctual lights, environment, Blinn");
  lobes.punctualLights = false;
  CHECK(shading::variantKey({metal, full, lobes}).distribution == 0);

  // A pixel that is shaded once shows its normals' spread, where normals vary and something shines.
  FrameFeatures once = lit;
  once.shadedOnce = true;
  CHECK(definesOf(gold, once).count("SPREAD_NORMALS") == 1);
  CHECK(definesOf(gold, lit).count("SPREAD_NORMALS") == 0);
  once.channel = 1;
  CHECK(definesOf(gold, once).count("SPREAD_NORMALS") == 0);
  once.channel = 0;
  once.environment = once.punctualLights = false;
  CHECK(definesOf(gold, once).count("SPREAD_NORMALS") == 0);

  // Slanted textures are read several times where a pixel is shaded once, and where there are any.
  once = lit;
  once.textureReads = true;
  scene::Material painted = gold;
  painted.baseColor.texture = 0;
  CHECK(definesOf(painted, once).count("SLANTED_TEXTURES") == 0);
  once.shadedOnce = true;
  CHECK(definesOf(painted, once).count("SLANTED_TEXTURES") == 1);
  CHECK(definesOf(gold, once).count("SLANTED_TEXTURES") == 0);
  once.textureReads = false;
  CHECK(definesOf(painted, once).count("SLANTED_TEXTURES") == 0);

  FrameFeatures looked = lit;
  looked.models.imageLight = optics::ImageLight::taps2;
  CHECK(variant(gold, full, looked) == "normals, punctual lights, environment, 2 fitted taps");
  CHECK(definesOf(gold, looked).count("IMAGE_LIGHT_MODEL") == 1);
  CHECK(shading::imageLightTaps(shading::variantKey({gold, full, looked})) == 2);
  CHECK(shading::imageLightTaps(shading::variantKey({gold, full, lit})) == 3);
  looked.models.imageLight = optics::ImageLight::mean;
  CHECK(shading::imageLightTaps(shading::variantKey({gold, full, looked})) == 0);
  looked.models.imageLight = optics::ImageLight::taps3;  // what the default is
  CHECK(shading::variantKey({gold, full, looked}) == shading::variantKey({gold, full, lit}));
  looked.models.imageLight = optics::ImageLight::mirror;
  looked.imageLightSamples = 4;  // looks nothing up
  CHECK(shading::imageLightTaps(shading::variantKey({gold, full, looked})) == 0);
  CHECK(definesOf(gold, looked).count("IMAGE_LIGHT_MODEL") == 0);
  looked.imageLightSamples = 0;
  looked.environment = false;
  CHECK(definesOf(gold, looked).count("IMAGE_LIGHT_MODEL") == 0);

  // Only where it differs from what the automatic choice means there.
  FrameFeatures energy = lit;
  energy.models.energy = optics::EnergyModel::turquin;
  CHECK(variant(gold, full, energy) == "normals, punctual lights, environment, energy: Turquin");
  CHECK(definesOf(gold, energy).count("ENERGY_MODEL") == 1);
  CHECK(definesOf(gold, lit).count("ENERGY_MODEL") == 0);
  CHECK(shading::variantKey({unlit, full, energy}) == shading::variantKey({unlit, full, lit}));
  energy.environment = false;
  CHECK(shading::variantKey({gold, full, energy}).energy == 0);
  energy.models.energy = optics::EnergyModel::fdezAguera;
  CHECK(shading::variantKey({gold, full, energy}).energy == 2);
  energy.models.distribution = optics::NormalDistribution::beckmann;  // no compensation, but what the base gets
  CHECK(shading::variantKey({gold, full, energy}).energy == 0);
  CHECK(shading::variantKey({dielectric, full, energy}).energy == 2);
  energy.environment = true, energy.punctualLights = false;
  CHECK(shading::variantKey({gold, full, energy}).energy == 0);
}
