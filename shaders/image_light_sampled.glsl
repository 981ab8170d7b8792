// Distant light by filtered importance sampling at every pixel (Krivanek and Colbert 2008): the specular integral
// itself, without the split sum. Visible normals (Dupuy and Benyoub 2023) on a golden-ratio lattice; each sample reads
// a level by the size of its share of the lobe, counting all samples that the pixel will get.
#include "bsdf.glsl"
#include "mapping.glsl"
#include "frame.glsl"

layout(binding = irradianceUnit) uniform samplerCube irradianceOverPi;
layout(binding = environmentCubeUnit) uniform samplerCube environmentCube;

// Half vector in the frame of N, V there too: spherical cap sampling.
vec3 sampleVisibleNormal(vec3 V, float alpha, vec2 u) {
  vec3 stretched = normalize(vec3(alpha * V.xy, V.z));
  float phi = 2.0 * PI * u.x;
  float z = 1.0 - u.y * (1.0 + stretched.z);
  float radius = sqrt(max(0.0, 1.0 - z * z));
  vec3 H = vec3(radius * cos(phi), radius * sin(phi), z) + stretched;
  return normalize(vec3(alpha * H.xy, max(H.z, 1e-7)));
}

// A sample reads four times its share of the lobe, as Krivanek and Colbert advise: under a hard sun, texels of exactly its
// share nearly double the picture's error by noise; with sixteen times the share the blur begins to show.
const float filterGain = 4.0;

vec3 imageLight(Surface s) {
  mat3 worldFromLocal = frameAround(s.N);
  vec3 V = s.V * worldFromLocal;
  V = normalize(vec3(V.xy, max(V.z, minNoV)));
  float faceSize = float(textureSize(environmentCube, 0).x);
  float texelSolidAngle = 4.0 * PI / (6.0 * faceSize * faceSize);
  float alpha = max(s.alpha, 1e-5);
  vec3 specular = vec3(0.0);
  // Every draw of the pixel continues the same sequence (Roberts 2018, R2).
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  float total = float(IMAGE_LIGHT_SAMPLES) * frame.options.z;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    // in 32-bit fixed point, where no count loses digits
    vec2 u = vec2(uvec2(i) * uvec2(3242174889u, 2447445414u) + 0x80000000u) * (1.0 / 4294967296.0);
    vec3 H = sampleVisibleNormal(V, alpha, u);
    float VoH = max(dot(V, H), 1e-6);
    vec3 L = 2.0 * VoH * H - V;
    if (L.z <= 0.0) continue;
    float pdf = G1_GGX(V.z, alpha) * D_GGX(vec3(0.0, 0.0, 1.0), H, alpha) / (4.0 * V.z);
    float level = 0.5 * log2(max(filterGain / (total * pdf * texelSolidAngle), 1.0));
    float weight = V_SmithGGXCorrelated(V.z, L.z, alpha) * 4.0 * V.z * L.z / G1_GGX(V.z, alpha);
    vec3 fresnel = mix(F_Schlick(VoH, s.dielectricF0, 1.0), F_Schlick(VoH, s.baseColor, 1.0), s.metallic);
    specular += fresnel * weight * textureLod(environmentCube, environmentFromWorld(worldFromLocal * L), level).rgb;
  }
  specular /= float(IMAGE_LIGHT_SAMPLES);
  vec3 irradiance = textureLod(irradianceOverPi, environmentFromWorld(s.N), 0.0).rgb;
  return (specular + irradiance * irradianceAlbedo(s)) * (frame.environmentScale.x * s.occlusion);
}
