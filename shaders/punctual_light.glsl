// Light of the scene's points, spots and suns.
#include "bsdf.glsl"
#include "lights.glsl"
#include "frame.glsl"
#ifdef HAS_SHEEN
#include "sheen_table.glsl"
#endif

layout(std430, binding = lightBinding) readonly buffer LightBlock { LightUniforms lights[]; };

// Irradiance that a light sends to a point, on a plane facing it, and the direction L to it; otherwise where it is there.
vec3 arrivingLight(LightUniforms light, vec3 position, vec3 otherwise, out vec3 L) {
  L = -light.direction.xyz;
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
#ifdef HAS_SHEEN
    s.sheen.albedoL = lookUpSheenAlbedo(dot(s.N, L), s.sheen.perceptualRoughness);
#endif
    if (arriving != vec3(0.0)) radiance += evaluateBsdf(s, L) * arriving;
  }
  return radiance;
}
