#include "material.glsl"
#if defined(MERL_BRDF) || defined(UTIA_BRDF)
#include "measured_light.glsl"
#elif !defined(UNLIT)
#ifdef HAS_PUNCTUAL_LIGHTS
#include "punctual_light.glsl"
#else
#include "punctual_light_none.glsl"
#endif
#if defined(HAS_ENVIRONMENT) && defined(IMAGE_LIGHT_SAMPLES)
#include "image_light_sampled.glsl"
#elif defined(HAS_ENVIRONMENT)
#include "image_light.glsl"
#else
#include "image_light_none.glsl"
#endif
#if defined(HAS_PUNCTUAL_LIGHTS) || defined(HAS_ENVIRONMENT) || defined(HAS_TRANSMISSION)
#define HAS_DFG
#include "dfg_table.glsl"
#if defined(HAS_DIELECTRIC_SPECULAR) || defined(HAS_CLEARCOAT) || defined(HAS_SHEEN) || defined(HAS_ANISOTROPY) || \
    defined(HAS_IRIDESCENCE)
#include "material_layers.glsl"
#define HAS_LAYERS
#endif
#endif
#ifdef HAS_TRANSMISSION
#include "transmitted_light.glsl"
#endif
#ifdef HAS_DIFFUSE_TRANSMISSION
#include "diffuse_transmitted_light.glsl"
#endif
#endif
#ifdef SPREAD_NORMALS
#include "normal_spread.glsl"
#endif
#include "constants.glsl"

layout(location = 0) in vec3 inPosition;
#ifdef HAS_NORMAL
layout(location = 1) in vec3 inNormal;
#endif
#ifdef HAS_TANGENT
layout(location = 2) in vec4 inTangent;
#endif
#ifdef HAS_VERTEX_COLOR
layout(location = 3) in vec4 inColor;
#endif
#ifdef HAS_VOLUME
layout(location = 12) in float inScale;
#endif
#define DECLARE(n) layout(location = 4 + n) in vec2 inTexCoord##n;
EACH_TEXCOORD(DECLARE)

layout(location = 0) out vec4 outColor;  // scene-linear, associated alpha

Varyings readVaryings() {
  Varyings v;
  v.position = inPosition;
  v.normal = vec3(0.0);
  v.tangent = vec4(0.0);
  v.color = vec4(1.0);
  v.scale = 1.0;
#ifdef HAS_VOLUME
  v.scale = inScale;
#endif
#ifdef HAS_NORMAL
  v.normal = inNormal;
#endif
#ifdef HAS_TANGENT
  v.tangent = inTangent;
#endif
#ifdef HAS_VERTEX_COLOR
  v.color = inColor;
#endif
#define TAKE(n) v.texCoord##n = inTexCoord##n;
  EACH_TEXCOORD(TAKE)
#ifdef FLAT_NORMALS
  // Towards the viewer, whichever way the triangle winds; of lengths whose product does not underflow.
  vec3 dx = dFdx(inPosition), dy = dFdy(inPosition);
  vec3 facing = cross(dx / max(max(abs(dx.x), max(abs(dx.y), abs(dx.z))), 1e-37),
                      dy / max(max(abs(dy.x), max(abs(dy.y), abs(dy.z))), 1e-37));
  v.normal = safeNormalize(gl_FrontFacing ? facing : -facing, inNormal);
#endif
#ifdef DOUBLE_SIDED
  if (!gl_FrontFacing) {  // glTF 2.0, 3.9.6: the back face has the reversed shading normal, bumps included
    v.normal = -v.normal;
    v.tangent = -v.tangent;  // with w, so that the bitangent turns round too
  }
#endif
  return v;
}

vec3 towardsViewer(vec3 position) {
  return frame.eye.w > 0.5 ? safeNormalize(frame.eye.xyz - position, vec3(0.0, 0.0, 1.0)) : frame.towardsEye.xyz;
}

#if defined(MERL_BRDF) || defined(UTIA_BRDF)
// The measured BRDF in the material's place; what it emits stays.
vec4 litRadiance(Varyings v, vec3 V, vec3 baseColor) {
  MeasuredSurface s = makeMeasuredSurface(materialNormal(v, V), v.tangent, V, materialOcclusion(v));
  vec3 radiance = materialEmission(v);
#ifdef HAS_PUNCTUAL_LIGHTS
  radiance += measuredPunctualLight(s, v.position);
#endif
#ifdef HAS_ENVIRONMENT
  radiance += measuredImageLight(s);
#endif
  return vec4(radiance, 1.0);
}
#elif !defined(UNLIT)
// rgb radiance, a coverage: 1 but where nothing is behind what transmits.
vec4 litRadiance(Varyings v, vec3 V, vec3 baseColor) {
#ifdef SPECULAR_GLOSSINESS
  Surface s = makeSpecularGlossinessSurface(materialNormal(v, V), V, baseColor, materialSpecularGlossiness(v), materialOcclusion(v));
#else
  vec2 metallicRoughness = materialMetallicRoughness(v);
  Surface s = makeSurface(materialNormal(v, V), V, baseColor, metallicRoughness.x, metallicRoughness.y, materialOcclusion(v));
#endif
#ifdef SPREAD_NORMALS
  setRoughness(s, roughnessOverPixel(s.perceptualRoughness, dFdx(s.N), dFdy(s.N)));
#endif
#ifdef HAS_DFG
  s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);
#endif
#ifdef HAS_LAYERS
  readLayers(s, v);
#endif
  vec3 emission = materialEmission(v);
#ifdef HAS_LAYERS
  emission *= coatLeft(s);  // it lies below the coat (KHR_materials_clearcoat)
#endif
#if defined(HAS_TRANSMISSION) || defined(HAS_DIFFUSE_TRANSMISSION)
  vec2 transmission = materialTransmission(v);
  s.diffuseShare = 1.0 - transmission.x - transmission.y;
#endif
  vec3 radiance = emission + punctualLight(s, v.position) + imageLight(s);
  float coverage = 1.0;
#ifdef HAS_DIFFUSE_TRANSMISSION
  radiance += diffuseTransmittedLight(s, v.position, transmission.y * materialDiffuseTransmissionColor(v), materialThickness(v));
#endif
#ifdef HAS_TRANSMISSION
  vec3 share = transmission.x * s.baseColor * enteringShare(s);
  coverage = addTransmittedLight(s, v.position, share, material.clearcoat.w, materialThickness(v), radiance);
#endif
  return vec4(radiance, coverage);
}
#endif

#ifdef CHANNEL
#include "channels.glsl"
#endif

void main() {
  Varyings v = readVaryings();
  vec4 baseColor = materialBaseColor(v);
#ifdef ALPHA_MASK
  if (baseColor.a < material.factors.w) discard;
#endif
#ifdef ALPHA_BLEND
  float coverage = clamp(baseColor.a, 0.0, 1.0);
#else
  float coverage = 1.0;
#endif
#if defined(CHANNEL)
  outColor = vec4(channelValue(v, towardsViewer(v.position), baseColor), 1.0);
#elif defined(UNLIT)
  outColor = vec4(min(baseColor.rgb, maxHalf) * coverage, coverage);
#else
  vec4 lit = litRadiance(v, towardsViewer(v.position), baseColor.rgb);
  outColor = vec4(clamp(lit.rgb, 0.0, maxHalf), lit.a) * coverage;
#if defined(HAS_TRANSMISSION) && defined(ALPHA_BLEND)
  outColor += behindSharp(gl_FragCoord.xy) * (1.0 - coverage);
#endif
#endif
}
