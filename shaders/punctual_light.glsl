// Light of the scene's points, spots and suns.
#include "bsdf.glsl"
#include "lights.glsl"
#include "frame.glsl"
#ifdef HAS_SHEEN
#include "sheen_table.glsl"
#endif

layout(std430, binding = lightBinding) readonly buffer LightBlock { LightUniforms lights[]; };

// Radiance towards the viewer from every punctual light.
vec3 punctualLight(Surface s, vec3 position) {
  vec3 radiance = vec3(0.0);
  for (int i = 0; i < lights.length(); ++i) {
    LightUniforms light = lights[i];
    vec3 L = -light.direction.xyz;
    float attenuation = 1.0;
    if (light.position.w > 0.5) {
      vec3 toLight = light.position.xyz - position;
      float distance2 = dot(toLight, toLight);
      L = distance2 > 0.0 ? toLight * inversesqrt(distance2) : s.N;
      attenuation = distanceAttenuation(distance2, light.direction.w);
      if (light.position.w > 1.5)
        attenuation *= coneAttenuation(dot(light.direction.xyz, -L), light.cone.x, light.cone.y);
    }
#ifdef HAS_SHEEN
    s.sheen.albedoL = lookUpSheenAlbedo(dot(s.N, L), s.sheen.perceptualRoughness);
#endif
    if (attenuation > 0.0) radiance += evaluateBsdf(s, L) * light.color.rgb * attenuation;
  }
  return radiance;
}
