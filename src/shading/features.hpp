#pragma once

// The one table of what a drawn primitive may need from its shader. Variant keys, defines, statistics and inspect's
// output are derived from it. To add a feature: a row here, its chunk in shaders/, its twin in optics/, its tests.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/choice.hpp"
#include "optics/models.hpp"
#include "scene/model.hpp"
#include "scene/usage.hpp"
#include "shading/assembler.hpp"

namespace facet::shading {

// Debug views in place of the shaded picture. The row's index is CHANNEL in shaders/channels.glsl; its word is the
// setting, but for the first row, whose setting is empty.
inline constexpr Choice<int> channels[] = {{0, "final", "final picture"},
                                           {1, "normal", "normal"},
                                           {2, "geometryNormal", "vertex normal"},
                                           {3, "tangent", "tangent"},
                                           {4, "uv", "uv"},
                                           {5, "baseColor", "base colour"},
                                           {6, "metallic", "metallic"},
                                           {7, "roughness", "roughness"},
                                           {8, "occlusion", "occlusion"},
                                           {9, "emissive", "emissive"},
                                           {10, "alpha", "alpha"}};
static_assert(inOrder(channels));
inline constexpr int channelCount = static_cast<int>(std::size(channels));
// What a channel's numbers are: colours are shown through the sRGB curve, directions by [-1, 1] as [0, 1], everything
// else as it is.
enum class ChannelKind { color, direction, number };
ChannelKind channelKind(int channel);
// The setting: empty for the final picture.
std::string channelSetting(int channel);
// -1 where there is none of that name.
int channelIndex(const std::string& setting);

// A measured BRDF in the place of all lit materials.
enum class Measured : uint8_t { none, merl, utia };

// What the frame offers besides the primitive and its material.
struct FrameFeatures {
  bool punctualLights = false;
  bool environment = false;
  bool occlusion = true;  // false: occlusion textures are switched off
  int channel = 0;
  bool shadedOnce = false;    // a pixel, for all of its coverage samples
  int imageLightSamples = 0;  // 0: split sum from the tables; else environment samples per shaded sample
  optics::Models models = {};
  Measured measured = Measured::none;
  bool measuredNearest = false;   // looks up the nearest cell instead of interpolating
  int measuredLightSamples = 64;  // of the environment where imageLightSamples is 0
  bool measuredFitted = false;    // the model that was fitted to it, over models.diffuse, in its place

  bool operator==(const FrameFeatures&) const = default;
};

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

struct FeatureRow {
  const char* name;    // for people
  const char* define;  // for the shader
  bool (*usedBy)(const FeatureInput&);
};

// Bit i of a key is row i.
std::span<const FeatureRow> featureTable();

// True where the draw's shader reads the slot's texture.
bool samplesSlot(const FeatureInput& input, scene::TextureSlot slot);

// Everything that decides which program a draw gets; compared by value.
struct VariantKey {
  uint64_t features = 0;
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
uint64_t attributeBits(const VariantKey& key);

std::string texCoordDefine(int set);  // "HAS_TEXCOORD_3"

// True where the key's draws read punctual lights, the environment, the DFG table.
bool usesFeature(const VariantKey& key, const char* define);

// How many fitted look-ups of the environment each of its lobes takes; 0: none, or others.
int imageLightTaps(const VariantKey& key);

// True where the key's draws show a measured BRDF.
bool isMeasured(const VariantKey& key);
// The same draw of the model that was fitted to its measured BRDF; other keys stay as they are.
VariantKey fittedKey(const VariantKey& key, optics::DiffuseModel diffuse);

}  // namespace facet::shading
