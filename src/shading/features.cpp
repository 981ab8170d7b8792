#include "shading/features.hpp"

#include <algorithm>
#include <cassert>
#include <cstdio>
#include <cstring>

#include "optics/fresnel.hpp"
#include "optics/presets.hpp"
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

bool channelIs(const FeatureInput& in, const char* name) { return in.frame.channel == channelIndex(name); }

// Shaded, or the debug view shows this very slot.
bool wanted(const FeatureInput& in, const char* channel) {
  return in.frame.channel == 0 ? !unlit(in) : channelIs(in, channel);
}

bool measured(const FeatureInput& in) {
  return in.frame.measured != Measured::none && in.frame.channel == 0 && !unlit(in);
}
bool measuredUtia(const FeatureInput& in) { return measured(in) && in.frame.measured == Measured::utia; }

bool readsNormal(const FeatureInput& in) {
  if (in.primitive.normals.empty()) return false;
  return in.frame.channel == 0 ? !in.material.unlit : channelIs(in, "normal") || channelIs(in, "geometryNormal");
}
bool readsBaseColor(const FeatureInput& in) {
  const bool alphaTested = in.material.alphaMode == AlphaMode::mask;
  if (measured(in)) return in.material.alphaMode != AlphaMode::opaque;
  return in.frame.channel == 0 || channelIs(in, "baseColor") || channelIs(in, "alpha") || alphaTested;
}
bool baseColorTexture(const FeatureInput& in) { return sampled(in, TextureSlot::baseColor) && readsBaseColor(in); }
bool metallicRoughnessTexture(const FeatureInput& in) {
  if (in.material.specularGlossiness && channelIs(in, "metallic")) return false;  // it is none
  if (measured(in)) return false;
  return sampled(in, TextureSlot::metallicRoughness) && (wanted(in, "metallic") || channelIs(in, "roughness"));
}
bool specularGlossiness(const FeatureInput& in) {
  return in.material.specularGlossiness && !measured(in) && (wanted(in, "metallic") || channelIs(in, "roughness"));
}
bool normalTexture(const FeatureInput& in) {
  return sampled(in, TextureSlot::normal) && wanted(in, "normal") && !in.primitive.tangents.empty();
}
bool occlusionTexture(const FeatureInput& in) {
  return in.frame.occlusion && sampled(in, TextureSlot::occlusion) &&
         (in.frame.channel == 0 ? !unlit(in) && in.frame.environment : channelIs(in, "occlusion"));
}
bool emissiveTexture(const FeatureInput& in) { return sampled(in, TextureSlot::emissive) && wanted(in, "emissive"); }

// Materials of extensions: of the shaded picture of a metallic-roughness surface.
bool extended(const FeatureInput& in) {
  return in.frame.channel == 0 && !unlit(in) && !in.material.specularGlossiness && !measured(in);
}
template <bool (*has)(const scene::Material&)>
bool effect(const FeatureInput& in) {
  return extended(in) && has(in.material);
}
bool samplesEffectSlot(const FeatureInput& in, TextureSlot slot) {
  if (slot == TextureSlot::clearcoatNormal && in.primitive.tangents.empty()) return false;
  return extended(in) && sampled(in, slot);
}
template <TextureSlot slot>
bool effectTexture(const FeatureInput& in) {
  return samplesEffectSlot(in, slot);
}

bool anisotropic(const FeatureInput& in) { return effect<scene::hasAnisotropy>(in) && !in.primitive.tangents.empty(); }
bool readsTangent(const FeatureInput& in) {
  return normalTexture(in) || effectTexture<TextureSlot::clearcoatNormal>(in) || anisotropic(in) ||
         ((channelIs(in, "tangent") || measuredUtia(in)) && !in.primitive.tangents.empty());
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

bool skinned(const FeatureInput& in) { return in.deformation.skinned && !in.primitive.influences.empty(); }
bool morphed(const FeatureInput& in) { return in.deformation.morphed && !in.primitive.targets.empty(); }
bool flatPerPixel(const FeatureInput& in) {
  return readsNormal(in) && in.primitive.flatNormals && (skinned(in) || morphed(in));
}

// A pixel that is shaded once shows a mean over its normals. Flat faces too: a program less costs more than it saves.
bool spreadNormals(const FeatureInput& in) {
  return in.frame.shadedOnce && in.frame.channel == 0 && !unlit(in) && !measured(in) &&
         (in.frame.punctualLights || in.frame.environment);
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

// Where a texture is read through TEXCOORD_set.
template <int set>
bool texCoords(const FeatureInput& in) {
  return !in.primitive.texCoords[set].empty() && anySlot(in, [](const TextureRef& ref) { return ref.texCoord == set; });
}

constexpr FeatureRow rows[] = {
    {"normals", "HAS_NORMAL", readsNormal},
    {"tangents", "HAS_TANGENT", readsTangent},
    {"uv0", "HAS_TEXCOORD_0",
     [](const FeatureInput& in) {
       return texCoords<0>(in) || (channelIs(in, "uv") && !in.primitive.texCoords[0].empty());
     }},
    {"uv1", "HAS_TEXCOORD_1", texCoords<1>},
    {"uv2", "HAS_TEXCOORD_2", texCoords<2>},
    {"uv3", "HAS_TEXCOORD_3", texCoords<3>},
    {"uv4", "HAS_TEXCOORD_4", texCoords<4>},
    {"uv5", "HAS_TEXCOORD_5", texCoords<5>},
    {"uv6", "HAS_TEXCOORD_6", texCoords<6>},
    {"uv7", "HAS_TEXCOORD_7", texCoords<7>},
    {"vertex colours", "HAS_VERTEX_COLOR",
     [](const FeatureInput& in) { return !in.primitive.colors.empty() && readsBaseColor(in); }},
    {"skin", "HAS_SKIN", skinned},
    {"morph targets", "HAS_MORPH", morphed},
    {"morphed normals", "MORPH_NORMALS",
     [](const FeatureInput& in) {
       return readsNormal(in) && !flatPerPixel(in) && targetsChange(in, &scene::MorphTarget::normals);
     }},
    {"morphed tangents", "MORPH_TANGENTS",
     [](const FeatureInput& in) { return readsTangent(in) && targetsChange(in, &scene::MorphTarget::tangents); }},
    {"morphed colours", "MORPH_COLORS",
     [](const FeatureInput& in) {
       return !in.primitive.colors.empty() && readsBaseColor(in) && targetsChange(in, &scene::MorphTarget::colors);
     }},
    {"flat normals per pixel", "FLAT_NORMALS", flatPerPixel},
    {"base colour texture", "HAS_BASE_COLOR_TEXTURE", baseColorTexture},
    {"normals spread over the pixel", "SPREAD_NORMALS", spreadNormals},
    {"specular-glossiness", "SPECULAR_GLOSSINESS", specularGlossiness},
    {"metallic-roughness texture", "HAS_METALLIC_ROUGHNESS_TEXTURE", metallicRoughnessTexture},
    {"normal texture", "HAS_NORMAL_TEXTURE", normalTexture},
    {"occlusion texture", "HAS_OCCLUSION_TEXTURE", occlusionTexture},
    {"emissive texture", "HAS_EMISSIVE_TEXTURE", emissiveTexture},
    {"dielectric specular", "HAS_DIELECTRIC_SPECULAR", effect<scene::hasDielectricSpecular>},
    {"clearcoat", "HAS_CLEARCOAT", effect<scene::hasClearcoat>},
    {"sheen", "HAS_SHEEN", effect<scene::hasSheen>},
    {"anisotropy", "HAS_ANISOTROPY", anisotropic},
    {"iridescence", "HAS_IRIDESCENCE", effect<scene::hasIridescence>},
    {"transmission", "HAS_TRANSMISSION", effect<scene::hasTransmission>},
    {"volume", "HAS_VOLUME", effect<scene::hasVolume>},
    {"dispersion", "HAS_DISPERSION", effect<scene::hasDispersion>},
    {"diffuse transmission", "HAS_DIFFUSE_TRANSMISSION", effect<scene::hasDiffuseTransmission>},
    {"clearcoat texture", "HAS_CLEARCOAT_TEXTURE", effectTexture<TextureSlot::clearcoat>},
    {"clearcoat roughness texture", "HAS_CLEARCOAT_ROUGHNESS_TEXTURE", effectTexture<TextureSlot::clearcoatRoughness>},
    {"clearcoat normal texture", "HAS_CLEARCOAT_NORMAL_TEXTURE", effectTexture<TextureSlot::clearcoatNormal>},
    {"sheen colour texture", "HAS_SHEEN_COLOR_TEXTURE", effectTexture<TextureSlot::sheenColor>},
    {"sheen roughness texture", "HAS_SHEEN_ROUGHNESS_TEXTURE", effectTexture<TextureSlot::sheenRoughness>},
    {"anisotropy texture", "HAS_ANISOTROPY_TEXTURE", effectTexture<TextureSlot::anisotropy>},
    {"specular texture", "HAS_SPECULAR_TEXTURE", effectTexture<TextureSlot::specular>},
    {"specular colour texture", "HAS_SPECULAR_COLOR_TEXTURE", effectTexture<TextureSlot::specularColor>},
    {"iridescence texture", "HAS_IRIDESCENCE_TEXTURE", effectTexture<TextureSlot::iridescence>},
    {"iridescence thickness texture", "HAS_IRIDESCENCE_THICKNESS_TEXTURE",
     effectTexture<TextureSlot::iridescenceThickness>},
    {"transmission texture", "HAS_TRANSMISSION_TEXTURE", effectTexture<TextureSlot::transmission>},
    {"thickness texture", "HAS_THICKNESS_TEXTURE", effectTexture<TextureSlot::thickness>},
    {"diffuse transmission texture", "HAS_DIFFUSE_TRANSMISSION_TEXTURE",
     effectTexture<TextureSlot::diffuseTransmission>},
    {"diffuse transmission colour texture", "HAS_DIFFUSE_TRANSMISSION_COLOR_TEXTURE",
     effectTexture<TextureSlot::diffuseTransmissionColor>},
    {"texture transform", "HAS_TEXTURE_TRANSFORM",
     [](const FeatureInput& in) {
       return anySlot(in, [](const TextureRef& ref) { return ref.transform != scene::TextureTransform{}; });
     }},
    {"alpha mask", "ALPHA_MASK", [](const FeatureInput& in) { return in.material.alphaMode == AlphaMode::mask; }},
    {"alpha blend", "ALPHA_BLEND",
     [](const FeatureInput& in) { return in.material.alphaMode == AlphaMode::blend && in.frame.channel == 0; }},
    {"double-sided", "DOUBLE_SIDED", [](const FeatureInput& in) { return in.material.doubleSided && readsNormal(in); }},
    {"unlit", "UNLIT", [](const FeatureInput& in) { return unlit(in) || in.frame.channel != 0; }},
    {"punctual lights", "HAS_PUNCTUAL_LIGHTS",
     [](const FeatureInput& in) { return in.frame.punctualLights && !unlit(in) && in.frame.channel == 0; }},
    {"MERL BRDF", "MERL_BRDF",
     [](const FeatureInput& in) { return measured(in) && in.frame.measured == Measured::merl; }},
    {"UTIA BRDF", "UTIA_BRDF", measuredUtia},
    {"nearest measured value", "MEASURED_NEAREST",
     [](const FeatureInput& in) { return measured(in) && in.frame.measuredNearest && !in.frame.measuredFitted; }},
    {"model fitted to it", "FITTED_BRDF",
     [](const FeatureInput& in) { return measured(in) && in.frame.measuredFitted; }},
    {"environment", "HAS_ENVIRONMENT",
     [](const FeatureInput& in) { return in.frame.environment && !unlit(in) && in.frame.channel == 0; }},
};

constexpr uint64_t bit(size_t row) { return uint64_t{1} << row; }

static_assert(std::size(rows) <= 64);

}  // namespace

ChannelKind channelKind(int channel) {
  if (channel == 0 || channel == channelIndex("baseColor") || channel == channelIndex("emissive"))
    return ChannelKind::color;
  const bool direction = channel == channelIndex("normal") || channel == channelIndex("geometryNormal") ||
                         channel == channelIndex("tangent");
  return direction ? ChannelKind::direction : ChannelKind::number;
}

std::string channelSetting(int channel) { return channel == 0 ? "" : std::string(rowOf(channels, channel).word); }

int channelIndex(const std::string& setting) {
  for (int i = 0; i < channelCount; ++i)
    if (setting == channelSetting(i)) return i;
  return -1;
}

bool samplesSlot(const FeatureInput& input, TextureSlot slot) { return samplesSlotOf(input, slot); }

std::span<const FeatureRow> featureTable() { return rows; }

VariantKey variantKey(const FeatureInput& input) {
  VariantKey key;
  key.channel = static_cast<uint8_t>(input.frame.channel);
  for (size_t i = 0; i < std::size(rows); ++i)
    if (rows[i].usedBy(input)) key.features |= bit(i);
  if (usesFeature(key, "HAS_ENVIRONMENT")) key.imageLightSamples = static_cast<uint16_t>(input.frame.imageLightSamples);
  if (measured(input)) {
    if (usesFeature(key, "HAS_ENVIRONMENT") && key.imageLightSamples == 0)
      key.imageLightSamples = static_cast<uint16_t>(input.frame.measuredLightSamples);
    if (input.frame.measuredFitted) key.diffuse = static_cast<uint8_t>(input.frame.models.diffuse);
    return key;
  }
  setModels(input, key);
  return key;
}

std::vector<Define> variantDefines(const VariantKey& key) {
  std::vector<Define> defines;
  for (size_t i = 0; i < std::size(rows); ++i)
    if (key.features & bit(i)) defines.push_back({rows[i].define});
  std::string sets;  // of tex_coords.glsl
  for (int set = 0; set < scene::maxTexCoordSets; ++set)
    if (usesFeature(key, texCoordDefine(set).c_str())) sets += "DO(" + std::to_string(set) + ") ";
  if (!sets.empty()) defines.push_back({"EACH_TEXCOORD(DO)", sets});
  if (key.channel != 0) defines.push_back({"CHANNEL", std::to_string(key.channel)});
  if (key.imageLightSamples != 0) defines.push_back({"IMAGE_LIGHT_SAMPLES", std::to_string(key.imageLightSamples)});
  addModelDefines(key, defines);
  return defines;
}

std::string variantName(const VariantKey& key) {
  std::string name;
  for (size_t i = 0; i < std::size(rows); ++i)
    if (key.features & bit(i)) name += (name.empty() ? "" : ", ") + std::string(rows[i].name);
  if (key.channel != 0) name += std::string(name.empty() ? "" : ", ") + "view of " + channelSetting(key.channel);
  if (key.imageLightSamples != 0) name += ", environment sampled";
  addModelNames(key, name);
  return name.empty() ? "plain" : name;
}

uint64_t attributeBits(const VariantKey& key) {
  constexpr std::string_view attributes[] = {"HAS_NORMAL", "HAS_TANGENT", "HAS_TEXCOORD_", "HAS_VERTEX_COLOR",
                                             "HAS_SKIN",   "HAS_MORPH",   "MORPH_"};
  uint64_t bits = 0;
  for (size_t i = 0; i < std::size(rows); ++i) {
    const std::string_view define = rows[i].define;
    for (const std::string_view attribute : attributes)
      if (define.starts_with(attribute) && !define.ends_with("_TEXTURE")) bits |= key.features & bit(i);
  }
  return bits;
}

std::string texCoordDefine(int set) { return "HAS_TEXCOORD_" + std::to_string(set); }

bool usesFeature(const VariantKey& key, const char* define) {
  for (size_t i = 0; i < std::size(rows); ++i)
    if (std::strcmp(rows[i].define, define) == 0) return (key.features & bit(i)) != 0;
  assert(false && "no such feature");
  return false;
}

VariantKey fittedKey(const VariantKey& key, optics::DiffuseModel diffuse) {
  if (!isMeasured(key)) return key;
  VariantKey fitted = key;
  for (size_t i = 0; i < std::size(rows); ++i) {
    if (std::strcmp(rows[i].define, "FITTED_BRDF") == 0) fitted.features |= bit(i);
    if (std::strcmp(rows[i].define, "MEASURED_NEAREST") == 0) fitted.features &= ~bit(i);
  }
  fitted.diffuse = static_cast<uint8_t>(diffuse);
  return fitted;
}

bool isMeasured(const VariantKey& key) { return usesFeature(key, "MERL_BRDF") || usesFeature(key, "UTIA_BRDF"); }

}  // namespace facet::shading
