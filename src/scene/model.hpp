#pragma once

// A loaded glTF asset as plain structs: what every later step reads. No OpenGL, no tinygltf.

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "optics/light_profile.hpp"

namespace facet::scene {

// Axis-aligned box, metres. Empty while min > max.
struct Bounds {
  glm::dvec3 min = glm::dvec3(std::numeric_limits<double>::infinity());
  glm::dvec3 max = glm::dvec3(-std::numeric_limits<double>::infinity());

  bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  glm::dvec3 center() const { return min * 0.5 + max * 0.5; }
  double radius() const { return empty() ? 0.0 : glm::length(max * 0.5 - min * 0.5); }
  void add(const glm::dvec3& p) { min = glm::min(min, p), max = glm::max(max, p); }
};

// ---- Textures -------------------------------------------------------------------------------------------------------

enum class Wrap : uint8_t { repeat, mirroredRepeat, clampToEdge };
enum class Filter : uint8_t { nearest, linear };
enum class MipFilter : uint8_t { none, nearest, linear };

struct Sampler {
  Wrap wrapS = Wrap::repeat, wrapT = Wrap::repeat;
  Filter magFilter = Filter::linear, minFilter = Filter::linear;
  MipFilter mipFilter = MipFilter::linear;
  bool operator==(const Sampler&) const = default;
};

// An image as the file holds it; decoding waits until it is known who needs it (io/image.hpp).
struct Image {
  std::string name;              // for messages: name or file name, else "images/3"
  std::filesystem::path file;    // an external file below the model's folder, or
  std::vector<uint8_t> encoded;  // the encoded bytes (buffer view or data URI), or
  std::string problem;           // neither: why there is none
  bool outside = false;          // because its folder is not allowed
  int fallback = -1;             // index in Model::images: what is shown where this one cannot be; -1: nothing
};

struct Texture {
  std::string name;
  int image = -1;  // index in Model::images; -1: none that can be shown (a placeholder takes its place)
  Sampler sampler;
};

// KHR_texture_transform: uv' = T R S uv.
struct TextureTransform {
  glm::vec2 offset = glm::vec2(0);
  float rotation = 0;  // radians, counter-clockwise in uv
  glm::vec2 scale = glm::vec2(1);
  bool operator==(const TextureTransform&) const = default;
};

struct TextureRef {
  int texture = -1;  // index in Model::textures; -1: the material has no such texture
  int texCoord = 0;  // TEXCOORD_n
  TextureTransform transform;

  explicit operator bool() const { return texture >= 0; }
};

// The textures that a material can name.
enum class TextureSlot : uint8_t {
#define TEXTURE_SLOT(name, ...) name,
#include "texture_slots.inc"
#undef TEXTURE_SLOT
};
#define TEXTURE_SLOT(...) +1
inline constexpr int textureSlotCount = 0
#include "texture_slots.inc"
    ;
#undef TEXTURE_SLOT

// ---- Materials ------------------------------------------------------------------------------------------------------

enum class AlphaMode : uint8_t { opaque, mask, blend };

// Distributions of microfacets; `any`: the picture's choice.
enum class Microfacets : uint8_t { any, ggx, beckmann, blinn };

struct Material {
  std::string name;

  glm::vec4 baseColorFactor = glm::vec4(1);  // linear Rec. 709 and coverage, [0, 1]
  float metallicFactor = 1;                  // [0, 1]
  float perceptualRoughnessFactor = 1;       // [0, 1]; alpha = its square
  glm::vec3 emissiveFactor = glm::vec3(0);   // linear, [0, 1]
  float emissiveStrength = 1;                // KHR_materials_emissive_strength, [0, inf)
  float normalScale = 1;                     // scales x and y of the tangent-space normal
  float occlusionStrength = 1;               // [0, 1]
  AlphaMode alphaMode = AlphaMode::opaque;
  float alphaCutoff = 0.5f;  // mask only
  bool doubleSided = false;
  bool unlit = false;  // KHR_materials_unlit: base colour only

  // KHR_materials_pbrSpecularGlossiness, a dielectric of any f0 over a diffuse base: base colour is its diffuse colour,
  // metallicRoughness its specular-glossiness texture (sRGB rgb f0, linear a glossiness); metallic and roughness are
  // not looked at.
  bool specularGlossiness = false;
  glm::vec3 specularFactor = glm::vec3(1);  // f0, linear, [0, 1]
  float glossinessFactor = 1;               // 1 - perceptual roughness, [0, 1]

  TextureRef baseColor;          // sRGB rgb, linear a
  TextureRef metallicRoughness;  // linear; g perceptual roughness, b metallic
  TextureRef normal;             // linear; rgb -> [-1, 1]
  TextureRef occlusion;          // linear; r
  TextureRef emissive;           // sRGB

  // KHR_materials_ior, _specular: the dielectric's interface
  float ior = 1.5f;                              // 0: infinite, reflects all; else >= 1
  float specularWeight = 1;                      // the extension's specularFactor, [0, 1]
  glm::vec3 specularColorFactor = glm::vec3(1);  // linear, >= 0
  TextureRef specular;                           // linear; a
  TextureRef specularColor;                      // sRGB

  // KHR_materials_clearcoat; factor 0: there is none
  float clearcoatFactor = 0, clearcoatRoughnessFactor = 0;  // [0, 1]
  float clearcoatNormalScale = 1;
  TextureRef clearcoat;           // linear; r
  TextureRef clearcoatRoughness;  // linear; g
  TextureRef clearcoatNormal;     // as `normal`

  // KHR_materials_sheen; colour 0: there is none
  glm::vec3 sheenColorFactor = glm::vec3(0);  // linear, [0, 1]
  float sheenRoughnessFactor = 0;             // perceptual, [0, 1]
  TextureRef sheenColor;                      // sRGB
  TextureRef sheenRoughness;                  // linear; a

  // KHR_materials_anisotropy; strength 0: there is none
  float anisotropyStrength = 0;  // [0, 1]
  float anisotropyRotation = 0;  // radians, counter-clockwise from the tangent
  TextureRef anisotropy;         // linear; rg direction -> [-1, 1], b strength

  // KHR_materials_iridescence; factor 0: there is none
  float iridescenceFactor = 0;                                                 // [0, 1]
  float iridescenceIor = 1.3f;                                                 // >= 1
  float iridescenceThicknessMinimum = 100, iridescenceThicknessMaximum = 400;  // nanometres, >= 0
  TextureRef iridescence;                                                      // linear; r
  TextureRef iridescenceThickness;                                             // linear; g

  // KHR_materials_transmission, _volume, _dispersion; factor 0: nothing shines through
  float transmissionFactor = 0;                                        // [0, 1]
  TextureRef transmission;                                             // linear; r
  float thicknessFactor = 0;                                           // metres in the mesh's space; 0: thin walls
  TextureRef thickness;                                                // linear; g
  float attenuationDistance = std::numeric_limits<float>::infinity();  // metres in the world, > 0
  glm::vec3 attenuationColor = glm::vec3(1);                           // linear, [0, 1]
  float dispersion = 0;                                                // 20 / Abbe number, >= 0

  // KHR_materials_diffuse_transmission; factor 0: there is none
  float diffuseTransmissionFactor = 0;                      // [0, 1]
  glm::vec3 diffuseTransmissionColorFactor = glm::vec3(1);  // linear, [0, 1]
  TextureRef diffuseTransmission;                           // linear; a
  TextureRef diffuseTransmissionColor;                      // sRGB

  // KHR_materials_diffuse_roughness; factor 0: Lambert's diffuse part, or the model that is chosen
  float diffuseRoughnessFactor = 0;  // [0, 1]
  TextureRef diffuseRoughness;       // linear; r

  // FACET_materials_models, of our own built-in scenes
  Microfacets microfacets = Microfacets::any;
  std::string masking;    // word of optics::maskings; empty: the picture's choice
  std::string conductor;  // metal preset (optics/presets.hpp) whose complex index is the metal's; empty: not known
};

// ---- Geometry -------------------------------------------------------------------------------------------------------

enum class Topology : uint8_t { points, lines, lineLoop, lineStrip, triangles, triangleStrip, triangleFan };

inline constexpr int maxTexCoordSets = 8;

// What a weight of 1 adds to a primitive's vertices. Each array is empty (adds nothing) or as long as the positions.
struct MorphTarget {
  std::vector<glm::vec3> positions, normals, tangents;  // differences, finite
  std::vector<glm::vec3> coatTangents, grainTangents;   // where the primitive has them
  std::array<std::vector<glm::vec2>, maxTexCoordSets> texCoords;
  std::vector<glm::vec4> colors;
  Bounds bounds;  // of the position differences; empty where there are none
};

// A joint's share of a vertex.
struct Influence {
  uint32_t joint = 0;  // index in Skin::joints, in range for every skin that the mesh is drawn with
  float weight = 0;    // >= 0
};

// One draw's geometry. Each attribute array is either empty (absent) or as long as positions.
struct Primitive {
  Topology topology = Topology::triangles;
  std::vector<glm::vec3> positions;  // metres, in the mesh's space, finite
  std::vector<glm::vec3> normals;    // unit
  std::vector<glm::vec4> tangents;   // xyz unit; bitangent = w cross(normal, tangent), w = +-1
  // Where the coat's normal texture, and anisotropy, lie in other texture coordinates than the normal texture; empty:
  // `tangents` are theirs, too.
  std::vector<glm::vec4> coatTangents, grainTangents;
  std::array<std::vector<glm::vec2>, maxTexCoordSets> texCoords;
  std::vector<glm::vec4> colors;      // linear, multiplies the base colour
  std::vector<uint32_t> indices;      // empty: vertices in order; all < positions.size()
  int material = -1;                  // -1: the default material
  std::vector<int> variantMaterials;  // KHR_materials_variants: by variant; -1: `material`. May be shorter or empty
  // Vertex v: entries v * influencesPerVertex and on; the weights of each vertex sum up to 1. Empty: not skinned.
  std::vector<Influence> influences;
  int influencesPerVertex = 0;
  std::vector<MorphTarget> targets;  // none, or as many as every other primitive of the mesh that has any
  bool flatNormals = false;          // normals were missing: each triangle is flat, also when it is deformed
  Bounds bounds;                     // of the vertices as they are
  std::vector<Bounds> jointBounds;   // by joint: of the vertices that it has a share of; up to the last with a share
};

struct Mesh {
  std::string name;
  std::vector<Primitive> primitives;
  std::vector<float> weights = {};            // of the morph targets; shorter: the rest is 0
  std::vector<std::string> targetNames = {};  // may be shorter or empty
};

// A skinned vertex lies at sum of weight * worldFromJoint * inverseBindMatrix * position; the node that draws the mesh
// does not move it.
struct Skin {
  std::string name;
  std::vector<int> joints;                      // nodes
  std::vector<glm::dmat4> inverseBindMatrices;  // one for each joint; empty: identities
};

// ---- Lights, cameras, nodes -----------------------------------------------------------------------------------------

enum class LightType : uint8_t { directional, point, spot };

// KHR_lights_punctual; shines along the node's -Z.
struct Light {
  std::string name;
  LightType type = LightType::point;
  glm::vec3 color = glm::vec3(1);                        // linear
  float intensity = 1;                                   // point and spot: candela (lm/sr); directional: lux (lm/m^2)
  float range = std::numeric_limits<float>::infinity();  // metres, > 0
  float innerConeAngle = 0;                              // radians, [0, outer)
  float outerConeAngle = 0.78539816f;                    // radians, (inner, pi/2]
  int profile = -1;  // of a point: index in Model::lightProfiles, whose candela `intensity` multiplies (EXT_lights_ies)
};

struct Camera {
  std::string name;
  bool perspective = true;
  double fovY = 0.8;          // radians
  double aspectRatio = 0;     // 0: the picture's
  double xMag = 1, yMag = 1;  // orthographic half sizes, metres
  double zNear = 0.01;
  double zFar = std::numeric_limits<double>::infinity();
};

struct Node {
  std::string name;
  int parent = -1;
  std::vector<int> children;
  // local = matrix if given, else translation * rotation * scale
  std::optional<glm::dmat4> matrix;
  glm::dvec3 translation = glm::dvec3(0);
  glm::dquat rotation = glm::dquat(1, 0, 0, 0);  // w, x, y, z; unit
  glm::dvec3 scale = glm::dvec3(1);
  int mesh = -1, camera = -1, light = -1, skin = -1;
  int profiledLight = -1;             // EXT_lights_ies: one more light, of this node alone
  std::vector<float> weights;         // of the mesh's morph targets; empty: the mesh's own
  bool visible = true;                // KHR_node_visibility: false hides the node and all below it
  std::vector<glm::dmat4> instances;  // EXT_mesh_gpu_instancing: node from instance; empty: the mesh is drawn once
};

// ---- Animation ------------------------------------------------------------------------------------------------------

enum class Interpolation : uint8_t { step, linear, cubicSpline };

// Keys; at least one. Each key has `width` numbers; a cubic spline three times as many: in-tangent, value, out-tangent.
struct AnimationSampler {
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;   // seconds, finite, rising strictly
  std::vector<float> values;  // finite
  int width = 0;
};

// What a channel sets. All but those of a node come from KHR_animation_pointer.
enum class AnimatedProperty : uint8_t {
  // of a node
  translation,
  rotation,  // x, y, z, w
  scale,
  weights,
  visible,
// of a material
#define PROPERTY(name, ...) name,
#include "scene/material_properties.inc"
#undef PROPERTY
  textureOffset,    // of `slot`
  textureRotation,  // likewise
  textureScale,     // likewise
  // of a light
  lightColor,
  lightIntensity,
  lightRange,
  lightInnerConeAngle,
  lightOuterConeAngle,
  // of a camera
  cameraFovY,
  cameraZNear,
  cameraZFar,
  cameraXMag,
  cameraYMag,
  cameraAspectRatio,
};

struct AnimationChannel {
  int sampler = 0;  // of the animation
  AnimatedProperty property = AnimatedProperty::translation;
  int object = -1;  // index of the node, material, light or camera
  TextureSlot slot = TextureSlot::baseColor;
  int element = -1;  // of weights: the only one that is set, by a sampler of width 1; -1: all of them
};

struct Animation {
  std::string name;
  std::vector<AnimationSampler> samplers;
  std::vector<AnimationChannel> channels;  // each sampler has the width that its property wants
};

// KHR_xmp_json_ld: metadata, and which objects it is about.
struct Metadata {
  struct Reference {
    std::string object;  // JSON pointer: "/asset", "/nodes/3"
    int packet = 0;
  };
  std::vector<std::string> packets;  // JSON text
  std::vector<Reference> references;
};

struct Scene {
  std::string name;
  std::vector<int> nodes;  // roots
  int imageLight = -1;     // of the file's environments (EXT_lights_image_based); -1: none
};

struct Model {
  std::string name;  // file name
  std::vector<Scene> scenes;
  int defaultScene = 0;
  std::vector<Node> nodes;
  std::vector<Mesh> meshes;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Light> lights;  // the file's list, then those with profiles
  std::vector<optics::LightProfile> lightProfiles;
  std::vector<Camera> cameras;
  std::vector<Skin> skins;
  std::vector<Animation> animations;
  std::vector<std::string> variants;  // KHR_materials_variants
  // For inspect.
  std::string generator, copyright;
  std::vector<std::string> extensionsUsed, extensionsRequired;
  Metadata xmp;
};

}  // namespace facet::scene
