// Debug views: CHANNEL is one of CHANNEL_*, the rows of src/shading/channels.inc. What a primitive or its material does
// not have (CHANNEL_ABSENT) shows as grey and black checks, never as a plausible number.
#include "choices.glsl"
#include "material_factors.glsl"
#include "fresnel.glsl"
#include "face_normal.glsl"

vec3 absentChannel() {
  ivec2 cell = ivec2(gl_FragCoord.xy) / 8;
  return vec3((cell.x + cell.y) % 2 == 0 ? 0.35 : 0.05);
}

// 10 x 10 cells; u grows with red, v with green. Where cells are finer than pixels, their mean.
vec3 uvChecker(vec2 uv) {
  vec2 cells = 10.0 * uv;
  float dark = mod(floor(cells.x) + floor(cells.y), 2.0);
  float finer = smoothstep(0.4, 0.9, max(fwidth(cells.x), fwidth(cells.y)));
  return vec3(fract(uv), 0.5) * mix(1.0, 0.35, mix(dark, 0.5, finer));
}

// A colour for each, neighbours in number far apart.
vec3 identityColor(uint identity) {
  float turn = fract(float(identity) * 0.61803399), light = 1.0 - 0.25 * float(identity % 3u);
  return light * clamp(abs(fract(turn + vec3(0.0, 2.0, 1.0) / 3.0) * 6.0 - 3.0) - 1.0, 0.15, 1.0);
}

#ifdef HAS_BASE_COLOR_TEXTURE
// Texels per metre.
float baseColorDensity(Varyings v) {
  vec2 texel = slotTexCoord(v, material.baseColorSlot) * vec2(textureSize(baseColorTexture, 0));
  vec2 dx = dFdx(texel), dy = dFdy(texel);
  vec3 px = dFdx(v.position), py = dFdy(v.position);
  float unit = max(max(max(abs(px.x), abs(px.y)), abs(px.z)), 1e-30);  // products of tiny lengths underflow
  return sqrt(abs(dx.x * dy.y - dx.y * dy.x) / max(length(cross(px / unit, py / unit)), 1e-30)) / unit;
}
float baseColorLevel(Varyings v) { return textureQueryLod(baseColorTexture, slotTexCoord(v, material.baseColorSlot)).y; }
#else
float baseColorDensity(Varyings v) { return 0.0; }
float baseColorLevel(Varyings v) { return 0.0; }
#endif

vec3 materialF0(Varyings v, vec3 baseColor) {
#ifdef SPECULAR_GLOSSINESS
  return materialSpecularGlossiness(v).rgb;
#else
  vec3 dielectric = clamp(f0FromIor(material.ior) * materialSpecularColor(v), 0.0, 1.0) * materialSpecularWeight(v);
  return mix(dielectric, baseColor, materialMetallicRoughness(v).x);
#endif
}

// Numbers as they are. node: index of what is drawn.
vec3 channelValue(Varyings v, vec3 V, vec4 baseColor, uint node) {
#if defined(CHANNEL_ABSENT)
  return absentChannel();
#elif CHANNEL == CHANNEL_NORMAL
  return materialNormal(v, V);
#elif CHANNEL == CHANNEL_GEOMETRY_NORMAL
  return geometryNormal(v, V);
#elif CHANNEL == CHANNEL_FACE_NORMAL
  return safeNormalize(faceNormal(v.position), V);
#elif CHANNEL == CHANNEL_NORMAL_TEXTURE
  return normalTexel(v).xyz;
#elif CHANNEL == CHANNEL_TANGENT
  return safeNormalize(v.tangent.xyz, vec3(0.0));
#elif CHANNEL == CHANNEL_BITANGENT
  return safeNormalize(v.tangent.w * cross(v.normal, v.tangent.xyz), vec3(0.0));
#elif CHANNEL == CHANNEL_HANDEDNESS
  return vec3(v.tangent.w);
#elif CHANNEL == CHANNEL_UV
  return vec3(fract(v.texCoord0), 0.0);
#elif CHANNEL == CHANNEL_UV1
  return vec3(fract(v.texCoord1), 0.0);
#elif CHANNEL == CHANNEL_UV2
  return vec3(fract(v.texCoord2), 0.0);
#elif CHANNEL == CHANNEL_UV3
  return vec3(fract(v.texCoord3), 0.0);
#elif CHANNEL == CHANNEL_UV4
  return vec3(fract(v.texCoord4), 0.0);
#elif CHANNEL == CHANNEL_UV5
  return vec3(fract(v.texCoord5), 0.0);
#elif CHANNEL == CHANNEL_UV6
  return vec3(fract(v.texCoord6), 0.0);
#elif CHANNEL == CHANNEL_UV7
  return vec3(fract(v.texCoord7), 0.0);
#elif CHANNEL == CHANNEL_CHECKER
  return uvChecker(v.texCoord0);
#elif CHANNEL == CHANNEL_CHECKER1
  return uvChecker(v.texCoord1);
#elif CHANNEL == CHANNEL_CHECKER2
  return uvChecker(v.texCoord2);
#elif CHANNEL == CHANNEL_CHECKER3
  return uvChecker(v.texCoord3);
#elif CHANNEL == CHANNEL_CHECKER4
  return uvChecker(v.texCoord4);
#elif CHANNEL == CHANNEL_CHECKER5
  return uvChecker(v.texCoord5);
#elif CHANNEL == CHANNEL_CHECKER6
  return uvChecker(v.texCoord6);
#elif CHANNEL == CHANNEL_CHECKER7
  return uvChecker(v.texCoord7);
#elif CHANNEL == CHANNEL_VERTEX_COLOR
  return v.color.rgb;
#elif CHANNEL == CHANNEL_DEPTH
  return vec3(dot(frame.eye.xyz - v.position, frame.towardsEye.xyz));
#elif CHANNEL == CHANNEL_NODE
  return vec3(float(node));
#elif CHANNEL == CHANNEL_MATERIAL
  return vec3(material.index);
#elif CHANNEL == CHANNEL_TEXEL_DENSITY
  return vec3(baseColorDensity(v));
#elif CHANNEL == CHANNEL_MIP_LEVEL
  return vec3(baseColorLevel(v));
#elif CHANNEL == CHANNEL_OVERDRAW
  return vec3(1.0);
#elif CHANNEL == CHANNEL_BASE_COLOR
  return baseColor.rgb;
#elif CHANNEL == CHANNEL_ALPHA
  return vec3(baseColor.a);
#elif CHANNEL == CHANNEL_METALLIC
  return vec3(materialMetallicRoughness(v).x);
#elif CHANNEL == CHANNEL_ROUGHNESS
  return vec3(materialMetallicRoughness(v).y);
#elif CHANNEL == CHANNEL_F0
  return materialF0(v, baseColor.rgb);
#elif CHANNEL == CHANNEL_OCCLUSION
  return vec3(materialOcclusion(v));
#elif CHANNEL == CHANNEL_EMISSIVE
  return materialEmission(v);
#elif CHANNEL == CHANNEL_IOR
  return vec3(material.ior);
#elif CHANNEL == CHANNEL_SPECULAR
  return vec3(materialSpecularWeight(v));
#elif CHANNEL == CHANNEL_SPECULAR_COLOR
  return materialSpecularColor(v);
#elif CHANNEL == CHANNEL_CLEARCOAT
  return vec3(materialClearcoat(v));
#elif CHANNEL == CHANNEL_CLEARCOAT_ROUGHNESS
  return vec3(materialClearcoatRoughness(v));
#elif CHANNEL == CHANNEL_CLEARCOAT_NORMAL
  return materialClearcoatNormal(v, V);
#elif CHANNEL == CHANNEL_SHEEN_COLOR
  return materialSheenColor(v);
#elif CHANNEL == CHANNEL_SHEEN_ROUGHNESS
  return vec3(materialSheenRoughness(v));
#elif CHANNEL == CHANNEL_ANISOTROPY
  return vec3(materialAnisotropy(v));
#elif CHANNEL == CHANNEL_ANISOTROPY_DIRECTION
  return safeNormalize(materialGrainDirection(v), vec3(0.0));
#elif CHANNEL == CHANNEL_IRIDESCENCE
  return vec3(materialIridescence(v));
#elif CHANNEL == CHANNEL_IRIDESCENCE_THICKNESS
  return vec3(materialFilmThickness(v));
#elif CHANNEL == CHANNEL_IRIDESCENCE_IOR
  return vec3(material.iridescenceIor);
#elif CHANNEL == CHANNEL_TRANSMISSION
  return vec3(materialTransmission(v));
#elif CHANNEL == CHANNEL_THICKNESS
  return vec3(material.thicknessFactor * thicknessTexel(v).g);
#elif CHANNEL == CHANNEL_ATTENUATION_COLOR
  return material.attenuationColor;
#elif CHANNEL == CHANNEL_ATTENUATION_DISTANCE
  return vec3(1.0 / material.inverseAttenuationDistance);
#elif CHANNEL == CHANNEL_DISPERSION
  return vec3(material.dispersion);
#elif CHANNEL == CHANNEL_DIFFUSE_TRANSMISSION
  return vec3(materialDiffuseTransmission(v));
#elif CHANNEL == CHANNEL_DIFFUSE_TRANSMISSION_COLOR
  return materialDiffuseTransmissionColor(v);
#elif CHANNEL == CHANNEL_DIFFUSE_ROUGHNESS
  return vec3(materialDiffuseRoughness(v));
#else
#error "a channel without a value"
#endif
}

// As the picture holds it: radiance alone holds numbers, what is shown holds colours where its mean over a pixel's
// samples is to be one of colours.
vec3 shownChannel(Varyings v, vec3 V, vec4 baseColor, uint node) {
  vec3 value = channelValue(v, V, baseColor, node);
  if (frame.stored.w == 0.0) return value;
#if defined(SHOWS_QUANTITY) && defined(CHANNEL_ABSENT)
  return vec3(0.0, value.x, 1.0);  // quantityColor
#elif defined(SHOWS_QUANTITY)
  return vec3(value.x * frame.stored.w, 0.0, 0.0);
#elif defined(SHOWS_DIRECTION) && !defined(CHANNEL_ABSENT)
  return value * 0.5 + 0.5;
#elif defined(SHOWS_IDENTITY)
  return identityColor(uint(value.x + 0.5));
#else
  return value;
#endif
}
