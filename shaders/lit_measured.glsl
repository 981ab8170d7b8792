// The measured BRDF in the material's place; what it emits stays.
#include "material.glsl"
#include "measured_light.glsl"
#include "horizon_occlusion.glsl" if HORIZONS
#include "light_parts.glsl" if LIGHT_PART

vec4 litRadiance(Varyings v, vec3 V, vec3 baseColor) {
  MeasuredSurface s = makeMeasuredSurface(materialNormal(v, V), v.tangent, V, environmentShare(materialOcclusion(v)));
  vec3 radiance = emittedPart(materialEmission(v));
#ifdef HAS_PUNCTUAL_LIGHTS
  radiance += layerPart(measuredPunctualLight(s, v.position));
#endif
#ifdef HAS_ENVIRONMENT
  radiance += layerPart(measuredImageLight(s));
#endif
  return vec4(radiance, 1.0);
}

vec4 unblended(vec2 pixel, float coverage) { return vec4(0.0); }
