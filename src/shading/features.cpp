#include "shading/features.hpp"

#include <algorithm>
#include <utility>

#include "scene/usage.hpp"
#include "shading/model_features.hpp"

namespace facet::shading {

namespace {

using scene::AlphaMode;
using scene::TextureRef;
using scene::TextureSlot;
using scene::Topology;

// Lines and points without normals cannot be lit (glTF 2.0, 3.7.2.1); triangles always have normals by now.
bool unlit(const FeatureInput& in) { return in.material.unlit || in.primitive.normals.empty(); }

bool sampled(const FeatureInput& in, TextureSlot slot) { return usesTexture(in.material, in.primitive, slot); }

bool shades(const FeatureInput& in) { return showsLight(in.frame.channel); }
bool channelIs(const FeatureInput& in, Channel which) { return isChannel(in.frame.channel, which); }

bool lacksChannel(const FeatureInput& in) {
  if (channelIs(in, Channel::occlusion) && !in.frame.occlusion) return true;
  return !shades(in) && !hasChannel(in.frame.channel, in.material, in.primitive);
}
// What the debug view reads of this draw; nothing where the picture is shaded.
bool viewReads(const FeatureInput& in, ChannelReads what) {
  return !shades(in) && (channelReads(in.frame.channel) & what) && !lacksChannel(in);
}

// glTF 2.0, 3.9.7: points and lines without normals show the sum of base colour and emission; unlit materials do not.
bool glowsUnlit(const FeatureInput& in) {
  return shades(in) && unlit(in) && !in.material.unlit && in.material.emissiveFactor != glm::vec3(0) &&
         in.material.emissiveStrength != 0;
}

// Shaded, or the debug view shows this very slot.
bool wanted(const FeatureInput& in, TextureSlot slot) {
  return shades(in) ? !unlit(in) : viewReads(in, reads::slot(slot));
}

bool measured(const FeatureInput& in) { return in.frame.measured != Measured::none && shades(in) && !unlit(in); }
bool measuredUtia(const FeatureInput& in) { return measured(in) && in.frame.measured == Measured::utia; }

bool readsNormal(const FeatureInput& in) {
  if (in.primitive.normals.empty()) return false;
  return shades(in) ? !in.material.unlit : viewReads(in, reads::normals);
}
bool readsBaseColor(const FeatureInput& in) {
  const bool alphaTested = in.material.alphaMode == AlphaMode::mask;
  if (measured(in)) return in.material.alphaMode != AlphaMode::opaque;
  return shades(in) || viewReads(in, reads::baseColor) || alphaTested;
}
bool baseColorTexture(const FeatureInput& in) {
  return sampled(in, TextureSlot::baseColor) &&
         (readsBaseColor(in) || viewReads(in, reads::slot(TextureSlot::baseColor)));
}
bool metallicRoughnessTexture(const FeatureInput& in) {
  if (in.material.specularGlossiness && channelIs(in, Channel::metallic)) return false;  // it is none
  if (measured(in)) return false;
  return sampled(in, TextureSlot::metallicRoughness) && wanted(in, TextureSlot::metallicRoughness);
}
bool isSpecularGlossiness(const FeatureInput& in) {
  return in.material.specularGlossiness && !measured(in) && wanted(in, TextureSlot::metallicRoughness);
}
bool normalTexture(const FeatureInput& in) {
  return sampled(in, TextureSlot::normal) && wanted(in, TextureSlot::normal) && !in.primitive.tangents.empty();
}
bool occlusionTexture(const FeatureInput& in) {
  return in.frame.occlusion && sampled(in, TextureSlot::occlusion) &&
         (shades(in) ? !unlit(in) && in.frame.environment : wanted(in, TextureSlot::occlusion));
}
bool emissiveTexture(const FeatureInput& in) {
  if (shades(in) && in.frame.channel != 0 && !channelIs(in, Channel::emitted)) return false;  // not of that part
  return sampled(in, TextureSlot::emissive) && (wanted(in, TextureSlot::emissive) || glowsUnlit(in));
}

// Materials of extensions: of the shaded picture of a metallic-roughness surface.
bool extended(const FeatureInput& in) {
  return shades(in) && !unlit(in) && !in.material.specularGlossiness && !measured(in);
}
// Is there light for the effects of extensions? What is behind shines through all of them.
bool reached(const FeatureInput& in) {
  return in.frame.punctualLights || in.frame.environment || in.frame.paths ||
         has(in.material, scene::Effect::transmission);
}
// What is below a coat and shines by itself shines through it.
bool glowsThroughCoat(const FeatureInput& in) {
  return in.material.emissiveFactor != glm::vec3(0) && in.material.emissiveStrength != 0;
}
bool samplesEffectSlot(const FeatureInput& in, TextureSlot slot) {
  if (slot == TextureSlot::clearcoatNormal && in.primitive.tangents.empty()) return false;
  if (!shades(in)) return sampled(in, slot) && wanted(in, slot);
  if (!extended(in) || !sampled(in, slot)) return false;
  const bool ofCoat =
      slot == TextureSlot::clearcoat || slot == TextureSlot::clearcoatRoughness || slot == TextureSlot::clearcoatNormal;
  return reached(in) || (ofCoat && glowsThroughCoat(in));
}
template <scene::Effect effect>
bool hasEffect(const FeatureInput& in) {
  if (effect == scene::Effect::anisotropy && in.primitive.tangents.empty()) return false;
  if (!extended(in) || !has(in.material, effect)) return false;
  return reached(in) || (effect == scene::Effect::clearcoat && glowsThroughCoat(in));
}

// Where those of the normal texture are not theirs.
bool readsCoatTangent(const FeatureInput& in) {
  return !in.primitive.coatTangents.empty() && samplesEffectSlot(in, TextureSlot::clearcoatNormal);
}
bool readsGrainTangent(const FeatureInput& in) {
  return !in.primitive.grainTangents.empty() &&
         (hasEffect<scene::Effect::anisotropy>(in) || isChannel(in.frame.channel, Channel::anisotropyDirection));
}
bool readsTangent(const FeatureInput& in) {
  return normalTexture(in) || (samplesEffectSlot(in, TextureSlot::clearcoatNormal) && !readsCoatTangent(in)) ||
         (hasEffect<scene::Effect::anisotropy>(in) && !readsGrainTangent(in)) ||
         ((viewReads(in, reads::tangents) || measuredUtia(in)) && !in.primitive.tangents.empty());
}

bool samplesSlotOf(const FeatureInput& in, TextureSlot slot) {
  switch (slot) {
    case TextureSlot::baseColor:
      return baseColorTexture(in);
    case TextureSlot::metallicRoughness:
      return metallicRoughnessTexture(in);
    case TextureSlot::normal:
      return normalTexture(in);
    case TextureSlot::occlusion:
      return occlusionTexture(in);
    case TextureSlot::emissive:
      return emissiveTexture(in);
    default:
      return samplesEffectSlot(in, slot);
  }
}

template <TextureSlot slot>
bool samples(const FeatureInput& in) {
  return samplesSlotOf(in, slot);
}

bool skinned(const FeatureInput& in) { return in.deformation.skinned && !in.primitive.influences.empty(); }
bool morphed(const FeatureInput& in) { return in.deformation.morphed && !in.primitive.targets.empty(); }
bool flatPerPixel(const FeatureInput& in) {
  return readsNormal(in) && in.primitive.flatNormals && (skinned(in) || morphed(in));
}

// A pixel that is shaded once shows a mean over its normals. Flat faces too: a program less costs more than it saves.
bool spreadsNormals(const FeatureInput& in) {
  if (!in.frame.shadedOnce || !shades(in) || unlit(in) || measured(in)) return false;
  return in.frame.punctualLights || in.frame.environment || hasEffect<scene::Effect::transmission>(in) ||
         hasEffect<scene::Effect::clearcoat>(in);
}

// Does any target change this attribute?
template <class T>
bool targetsChange(const FeatureInput& in, std::vector<T> scene::MorphTarget::*attribute) {
  return morphed(in) && std::ranges::any_of(in.primitive.targets,
                                            [&](const scene::MorphTarget& t) { return !(t.*attribute).empty(); });
}

bool anySlot(const FeatureInput& in, bool (*test)(const TextureRef&)) {
  for (const TextureSlot slot : scene::textureSlots)
    if (samplesSlotOf(in, slot) && test(textureRef(in.material, slot))) return true;
  return false;
}

// Where a texture is read through TEXCOORD_set, or the set is shown.
template <int set>
bool texCoords(const FeatureInput& in) {
  if (in.primitive.texCoords[set].empty()) return false;
  return viewReads(in, reads::texCoord(set)) || anySlot(in, [](const TextureRef& ref) { return ref.texCoord == set; });
}
bool transformsTexture(const FeatureInput& in) {
  return anySlot(in, [](const TextureRef& ref) { return ref.transform != scene::TextureTransform{}; });
}

// What is gathered from many draws is sharp without.
bool readsSlantedTextures(const FeatureInput& in) {
  return in.frame.textureReads && in.frame.shadedOnce && anySlot(in, [](const TextureRef&) { return true; });
}

bool readsVertexColor(const FeatureInput& in) {
  return !in.primitive.colors.empty() && (readsBaseColor(in) || viewReads(in, reads::vertexColors));
}
bool morphsNormals(const FeatureInput& in) {
  return readsNormal(in) && !flatPerPixel(in) && targetsChange(in, &scene::MorphTarget::normals);
}
bool morphsTangents(const FeatureInput& in) {
  return (readsTangent(in) && targetsChange(in, &scene::MorphTarget::tangents)) ||
         (readsCoatTangent(in) && targetsChange(in, &scene::MorphTarget::coatTangents)) ||
         (readsGrainTangent(in) && targetsChange(in, &scene::MorphTarget::grainTangents));
}
bool morphsTexCoords(const FeatureInput& in) {
  const auto changes = [&](int set) {
    const auto has = [&](const scene::MorphTarget& t) { return !t.texCoords[static_cast<size_t>(set)].empty(); };
    return std::ranges::any_of(in.primitive.targets, has);
  };
  const auto reads = [&]<int... set>(std::integer_sequence<int, set...>) {
    return ((texCoords<set>(in) && changes(set)) || ...);
  };
  return morphed(in) && reads(std::make_integer_sequence<int, scene::maxTexCoordSets>());
}
bool morphsColors(const FeatureInput& in) {
  return readsVertexColor(in) && targetsChange(in, &scene::MorphTarget::colors);
}

bool masksAlpha(const FeatureInput& in) { return in.material.alphaMode == AlphaMode::mask; }
bool blendsAlpha(const FeatureInput& in) { return in.material.alphaMode == AlphaMode::blend && shades(in); }
bool isDoubleSided(const FeatureInput& in) { return in.material.doubleSided && readsNormal(in); }
bool showsNoLight(const FeatureInput& in) { return unlit(in) || !shades(in); }
bool readsPunctualLights(const FeatureInput& in) { return in.frame.punctualLights && !showsNoLight(in); }
bool readsLightProfiles(const FeatureInput& in) { return in.frame.lightProfiles && readsPunctualLights(in); }
bool readsEnvironment(const FeatureInput& in) { return in.frame.environment && !showsNoLight(in); }
bool readsShadows(const FeatureInput& in) { return in.frame.shadows && readsPunctualLights(in); }
// What is seen through is not in the depth buffer that they are made of.
bool readsHorizons(const FeatureInput& in) {
  return in.frame.horizons && readsEnvironment(in) && in.material.alphaMode != AlphaMode::blend &&
         !has(in.material, scene::Effect::transmission);
}
bool tracesPaths(const FeatureInput& in) { return in.frame.paths && !showsNoLight(in); }
bool measuredMerl(const FeatureInput& in) { return measured(in) && in.frame.measured == Measured::merl; }
bool measuredNearest(const FeatureInput& in) {
  return measured(in) && in.frame.measuredNearest && !in.frame.measuredFitted;
}
bool fitted(const FeatureInput& in) { return measured(in) && in.frame.measuredFitted; }

constexpr FeatureRow rows[] = {
#define FEATURE(name, define, words, role, test) {Feature::name, #words, #define, FeatureRole::role, test},
#include "shading/features.inc"
#undef FEATURE
};
static_assert(std::size(rows) <= 8 * sizeof(FeatureBits));

FeatureBits bitsOf(FeatureRole role) {
  FeatureBits bits = 0;
  for (const FeatureRow& row : rows)
    if (row.role == role) bits |= bitOf(row.feature);
  return bits;
}

}  // namespace

bool samplesSlot(const FeatureInput& input, TextureSlot slot) { return samplesSlotOf(input, slot); }

std::span<const FeatureRow> featureTable() { return rows; }

VariantKey variantKey(const FeatureInput& input) {
  VariantKey key;
  key.channel = static_cast<uint8_t>(input.frame.channel);
  for (const FeatureRow& row : rows)
    if (row.usedBy(input)) key.features |= bitOf(row.feature);
  const bool environment = usesFeature(key, Feature::environment);
  if (environment || (input.frame.sampledBehind && usesFeature(key, Feature::transmission)))
    key.imageLightSamples = static_cast<uint16_t>(input.frame.imageLightSamples);
  if (measured(input)) {
    if (environment && key.imageLightSamples == 0)
      key.imageLightSamples = static_cast<uint16_t>(input.frame.measuredLightSamples);
    if (input.frame.measuredFitted) key.diffuse = static_cast<uint8_t>(input.frame.models.diffuse);
    return key;
  }
  setModels(input, key);
  return key;
}

std::vector<Define> variantDefines(const VariantKey& key) {
  std::vector<Define> defines;
  for (const FeatureRow& row : rows)
    if (usesFeature(key, row.feature)) defines.push_back({row.define});
  if (readsDfgTable(key)) defines.push_back({"HAS_DFG"});
  if (key.features & bitsOf(FeatureRole::layer)) defines.push_back({"HAS_LAYERS"});
  std::string present, absent;  // of material_draw.glsl
#define TEXTURE_SLOT(name, define, words, texel)                                 \
  if (usesFeature(key, Feature::name##Texture))                                  \
    present += "DO(" #name ", " + std::to_string(int(TextureSlot::name)) + ") "; \
  else                                                                           \
    absent += "DO(" #name ", " #texel ") ";
#include "texture_slots.inc"
#undef TEXTURE_SLOT
  defines.push_back({"EACH_TEXTURE(DO)", present});
  defines.push_back({"EACH_ABSENT_TEXTURE(DO)", absent});
  std::string sets;  // of tex_coords.glsl
  for (int set = 0; set < scene::maxTexCoordSets; ++set)
    if (usesFeature(key, texCoordFeature(set))) sets += "DO(" + std::to_string(set) + ") ";
  if (!sets.empty()) defines.push_back({"EACH_TEXCOORD(DO)", sets});
  if (key.channel != 0)
    defines.push_back({showsLight(key.channel) ? "LIGHT_PART" : "CHANNEL", std::to_string(key.channel)});
  if (isChannel(key.channel, Channel::node)) defines.push_back({"SHOWS_NODE"});
  if (channelKind(key.channel) == ChannelKind::direction) defines.push_back({"SHOWS_DIRECTION"});
  if (channelKind(key.channel) == ChannelKind::quantity) defines.push_back({"SHOWS_QUANTITY"});
  if (channelKind(key.channel) == ChannelKind::identity) defines.push_back({"SHOWS_IDENTITY"});
  if (key.imageLightSamples != 0) defines.push_back({"IMAGE_LIGHT_SAMPLES", std::to_string(key.imageLightSamples)});
  addModelDefines(key, defines);
  return defines;
}

std::string variantName(const VariantKey& key) {
  std::string name;
  for (const FeatureRow& row : rows)
    if (usesFeature(key, row.feature)) name += (name.empty() ? "" : ", ") + std::string(row.name);
  if (key.channel != 0) name += std::string(name.empty() ? "" : ", ") + "view of " + channelSetting(key.channel);
  if (key.imageLightSamples != 0) name += ", environment sampled";
  addModelNames(key, name);
  return name.empty() ? "plain" : name;
}

bool readsDfgTable(const VariantKey& key) {
  if (isMeasured(key)) return false;
  return usesFeature(key, Feature::environment) || usesFeature(key, Feature::punctualLights) ||
         usesFeature(key, Feature::transmission) || usesFeature(key, Feature::clearcoat) ||
         usesFeature(key, Feature::paths);
}

FrameFeatures pathFeatures(FrameFeatures drawn) {
  drawn.paths = true;
  drawn.difference = drawn.shadedOnce = drawn.shadows = drawn.horizons = false;
  drawn.imageLightSamples = 0;
  drawn.occlusion = false;  // occlusion textures would count twice
  return drawn;
}

FeatureBits attributeBits(const VariantKey& key) { return key.features & bitsOf(FeatureRole::attribute); }

VariantKey depthKey(const VariantKey& key) {
  FeatureBits read = bitOf(Feature::skin) | bitOf(Feature::morphTargets);
  if (usesFeature(key, Feature::alphaMask)) {
    read |= bitOf(Feature::alphaMask) | bitOf(Feature::baseColorTexture) | bitOf(Feature::textureTransform) |
            bitOf(Feature::vertexColors) | bitOf(Feature::morphedColors) | bitOf(Feature::morphedTexCoords);
    for (int set = 0; set < scene::maxTexCoordSets; ++set) read |= bitOf(texCoordFeature(set));
  }
  return {.features = key.features & read};
}

VariantKey fittedKey(const VariantKey& key, optics::DiffuseModel diffuse) {
  if (!isMeasured(key)) return key;
  VariantKey fitted = key;
  fitted.features |= bitOf(Feature::fittedBrdf);
  fitted.features &= ~bitOf(Feature::measuredNearest);
  fitted.diffuse = static_cast<uint8_t>(diffuse);
  return fitted;
}

bool isMeasured(const VariantKey& key) {
  return usesFeature(key, Feature::merlBrdf) || usesFeature(key, Feature::utiaBrdf);
}

}  // namespace facet::shading
