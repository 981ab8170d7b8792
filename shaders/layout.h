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

// Texture units. The first five are the material's slots in the order of scene::TextureSlot.
LAYOUT_CONST baseColorUnit = 0;
LAYOUT_CONST metallicRoughnessUnit = 1;
LAYOUT_CONST normalUnit = 2;
LAYOUT_CONST occlusionUnit = 3;
LAYOUT_CONST emissiveUnit = 4;
LAYOUT_CONST materialSlotCount = 5;
LAYOUT_CONST dfgUnit = 8;
LAYOUT_CONST irradianceUnit = 9;
LAYOUT_CONST mirrorLayersUnit = 10;  // LD layers 0 and 1
LAYOUT_CONST roughLayersUnit = 11;   // LD layers 2 and up
LAYOUT_CONST equirectUnit = 12;
LAYOUT_CONST environmentCubeUnit = 14;
LAYOUT_CONST sourceUnit = 13;  // input of a full-screen or compute pass

// The LD chain: layer i holds perceptual roughness ldKnot(i) (environment_layers.glsl); how many cubes of which size.
LAYOUT_CONST ldLayerCount = 13;
LAYOUT_CONST ldMirrorLayerCount = 2;

struct FrameUniforms {
  mat4 clipFromWorld;         // world = metres from the scene's origin (the centre of its bounds)
  mat4 worldFromClip;         // directions of the far plane's points; for the sky
  vec4 eye;                   // xyz metres from the scene's origin; w 1 perspective, 0 orthographic
  vec4 towardsEye;            // orthographic: unit direction to the viewer
  vec4 environmentRotation;   // x cos, y sin of the rotation about +Y
  vec4 environmentScale;      // x: radiance of a stored 1; y: of the background
  vec4 options;               // x: factor on occlusion strength; y: index of the draw among those gathered, z: their number
};

struct MaterialUniforms {
  vec4 baseColorFactor;
  vec4 emissiveFactor;  // rgb factor * strength, W sr^-1 m^-2 relative; w unused
  vec4 factors;         // metallic, perceptual roughness, occlusion strength, alpha cutoff
  vec4 scales;          // x normal scale; yzw unused
  vec4 specularGlossiness;  // rgb f0, a glossiness; of materials of that model
  vec4 texCoordSets[2];  // the set of slot 0..3, slot 4
  vec4 texCoordRows[10];  // slot s: rows 2s, 2s + 1 of its KHR_texture_transform (xyz)
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
  vec4 position;   // xyz metres from the scene's origin; w: type, 0 directional, 1 point, 2 spot
  vec4 direction;  // xyz unit, the way it shines; w: 1 / range^2 (0: no range)
  vec4 color;      // rgb linear * intensity (candela or lux)
  vec4 cone;       // x scale, y offset of the spot's cosine ramp
};

#ifdef __cplusplus
#undef LAYOUT_CONST
static_assert(sizeof(MaterialUniforms) == 17 * 16);
static_assert(sizeof(FrameUniforms) == 13 * 16);
static_assert(sizeof(Instance) == 8 * 16);
static_assert(sizeof(Joint) == 3 * 16);
static_assert(sizeof(MorphWeight) == 8);
static_assert(sizeof(LightUniforms) == 4 * 16);
}  // namespace facet::layout
#endif
