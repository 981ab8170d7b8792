// Debug views: CHANNEL is the index in shading::channelNames. Values are shown as they are; what a primitive or its
// material does not have shows as grey and black checks, never as a plausible number.

vec3 absentChannel() {
  ivec2 cell = ivec2(gl_FragCoord.xy) / 8;
  return vec3((cell.x + cell.y) % 2 == 0 ? 0.35 : 0.05);
}

vec3 channelValue(Varyings v, vec3 V, vec4 baseColor) {
#if CHANNEL == 1  // normal
#ifdef HAS_NORMAL
  return materialNormal(v, V) * 0.5 + 0.5;
#endif
#elif CHANNEL == 2  // geometryNormal
#ifdef HAS_NORMAL
  return geometryNormal(v, V) * 0.5 + 0.5;
#endif
#elif CHANNEL == 3  // tangent
#ifdef HAS_TANGENT
  return safeNormalize(v.tangent.xyz, vec3(0.0)) * 0.5 + 0.5;
#endif
#elif CHANNEL == 4  // uv
#ifdef HAS_TEXCOORD_0
  return vec3(fract(v.texCoord0), 0.0);
#endif
#elif CHANNEL == 5  // baseColor
  return baseColor.rgb;
#elif CHANNEL == 6  // metallic
  return vec3(materialMetallicRoughness(v).x);
#elif CHANNEL == 7  // roughness
  return vec3(materialMetallicRoughness(v).y);
#elif CHANNEL == 8  // occlusion
#ifdef HAS_OCCLUSION_TEXTURE
  return vec3(materialOcclusion(v));
#endif
#elif CHANNEL == 9  // emissive
  return materialEmission(v);
#elif CHANNEL == 10  // alpha
  return vec3(baseColor.a);
#endif
  return absentChannel();
}
