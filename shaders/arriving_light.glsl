// What the lights of the scene send to a point.
#include "layout.h"
#include "lights.glsl"
#include "light_profile.glsl" if LIGHT_PROFILES
#ifdef HAS_ENVIRONMENT
#include "frame.glsl"
#include "pixel_points.glsl"
#endif

layout(std430, binding = lightBinding) readonly buffer LightBlock { LightUniforms lights[]; };

// The environment's sun, which occlusion hides as it hides the rest of the environment.
bool isSun(LightUniforms light) { return light.position.w > 2.5; }

// Irradiance that a light sends to a point, on a plane facing it, and the direction L to it; otherwise where it is there.
vec3 arrivingLight(LightUniforms light, vec3 position, vec3 otherwise, out vec3 L) {
  L = -light.direction.xyz;
#ifdef HAS_ENVIRONMENT
  if (isSun(light)) {
    // Each of the gathered draws sees its own part of the disc.
    if (frame.options.z > 1.5) L = directionInDisc(L, light.cone.x, samplePoint(int(frame.options.y), sunPoints));
    L = worldFromEnvironment(L);
    return light.color.rgb * frame.environmentScale.z;
  }
#endif
  float attenuation = 1.0;
  if (light.position.w > 0.5) {
    vec3 toLight = light.position.xyz - position;
    float distance2 = dot(toLight, toLight);
    L = distance2 > 0.0 ? toLight * inversesqrt(distance2) : otherwise;
    attenuation = distanceAttenuation(distance2, light.direction.w) * profileCandela(light, -L);
    if (light.position.w > 1.5) attenuation *= coneAttenuation(dot(light.direction.xyz, -L), light.cone.x, light.cone.y);
  }
  return light.color.rgb * attenuation;
}
