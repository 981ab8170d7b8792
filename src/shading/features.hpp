#pragma once

// The one table of what a drawn primitive may need from its shader. Variant keys, defines, statistics and inspect's
// output are derived from it. To add a feature: a row in features.inc, its chunk in shaders/, its twin in optics/, its
// tests.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/choice.hpp"
#include "optics/models.hpp"
#include "scene/model.hpp"
#include "scene/usage.hpp"
#include "shading/assembler.hpp"
#include "shading/channels.hpp"

namespace facet::shading {

// A measured BRDF in the place of all lit materials.
enum class Measured : uint8_t { none, merl, utia };

// What the frame offers besides the primitive and its material.
struct FrameFeatures {
  bool punctualLights = false;
  bool lightProfiles = false;  // some of them shine by one
  bool environment = false;
  bool occlusion = true;  // false: occlusion textures are switched off
  int channel = 0;
  bool paths = false;          // light comes by paths of rays: nothing else is looked up of the environment
  bool difference = false;     // the picture is drawn, and corrected by paths where something is in the light's way
  bool shadows = false;        // of lights, by maps; what they hide
  bool horizons = false;       // in the depth buffer, by what they hide of the environment
  bool shadedOnce = false;     // a pixel, for all of its coverage samples
  bool textureReads = false;   // where it is: slanted textures are read several times by the shader
  bool sampledBehind = false;  // glass draws what is behind by as many samples where no environment shines, too
  int imageLightSamples = 0;   // 0: split sum from the tables; else environment samples per shaded sample
  optics::Models models = {};
  Measured measured = Measured::none;
  bool measuredNearest = false;   // looks up the nearest cell instead of interpolating
  int measuredLightSamples = 64;  // of the environment where imageLightSamples is 0
  bool measuredFitted = false;    // the model that was fitted to it, over models.diffuse, in its place

  bool operator==(const FrameFeatures&) const = default;
};

// As paths shade what is drawn with those.
FrameFeatures pathFeatures(FrameFeatures drawn);

// What moves the vertices of a drawn instance besides its matrix.
struct Deformation {
  bool skinned = false, morphed = false;
};

struct FeatureInput {
  const scene::Material& material;
  const scene::Primitive& primitive;
  const FrameFeatures& frame;
  Deformation deformation = {};
};

enum class Feature : uint8_t {
#define FEATURE(name, ...) name,
#include "shading/features.inc"
#undef FEATURE
};

enum class FeatureRole : uint8_t {
  attribute,  // of the vertices, or another buffer of the primitive
  surface,
  layer,    // scene::Effect: changes how the surface reflects
  passage,  // scene::Effect: what passes through it
  texture,  // scene::TextureSlot
  light,
  measured,  // takes the place of all lit materials
};

struct FeatureRow {
  Feature feature;
  const char* name;    // for people
  const char* define;  // for the shader
  FeatureRole role;
  bool (*usedBy)(const FeatureInput&);
};

// Row i is that of Feature(i).
std::span<const FeatureRow> featureTable();

// One bit for each feature; there are more than 64.
using FeatureBits = unsigned __int128;
constexpr FeatureBits bitOf(Feature feature) { return FeatureBits{1} << static_cast<int>(feature); }

// True where the draw's shader reads the slot's texture.
bool samplesSlot(const FeatureInput& input, scene::TextureSlot slot);

// Everything that decides which program a draw gets; compared by value.
struct VariantKey {
  FeatureBits features = 0;  // bitOf
  uint8_t channel = 0;
  uint16_t imageLightSamples = 0;
  // Models other than the default that the draw can show: indices of optics::Models' enumerations.
  uint8_t diffuse = 0, fresnel = 0, distribution = 0, masking = 0;
  uint8_t energy = 0;      // index in optics::EnergyModel, 0 where the draw's light is none that it changes
  uint8_t imageLight = 0;  // index in optics::ImageLight, but of those that are as the default 0
  uint8_t conductor = 0;   // 1 + index in optics::metalPresets(), where `fresnel` reads it
  auto operator<=>(const VariantKey&) const = default;
};

VariantKey variantKey(const FeatureInput& input);
std::vector<Define> variantDefines(const VariantKey& key);
std::string variantName(const VariantKey& key);  // "normal, uv0, base colour texture, environment"

// The bits of the key that ask for a vertex attribute or another buffer of the primitive.
FeatureBits attributeBits(const VariantKey& key);

constexpr bool usesFeature(const VariantKey& key, Feature feature) { return (key.features & bitOf(feature)) != 0; }

// TEXCOORD_n, n < scene::maxTexCoordSets.
constexpr Feature texCoordFeature(int set) { return static_cast<Feature>(static_cast<int>(Feature::uv0) + set); }
static_assert(texCoordFeature(scene::maxTexCoordSets - 1) == Feature::uv7);

// True where the key's draws look the DFG table up.
bool readsDfgTable(const VariantKey& key);

// How many fitted look-ups of the environment each of its lobes takes; 0: none, or others.
int imageLightTaps(const VariantKey& key);

// True where the key's draws show a measured BRDF.
bool isMeasured(const VariantKey& key);
// What a draw's depths are drawn by: what moves its vertices, and a mask's alpha.
VariantKey depthKey(const VariantKey& key);
// The same draw of the model that was fitted to its measured BRDF; other keys stay as they are.
VariantKey fittedKey(const VariantKey& key, optics::DiffuseModel diffuse);

}  // namespace facet::shading
