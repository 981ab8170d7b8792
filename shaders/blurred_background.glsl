// The environment as it is seen behind the model: as a lobe of GGX sees it that looks along its normal (D(H) NoL, the kernel
// of the prefiltered layers). Of narrow lobes a share is seen in the map itself; the sun is a light of its own.
#include "frame.glsl"
#ifdef BACKGROUND_MAP
#include "environment_map.glsl"
#endif

layout(binding = blurredBackgroundUnit) uniform samplerCubeArray blurredBackground;

// optics::prefilterKernel about the sun, by the squared sine of half the angle, which distances of unit vectors hold
// where cosines have lost it.
vec3 blurredSun(vec3 d) {
  vec3 away = d - frame.blurredSun.xyz;
  float x = 0.25 * dot(away, away), alpha2 = frame.blurredSun.w;
  float lobe = alpha2 / mix(alpha2, 1.0, x);
  return frame.blurredSunRadiance.rgb * (lobe * lobe * max(1.0 - 2.0 * x, 0.0));
}

vec3 backgroundRadiance(vec3 world) {
  vec3 d = environmentFromWorld(world);
  float mapShare = frame.blurredSunRadiance.w;
  vec3 radiance = (1.0 - mapShare) * textureLod(blurredBackground, vec4(d, 0.0), 0.0).rgb * frame.environmentScale.x + blurredSun(d);
#ifdef BACKGROUND_MAP
  radiance += mapShare * mapRadiance(d);
#endif
  return radiance;
}
