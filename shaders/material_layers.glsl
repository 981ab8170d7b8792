// Textures and factors of the material extensions that change how a surface reflects, into the Surface.
#include "material.glsl"
#include "bsdf.glsl"
#include "mapping.glsl"
#include "dfg_table.glsl"
#ifdef SPREAD_NORMALS
#include "normal_spread.glsl"
#endif
#ifdef HAS_SHEEN
#include "sheen_table.glsl"
#endif

#ifdef HAS_SPECULAR_TEXTURE
layout(binding = specularUnit) uniform sampler2D specularTexture;
#endif
#ifdef HAS_SPECULAR_COLOR_TEXTURE
layout(binding = specularColorUnit) uniform sampler2D specularColorTexture;
#endif
#ifdef HAS_CLEARCOAT_TEXTURE
layout(binding = clearcoatUnit) uniform sampler2D clearcoatTexture;
#endif
#ifdef HAS_CLEARCOAT_ROUGHNESS_TEXTURE
layout(binding = clearcoatRoughnessUnit) uniform sampler2D clearcoatRoughnessTexture;
#endif
#ifdef HAS_CLEARCOAT_NORMAL_TEXTURE
layout(binding = clearcoatNormalUnit) uniform sampler2D clearcoatNormalTexture;
#endif
#ifdef HAS_SHEEN_COLOR_TEXTURE
layout(binding = sheenColorUnit) uniform sampler2D sheenColorTexture;
#endif
#ifdef HAS_SHEEN_ROUGHNESS_TEXTURE
layout(binding = sheenRoughnessUnit) uniform sampler2D sheenRoughnessTexture;
#endif
#ifdef HAS_ANISOTROPY_TEXTURE
layout(binding = anisotropyUnit) uniform sampler2D anisotropyTexture;
#endif
#ifdef HAS_IRIDESCENCE_TEXTURE
layout(binding = iridescenceUnit) uniform sampler2D iridescenceTexture;
#endif
#ifdef HAS_IRIDESCENCE_THICKNESS_TEXTURE
layout(binding = iridescenceThicknessUnit) uniform sampler2D iridescenceThicknessTexture;
#endif

// KHR_materials_ior, KHR_materials_specular: f0 and f90 of the dielectric, both times the weight.
#ifdef HAS_DIELECTRIC_SPECULAR
void readDielectricSpecular(inout Surface s, Varyings v) {
  float weight = material.specular.a;
  vec3 color = material.specular.rgb;
#ifdef HAS_SPECULAR_TEXTURE
  weight *= texture(specularTexture, slotTexCoord(v, specularUnit)).a;
#endif
#ifdef HAS_SPECULAR_COLOR_TEXTURE
  color *= texture(specularColorTexture, slotTexCoord(v, specularColorUnit)).rgb;
#endif
  weight = clamp(weight, 0.0, 1.0);
  s.dielectricF0 = clamp(f0FromIor(material.clearcoat.w) * color, 0.0, 1.0) * weight;
  s.dielectricF90 = weight;
}
#endif

// The texel's direction, turned by the rotation, in the plane of the shading normal. Where there is no tangent, or it is
// along the normal, any direction.
#ifdef HAS_ANISOTROPY
void readGrain(inout Surface s, Varyings v) {
  float strength = material.anisotropy.x;
  vec2 along = material.anisotropy.yz;
#ifdef HAS_ANISOTROPY_TEXTURE
  vec3 texel = texture(anisotropyTexture, slotTexCoord(v, anisotropyUnit)).rgb;
  vec2 direction = texel.rg * 2.0 - 1.0;
  along = vec2(direction.x * along.x - direction.y * along.y, direction.x * along.y + direction.y * along.x);
  strength *= texel.b;
#endif
  vec3 bitangent = v.tangent.w * cross(v.normal, v.tangent.xyz);
  vec3 T = along.x * v.tangent.xyz + along.y * bitangent;
  T -= dot(T, s.N) * s.N;
  s.grain.T = dot(T, T) > 1e-12 ? normalize(T) : frameAround(s.N)[0];
  s.grain.B = cross(s.N, s.grain.T);
  s.grain.alpha = alphaFromAnisotropy(s.alpha, clamp(strength, 0.0, 1.0));
  vec3 V = s.V * mat3(s.grain.T, s.grain.B, s.N);
  s.dfg.xy = dfgAnisotropic(V, max(s.grain.alpha, minAnalyticAlpha));
}
#endif

#ifdef HAS_IRIDESCENCE
void readFilm(inout Surface s, Varyings v) {
  float weight = material.iridescence.x;
  float thicknessNm = material.iridescence.w;
#ifdef HAS_IRIDESCENCE_TEXTURE
  weight *= texture(iridescenceTexture, slotTexCoord(v, iridescenceUnit)).r;
#endif
#ifdef HAS_IRIDESCENCE_THICKNESS_TEXTURE
  float share = texture(iridescenceThicknessTexture, slotTexCoord(v, iridescenceThicknessUnit)).g;
  thicknessNm = mix(material.iridescence.z, material.iridescence.w, share);
#endif
  setFilm(s, clamp(weight, 0.0, 1.0), material.iridescence.y, max(thicknessNm, 0.0));
}
#endif

#ifdef HAS_SHEEN
void readSheen(inout Surface s, Varyings v) {
  vec3 color = material.sheen.rgb;
  float perceptualRoughness = material.sheen.a;
#ifdef HAS_SHEEN_COLOR_TEXTURE
  color *= texture(sheenColorTexture, slotTexCoord(v, sheenColorUnit)).rgb;
#endif
#ifdef HAS_SHEEN_ROUGHNESS_TEXTURE
  perceptualRoughness *= texture(sheenRoughnessTexture, slotTexCoord(v, sheenRoughnessUnit)).a;
#endif
  s.sheen.color = clamp(color, 0.0, 1.0);
  s.sheen.perceptualRoughness = clamp(perceptualRoughness, 0.0, 1.0);
  s.sheen.alpha = s.sheen.perceptualRoughness * s.sheen.perceptualRoughness;
  s.sheen.albedoV = lookUpSheenAlbedo(s.NoV, s.sheen.perceptualRoughness);
  s.sheen.albedoL = s.sheen.albedoV;
}
#endif

// Without a normal texture of its own the coat is smooth, whatever bumps the base has.
#ifdef HAS_CLEARCOAT
void readCoat(inout Surface s, Varyings v) {
  float weight = material.clearcoat.x;
  float perceptualRoughness = material.clearcoat.y;
#ifdef HAS_CLEARCOAT_TEXTURE
  weight *= texture(clearcoatTexture, slotTexCoord(v, clearcoatUnit)).r;
#endif
#ifdef HAS_CLEARCOAT_ROUGHNESS_TEXTURE
  perceptualRoughness *= texture(clearcoatRoughnessTexture, slotTexCoord(v, clearcoatRoughnessUnit)).g;
#endif
#ifdef HAS_CLEARCOAT_NORMAL_TEXTURE
  vec3 texel = texture(clearcoatNormalTexture, slotTexCoord(v, clearcoatNormalUnit)).xyz;
  s.coat.N = normalFromTexel(v, texel, material.clearcoat.z, s.V);
#else
  s.coat.N = geometryNormal(v, s.V);
#endif
  s.coat.NoV = clamp(dot(s.coat.N, s.V), minNoV, 1.0);
  s.coat.weight = clamp(weight, 0.0, 1.0);
  s.coat.perceptualRoughness = clamp(perceptualRoughness, 0.0, 1.0);
#ifdef SPREAD_NORMALS
  s.coat.perceptualRoughness = roughnessOverPixel(s.coat.perceptualRoughness, dFdx(s.coat.N), dFdy(s.coat.N));
#endif
  s.coat.alpha = s.coat.perceptualRoughness * s.coat.perceptualRoughness;
  s.coat.dfg = lookUpDfg(s.coat.NoV, s.coat.perceptualRoughness);
}
#endif

// Into a surface that has everything else.
void readLayers(inout Surface s, Varyings v) {
#ifdef HAS_DIELECTRIC_SPECULAR
  readDielectricSpecular(s, v);
#endif
#ifdef HAS_ANISOTROPY
  readGrain(s, v);
#endif
#ifdef HAS_IRIDESCENCE
  readFilm(s, v);
#endif
#ifdef HAS_SHEEN
  readSheen(s, v);
#endif
#ifdef HAS_CLEARCOAT
  readCoat(s, v);
#endif
}
