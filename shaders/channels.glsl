// Debug views: CHANNEL is one of CHANNEL_*. Values are shown as they are; what a primitive or its
// material does not have shows as grey and black checks, never as a plausible number.
#include "choices.glsl"

vec3 absentChannel() {
  ivec2 cell = ivec2(gl_FragCoord.xy) / 8;
  return vec3((cell.x + cell.y) % 2 == 0 ? 0.35 : 0.05);
}

vec3 channelValue(Varyings v, vec3 V, vec4 baseColor) {
#if CHANNEL == CHANNEL_NORMAL
#ifdef HAS_NORMAL
  return materialNormal(v, V) * 0.5 + 0.5;
#endif
#elif CHANNEL == CHANNEL_GEOMETRY_NORMAL
#ifdef HAS_NORMAL
  return geometryNormal(v, V) * 0.5 + 0.5;
#endif
#elif CHANNEL == CHANNEL_TANGENT
#ifdef HAS_TANGENT
  return safeNormalize(v.tangent.xyz, vec3(0.0)) * 0.5 + 0.5;
#endif
#elif CHANNEL == CHANNEL_UV
#ifdef HAS_TEXCOORD_0
  return vec3(fract(v.texCoord0), 0.0);
#endif
#elif CHANNEL == CHANNEL_BASE_COLOR
  return baseColor.rgb;
#elif CHANNEL == CHANNEL_METALLIC
  return vec3(materialMetallicRoughness(v).x);
#elif CHANNEL == CHANNEL_ROUGHNESS
  return vec3(materialMetallicRoughness(v).y);
#elif CHANNEL == CHANNEL_OCCLUSION
#ifdef HAS_OCCLUSION_TEXTURE
  return vec3(materialOcclusion(v));
#endif
#elif CHANNEL == CHANNEL_EMISSIVE
  return materialEmission(v);
#elif CHANNEL == CHANNEL_ALPHA
  return vec3(baseColor.a);
#endif
  return absentChannel();
}
