// Slots, locations and buffer layouts, read by C++ and by GLSL alike.
#pragma once
#include "both_languages.h"

LAYOUT_BEGIN

// Vertex attributes.
LAYOUT_CONST positionLocation = 0;
LAYOUT_CONST normalLocation = 1;
LAYOUT_CONST tangentLocation = 2;
LAYOUT_CONST colorLocation = 3;
LAYOUT_CONST texCoordLocation = 4;  // of set 0; set n follows n places on
LAYOUT_CONST texCoordSetCount = 8;
LAYOUT_CONST coatTangentLocation = 12;   // where the coat's normal texture and anisotropy
LAYOUT_CONST grainTangentLocation = 13;  // have texture coordinates of their own

// Uniform buffers.
LAYOUT_CONST frameBinding = 0;
LAYOUT_CONST materialBinding = 1;
LAYOUT_CONST pathsBinding = 2;
LAYOUT_CONST shadowsBinding = 3;

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
LAYOUT_CONST pathGroupsBinding = 8;    // of passes that draw nothing
LAYOUT_CONST rayHolesBinding = 10;     // likewise
LAYOUT_CONST measuredBinding = 9;      // a measured BRDF; only where a draw reads it
LAYOUT_CONST profileBinding = 11;      // of lights; only where one has a profile

// Texture units. First the material's slots (texture_slots.inc). A driver may offer as few as 16 units to a stage: what
// counts is how many a variant uses, not their numbers.
#define TEXTURE_SLOT(name, DEFINE, words, texel) +1
LAYOUT_CONST materialSlotCount = 0
#include "texture_slots.inc"
;
#undef TEXTURE_SLOT
LAYOUT_CONST dfgUnit = materialSlotCount;
LAYOUT_CONST irradianceUnit = materialSlotCount + 1;
LAYOUT_CONST mirrorLayersUnit = materialSlotCount + 2;  // LD layers 0 and 1
LAYOUT_CONST roughLayersUnit = materialSlotCount + 3;   // LD layers 2 and up
LAYOUT_CONST equirectUnit = materialSlotCount + 4;
LAYOUT_CONST sourceUnit = materialSlotCount + 5;  // input of a full-screen or compute pass
LAYOUT_CONST environmentRestUnit = materialSlotCount + 6;  // environment_samples.glsl
LAYOUT_CONST sheenAlbedoUnit = materialSlotCount + 7;
LAYOUT_CONST opaqueFrameUnit = materialSlotCount + 8;  // what is behind transmitting surfaces, with mips
LAYOUT_CONST opaqueDepthUnit = materialSlotCount + 9;  // its depth, with mips
LAYOUT_CONST tapsUnit = materialSlotCount + 10;        // image_light_taps.glsl
LAYOUT_CONST comparedUnit = materialSlotCount + 11;    // the fitted model's picture
LAYOUT_CONST rayNodesUnit = materialSlotCount + 12;    // rays.h
LAYOUT_CONST rayTrianglesUnit = materialSlotCount + 13;
LAYOUT_CONST rayPlacementsUnit = materialSlotCount + 14;
LAYOUT_CONST environmentTexelsUnit = materialSlotCount + 15;
LAYOUT_CONST rayAlphaUnit = materialSlotCount + 16;
LAYOUT_CONST lampCubeUnit = materialSlotCount + 17;    // environment_samples.glsl
LAYOUT_CONST lampPointsUnit = materialSlotCount + 18;
LAYOUT_CONST groundUnit = materialSlotCount + 19;
LAYOUT_CONST glowingUnit = materialSlotCount + 20;
LAYOUT_CONST horizonsUnit = materialSlotCount + 21;   // horizon_occlusion.glsl
LAYOUT_CONST shadowMapsUnit = materialSlotCount + 22;  // light_shadows.glsl
LAYOUT_CONST blurredBackgroundUnit = materialSlotCount + 23;

// Compute passes: invocations of a work group along x and y; pixels along the edge of the square that one group sums up.
LAYOUT_CONST groupSize = 8;
LAYOUT_CONST groupInvocations = groupSize * groupSize;
LAYOUT_CONST sumTileSize = 64;

// Of the environment for sums over the sphere: vec4s of each cell (passes/cube_to_cells.comp.glsl).
LAYOUT_CONST cellVectors = 3;

// Locations of the passes' uniforms.
LAYOUT_CONST displayParametersLocation = 0;  // displayed()'s, of all passes that call it
LAYOUT_CONST displayBackdropLocation = 1;
LAYOUT_CONST comparisonLocation = 2;
LAYOUT_CONST comparedRowsLocation = 2;
LAYOUT_CONST errorPartsLocation = 2;
LAYOUT_CONST errorStopsLocation = 3;  // and what follows
LAYOUT_CONST errorStopCount = 5;
LAYOUT_CONST gatherShareLocation = 0;
LAYOUT_CONST outlineLineLocation = 0;
LAYOUT_CONST behindFineLevelLocation = 0;
LAYOUT_CONST overlayDepthLocation = 0;
LAYOUT_CONST cubeTapsLocation = 0;
LAYOUT_CONST cubeSteepTapsLocation = 1;
LAYOUT_CONST cubeSteepLocation = 2;
LAYOUT_CONST cubeFirstFaceLocation = 3;
LAYOUT_CONST tentFineLevelLocation = 0;
LAYOUT_CONST blurFirstFaceLocation = 0;
LAYOUT_CONST layerCubeLocation = 0;  // of passes that write a layer of LD
LAYOUT_CONST layerFirstFaceLocation = 1;
LAYOUT_CONST mixCountLocation = 2;
LAYOUT_CONST mixWeightsLocation = 3;  // one each
LAYOUT_CONST mixCopyCount = 16;
LAYOUT_CONST cutFirstRowLocation = 2;
LAYOUT_CONST cutTreeSizeLocation = 3;
LAYOUT_CONST cutParametersLocation = 4;
LAYOUT_CONST nodesSizeLocation = 0;
LAYOUT_CONST nodesOffsetLocation = 1;
LAYOUT_CONST nodesFineOffsetLocation = 2;
LAYOUT_CONST cellTexelsLocation = 0;
LAYOUT_CONST sumAlpha2Location = 0;
LAYOUT_CONST riemannStepLocation = 0;
LAYOUT_CONST dfgRadiiLocation = 0;
LAYOUT_CONST dfgSamplesLocation = 0;
LAYOUT_CONST sheenHeightsLocation = 0;
LAYOUT_CONST probeCountLocation = 0;
LAYOUT_CONST pathsClassLocation = 0;
LAYOUT_CONST differenceStepLocation = 0;
// Layers of what paths find beside a drawn picture: pairs by broad and by sharp lobes, then what smoothing goes by.
LAYOUT_CONST visibleLayer = 0;     // of the unblocked light, what nothing blocks
LAYOUT_CONST unblockedLayer = 2;   // from lights and environment at the first surface, as if nothing were in its way
LAYOUT_CONST returnedLayer = 4;    // that other surfaces send
LAYOUT_CONST smoothedLayers = 6;
LAYOUT_CONST tableLayer = 6;       // what is drawn for unblocked light
LAYOUT_CONST firstAlbedoLayer = 8;
LAYOUT_CONST firstNormalLayer = 10;  // a alpha of the sharpest lobe
LAYOUT_CONST differenceLayers = 11;
LAYOUT_CONST holesFirstLocation = 0;
LAYOUT_CONST groundNoiseLocation = 0;
LAYOUT_CONST horizonReachLocation = 0;
// Layers of what paths find at the floor [irradiance over pi], and of what is drawn of it (ground.glsl).
LAYOUT_CONST groundVisibleSum = 0;    // what nothing blocks
LAYOUT_CONST groundUnblockedSum = 1;  // as if nothing were in its way
LAYOUT_CONST groundReturnedSum = 2;   // what other surfaces send
LAYOUT_CONST groundSumLayers = 3;
LAYOUT_CONST groundShareLayer = 0;
LAYOUT_CONST groundCoverLayer = 1;
LAYOUT_CONST groundLayers = 2;

// The LD chain: layer i holds perceptual roughness ldKnot(i) (environment_layers.glsl); how many cubes of which size.
LAYOUT_CONST ldLayerCount = 13;
LAYOUT_CONST ldMirrorLayerCount = 2;
LAYOUT_CONST sheenLayer = 6;  // that every sheen lobe reads (image_light_sheen.glsl)

// The table of fitted look-ups, texels along an edge of each tap's block; three models of 1, 2, 3 taps.
LAYOUT_CONST tapsTableSize = 16;
LAYOUT_CONST tapsBlockCount = 6;

// Shadow maps of all lights: six for a point.
LAYOUT_CONST mostShadowMaps = 24;

struct FrameUniforms {
  mat4 clipFromWorld;         // world = metres from the scene's origin (the centre of its bounds)
  mat4 worldFromClip;         // directions of the far plane's points; for the sky
  vec4 eye;                   // xyz metres from the scene's origin; w 1 perspective, 0 orthographic
  vec4 towardsEye;            // orthographic: unit direction to the viewer
  vec4 environmentRotation;   // x cos, y sin of the rotation about +Y
  vec4 environmentScale;      // x: radiance of a stored 1; z: strength
  vec4 options;               // x: factor on occlusion strength; y: index of the draw among those of its seed, z: number of all that are gathered; w seed
  vec4 picture;               // x, y size of the whole in pixels; z first row of the target; w pixels per metre, 1 m away
  vec4 distanceFromDepth;     // a, b, c, d: distance along the view's axis = (b - d depth) / (a - c depth)
  vec4 stored;                // x what the targets hold of radiance 1, a power of two; y radiance of a stored 1; z the largest that they hold; w factor on the quantities of a channel; 0: channels as numbers
  vec4 backdrop;              // rgb radiance of a colour put behind the picture later; w 0: there is none
  vec4 ground;                // the floor: xyz its middle, w half its width
  vec4 blurredSun;            // of a blurred background: xyz direction in the environment's space; w alpha^2 of its lobe
  vec4 blurredSunRadiance;    // rgb in the lobe's middle; w what of the background is seen in the map itself
  vec4 screen;                // x, y texels of the horizons a pixel; z metres of a distance of 1 in them: the scene's radius
};

// How a slot's texture is looked up: KHR_texture_transform's rows, each to be multiplied with (u, v, 1).
struct SlotUniforms {
  vec3 u;
  float texCoord;  // the set
  vec3 v;
  float mostStretch;  // of a pixel's footprint, longer over shorter axis, that is followed (slanted_texture.glsl)
};

// One material; a uniform block, or an element of an array in a storage buffer.
struct MaterialUniforms {
#define COPIED(type, name) type name;
#define MADE(type, name) type name;
#define UNUSED(name) float name;
#include "material_members.inc"
#undef COPIED
#undef MADE
#undef UNUSED
#define TEXTURE_SLOT(name, DEFINE, words, texel) SlotUniforms name##Slot;
#include "texture_slots.inc"
#undef TEXTURE_SLOT
};

struct Instance {
  mat4 worldFromLocal;
  vec4 normalFromLocal[3];  // columns of the cofactor matrix, signed so that mirrored nodes keep their outside
  uvec4 deformation;        // x first joint of the skin; y first morph weight, z their number; w the node
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
                   // z 1 + its first shadow map, negative: six of them, 0: none; w width of their texels [m], 1 m away unless light is parallel
  vec4 profile;    // of a point: xyz unit, the side that its horizontal angles begin at, perpendicular to direction; w 1 + its first
                   // number in the profiles, negative: of a mirrored node, 0: it has none
};

struct ShadowUniforms {
  mat4 clipFromWorld[mostShadowMaps];  // world as in FrameUniforms
};

// At the start of a measured BRDF's buffer; its cells follow.
struct MeasuredUniforms {
  vec4 lobe;   // of measured_sampling.glsl
  vec4 table;  // x share of the samples that the cosine gets; y scale of RGB9_E5 cells; z MERL: steps of phi_d; w unused
};

// In the place of the cells where the model that was fitted to them is drawn; MeasuredUniforms' lobe is its own then.
struct FittedUniforms {
  vec4 f0;      // rgb; w perceptual roughness, of the diffuse model
  vec4 f90;     // rgb; w unused
  vec4 albedo;  // rgb; w unused
};

#ifdef __cplusplus
// Work groups, or tiles, along an axis.
constexpr int groupsFor(int size, int perGroup = groupSize) { return (size + perGroup - 1) / perGroup; }

// What begins where the members before it end lies alike in std140, std430 and C++, if it is aligned as std140 wants.
#define MEMBER(type, name) static_assert(offsetof(MaterialUniforms, name) % (sizeof(type) > 8 ? 16 : sizeof(type)) == 0);
#define COPIED MEMBER
#define MADE MEMBER
#define UNUSED(name) MEMBER(float, name)
#include "material_members.inc"
#undef COPIED
#undef MADE
#undef UNUSED
#define TEXTURE_SLOT(name, ...) MEMBER(SlotUniforms, name##Slot)
#include "texture_slots.inc"
#undef TEXTURE_SLOT
#undef MEMBER
static_assert(sizeof(SlotUniforms) == 2 * 16);
static_assert(sizeof(MaterialUniforms) == offsetof(MaterialUniforms, baseColorSlot) + materialSlotCount * sizeof(SlotUniforms));
static_assert(sizeof(FrameUniforms) == 21 * 16);
static_assert(sizeof(Instance) == 8 * 16);
static_assert(sizeof(Joint) == 3 * 16);
static_assert(sizeof(MorphWeight) == 8);
static_assert(sizeof(LightUniforms) == 5 * 16);
static_assert(sizeof(ShadowUniforms) == mostShadowMaps * 4 * 16);
static_assert(sizeof(MeasuredUniforms) == 2 * 16);
static_assert(sizeof(FittedUniforms) == 3 * 16);
#endif
LAYOUT_END
