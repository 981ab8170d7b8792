// What of a light's way to a point its shadow map knows (src/frame/shadow_maps.hpp).
#include "arriving_light.glsl"

layout(binding = shadowMapsUnit) uniform sampler2DArrayShadow shadowMaps;
layout(std140, binding = shadowsBinding) uniform ShadowsBlock { ShadowUniforms shadows; };

// +x, -x, +y, -y, +z, -z.
int cubeFace(vec3 d) {
  vec3 a = abs(d);
  int axis = a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
  return 2 * axis + (d[axis] < 0.0 ? 1 : 0);
}

// 0 in shadow, 1 in light. N: of the surface; occlusion: the environment's, which a map knows better of its sun.
float reachingShare(LightUniforms light, vec3 position, vec3 N, vec3 L, float occlusion) {
  int first = int(abs(light.cone.z)) - 1;
  if (first < 0) return isSun(light) ? occlusion : 1.0;
  bool far = light.position.w < 0.5 || light.position.w > 2.5, cube = light.cone.z < 0.0;
  // A texel and a half away from the surface and one towards the light: a surface does not hide itself.
  float texel = light.cone.w * (far ? 1.0 : length(light.position.xyz - position));
  float NoL = dot(N, L);
  vec3 from = position + texel * (1.5 * sqrt(max(1.0 - NoL * NoL, 0.0)) * (NoL < 0.0 ? -N : N) + L);
  int layer = first + (cube ? cubeFace(from - light.position.xyz) : 0);
  vec4 clip = shadows.clipFromWorld[layer] * vec4(from, 1.0);
  return texture(shadowMaps, vec4(0.5 * clip.xy / clip.w + 0.5, float(layer), clip.z / clip.w));
}
