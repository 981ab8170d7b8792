// Radiance of a lit surface towards the viewer.
#include "lit_surface.glsl"
#include "punctual_light.glsl" if HAS_PUNCTUAL_LIGHTS
#if defined(HAS_ENVIRONMENT) && defined(IMAGE_LIGHT_SAMPLES)
#include "image_light_sampled.glsl"
#else
#include "image_light.glsl" if HAS_ENVIRONMENT
#endif
#include "transmitted_light.glsl" if HAS_TRANSMISSION
#include "diffuse_transmitted_light.glsl" if HAS_DIFFUSE_TRANSMISSION

// rgb radiance, a coverage: 1 but where nothing is behind what transmits.
vec4 litRadiance(Varyings v, vec3 V, vec3 baseColor) {
  LitSurface lit = litSurface(v, V, baseColor);
  Surface s = lit.s;
  vec3 emission = emittedPart(materialEmission(v)) * coatLeft(s);  // it lies below the coat (KHR_materials_clearcoat)
  vec3 radiance = emission + lightsPart(punctualLight(s, v.position)) + imageLight(s);
  radiance += diffuseTransmittedLight(s, v, lit.scattered);
  float coverage = addTransmittedLight(s, v, lit.transmitted, radiance);
  return vec4(radiance, coverage);
}

// Where the surface itself is only blended in.
vec4 unblended(vec2 pixel, float coverage) { return behindSharp(pixel) * (1.0 - coverage); }
