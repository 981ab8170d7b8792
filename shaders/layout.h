// Slots, locations and buffer layouts, read by C++ and by GLSL alike.
#ifdef __cplusplus
#pragma once

#include <cstdint>
#include <glm/glm.hpp>

namespace facet::layout {
using glm::mat4;
using glm::uvec4;
using glm::vec4;
using uint = uint32_t;
#define LAYOUT_CONST inline constexpr int
#else
#define LAYOUT_CONST const int
#endif

// Vertex attributes.
LAYOUT_CONST positionLocation = 0;
LAYOUT_CONST normalLocation = 1;
LAYOUT_CONST tangentLocation = 2;
LAYOUT_CONST colorLocation = 3;
LAYOUT_CONST texCoordLocation = 4;  // of set 0; set n follows n places on
LAYOUT_CONST texCoordSetCount = 8;

// Uniform buffers.
LAYOUT_CONST frameBinding = 0;
LAYOUT_CONST materialBinding = 1;

// Shader storage buffers.
LAYOUT_CONST instanceBinding = 0;
LAYOUT_CONST lightBinding = 1;
LAYOUT_CONST computeInputBinding = 2;
LAYOUT_CONST computeOutputBinding = 3;
LAYOUT_CONST visibleBinding = 4;       // indices of instances
LAYOUT_CONST influenceBinding = 5;     // of one primitive
LAYOUT_CONST jointBinding = 6;         // of all skins
LAYOUT_CONST morphTargetBinding = 7;   // of one primitive
LAYOUT_CONST morphWeightBinding = 8;   // of all instances
LAYOUT_CONST measuredBinding = 9;      // a measured BRDF; only where a draw reads it

// Texture units. First the material's slots in the order of scene::TextureSlot. A driver may offer as few as 16 units to
// a stage: what counts is how many a variant uses, not their numbers.
LAYOUT_CONST baseColorUnit = 0;
LAYOUT_CONST metallicRoughnessUnit = 1;
LAYOUT_CONST normalUnit = 2;
LAYOUT_CONST occlusionUnit = 3;
LAYOUT_CONST emissiveUnit = 4;
LAYOUT_CONST clearcoatUnit = 5;
LAYOUT_CONST clearcoatRoughnessUnit = 6;
LAYOUT_CONST clearcoatNormalUnit = 7;
LAYOUT_CONST sheenColorUnit = 8;
LAYOUT_CONST sheenRoughnessUnit = 9;
LAYOUT_CONST anisotropyUnit = 10;
LAYOUT_CONST specularUnit = 11;
LAYOUT_CONST specularColorUnit = 12;
LAYOUT_CONST iridescenceUnit = 13;
LAYOUT_CONST iridescenceThicknessUnit = 14;
LAYOUT_CONST transmissionUnit = 15;
LAYOUT_CONST thicknessUnit = 16;
LAYOUT_CONST diffuseTransmissionUnit = 17;
LAYOUT_CONST diffuseTransmissionColorUnit = 18;
LAYOUT_CONST materialSlotCount = 19;
LAYOUT_CONST dfgUnit = 19;
LAYOUT_CONST irradianceUnit = 20;
LAYOUT_CONST mirrorLayersUnit = 21;  // LD layers 0 and 1
LAYOUT_CONST roughLayersUnit = 22;   // LD layers 2 and up
LAYOUT_CONST equirectUnit = 23;
LAYOUT_CONST sourceUnit = 24;  // input of a full-screen or compute pass
LAYOUT_CONST environmentCubeUnit = 25;
LAYOUT_CONST sheenAlbedoUnit = 26;
LAYOUT_CONST opaqueFrameUnit = 27;  // what is behind transmitting surfaces, with mips
LAYOUT_CONST opaqueDepthUnit = 28;  // its depth, with mips
LAYOUT_CONST tapsUnit = 29;         // image_light_taps.glsl
LAYOUT_CONST comparedUnit = 30;     // the fitted model's picture

// The LD chain: layer i holds perceptual roughness ldKnot(i) (environment_layers.glsl); how many cubes of which size.
LAYOUT_CONST ldLayerCount = 13;
LAYOUT_CONST ldMirrorLayerCount = 2;

// The table of fitted look-ups, texels along an edge of each tap's block; three models of 1, 2, 3 taps.
LAYOUT_CONST tapsTableSize = 16;
LAYOUT_CONST tapsBlockCount = 6;

struct FrameUniforms {
  mat4 clipFromWorld;         // world = metres from the scene's origin (the centre of its bounds)
  mat4 worldFromClip;         // directions of the far plane's points; for the sky
  vec4 eye;                   // xyz metres from the scene's origin; w 1 perspective, 0 orthographic
  vec4 towardsEye;            // orthographic: unit direction to the viewer
  vec4 environmentRotation;   // x cos, y sin of the rotation about +Y
  vec4 environmentScale;      // x: radiance of a stored 1; y: of the background; z: strength
  vec4 options;               // x: factor on occlusion strength; y: index of the draw among those gathered, z: their number
  vec4 picture;               // x, y size of the whole in pixels; z first row of the target; w pixels per metre, 1 m away
  vec4 distanceFromDepth;     // a, b, c, d: distance along the view's axis = (b - d depth) / (a - c depth)
  vec4 backdrop;              // rgb radiance of a colour put behind the picture later; w 0: there is none
};

struct MaterialUniforms {
  vec4 baseColorFactor;
  vec4 emissiveFactor;  // rgb factor * strength, W sr^-1 m^-2 relative; w unused
  vec4 factors;         // metallic, perceptual roughness, occlusion strength, alpha cutoff
  vec4 scales;          // x normal scale; yzw unused
  vec4 specularGlossiness;  // rgb f0, a glossiness; of materials of that model
  vec4 specular;            // rgb colour, a weight (KHR_materials_specular)
  vec4 clearcoat;           // x factor, y perceptual roughness, z normal scale; w: the dielectric's ior (0: infinite)
  vec4 sheen;               // rgb colour, a perceptual roughness
  vec4 anisotropy;          // x strength; y cos, z sin of the rotation; w dispersion
  vec4 iridescence;         // x factor, y ior; z, w thickness at texel 0 and 1 in nanometres
  vec4 attenuation;         // rgb colour; w 1 / distance, 0: none
  vec4 transmission;        // x factor, y thickness, z diffuse transmission; w unused
  vec4 diffuseTransmission;  // rgb colour; w unused
  vec4 texCoordSets[5];   // the set of slot s: [s / 4][s % 4]
  vec4 texCoordRows[38];  // slot s: rows 2s, 2s + 1 of its KHR_texture_transform (xyz)
};

struct Instance {
  mat4 worldFromLocal;
  vec4 normalFromLocal[3];  // columns of the cofactor matrix, signed so that mirrored nodes keep their outside
  uvec4 deformation;        // x first joint of the skin; y first morph weight, z their number; w unused
};

// World from mesh, for one joint of a skin.
struct Joint {
  vec4 rows[3];
};

struct MorphWeight {
  uint target;
  float weight;
};

struct LightUniforms {
  vec4 position;   // xyz metres from the scene's origin; w: type, 0 directional, 1 point, 2 spot, 3 the environment's sun
  vec4 direction;  // xyz unit, the way it shines; w: 1 / range^2 (0: no range)
  vec4 color;      // rgb linear * intensity (candela or lux)
  vec4 cone;       // x scale, y offset of the spot's cosine ramp; sun: x angular radius, y least radius of a draw's share (its direction is the map's)
};

// At the start of a measured BRDF's buffer; its cells follow.
struct MeasuredUniforms {
  vec4 lobe;   // of measured_sampling.glsl
  vec4 table;  // x share of the samples that the cosine gets; y scale of RGB9_E5 cells; z MERL: steps of phi_d; w unused
};

// In the place of the cells where the model that was fitted to them is drawn; MeasuredUniforms' lobe is its own then.
struct FittedUniforms {
  vec4 f0;      // rgb; w perceptual roughness, of the diffuse model
  vec4 albedo;  // rgb; w unused
};

#ifdef __cplusplus
#undef LAYOUT_CONST
static_assert(sizeof(MaterialUniforms) == 56 * 16);
static_assert(sizeof(FrameUniforms) == 16 * 16);
static_assert(sizeof(Instance) == 8 * 16);
static_assert(sizeof(Joint) == 3 * 16);
static_assert(sizeof(MorphWeight) == 8);
static_assert(sizeof(LightUniforms) == 4 * 16);
static_assert(sizeof(MeasuredUniforms) == 2 * 16);
static_assert(sizeof(FittedUniforms) == 2 * 16);
}  // namespace facet::layout
#endif
