// Light of the scene's points, spots and suns.
#include "bsdf.glsl"
#include "lights.glsl"
#include "frame.glsl"
#ifdef HAS_SHEEN
#include "sheen_table.glsl"
#endif

layout(std430, binding = lightBinding) readonly buffer LightBlock { LightUniforms lights[]; };

#ifdef HAS_ENVIRONMENT
// R2 sequence (Roberts 2018) in 32-bit fixed point.
vec2 discPoint(int i) {
  return vec2(uvec2(i) * uvec2(3242174889u, 2447445414u) + 0x80000000u) * (1.0 / 4294967296.0);
}

// The lobes as they reflect a part of the environment's sun.
Surface sunlit(Surface s, LightUniforms light) {
  float angularRadius = light.cone.x * inversesqrt(max(frame.options.z, 1.0));
  s.alpha = alphaOfDisc(s.alpha, angularRadius);
#ifdef HAS_ANISOTROPY
  s.grain.alpha = vec2(alphaOfDisc(s.grain.alpha.x, angularRadius), alphaOfDisc(s.grain.alpha.y, angularRadius));
#endif
#ifdef HAS_CLEARCOAT
  s.coat.alpha = alphaOfDisc(s.coat.alpha, angularRadius);
#endif
  return s;
}
#endif

// Irradiance that a light sends to a point, on a plane facing it, and the direction L to it; otherwise where it is there.
vec3 arrivingLight(LightUniforms light, vec3 position, vec3 otherwise, out vec3 L) {
  L = -light.direction.xyz;
#ifdef HAS_ENVIRONMENT
  if (light.position.w > 2.5) {
    // Each of the gathered draws sees its own part of the disc.
    if (frame.options.z > 1.5) L = directionInDisc(L, light.cone.x, discPoint(int(frame.options.y)));
    L = worldFromEnvironment(L);
    return light.color.rgb * frame.environmentScale.z;
  }
#endif
  float attenuation = 1.0;
  if (light.position.w > 0.5) {
    vec3 toLight = light.position.xyz - position;
    float distance2 = dot(toLight, toLight);
    L = distance2 > 0.0 ? toLight * inversesqrt(distance2) : otherwise;
    attenuation = distanceAttenuation(distance2, light.direction.w);
    if (light.position.w > 1.5) attenuation *= coneAttenuation(dot(light.direction.xyz, -L), light.cone.x, light.cone.y);
  }
  return light.color.rgb * attenuation;
}

// Radiance towards the viewer from every punctual light.
vec3 punctualLight(Surface s, vec3 position) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, s.N, L);
    if (arriving == vec3(0.0)) continue;
#ifdef HAS_SHEEN
    s.sheen.albedoL = lookUpSheenAlbedo(dot(s.N, L), s.sheen.perceptualRoughness);
#endif
#ifdef HAS_ENVIRONMENT
    if (lights[i].position.w > 2.5) {
      radiance += evaluateBsdf(sunlit(s, lights[i]), L) * arriving * s.occlusion;
      continue;
    }
#endif
    radiance += evaluateBsdf(s, L) * arriving;
  }
  return radiance;
}
