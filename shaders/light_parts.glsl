// Which part of its light a picture shows: LIGHT_PART is one of CHANNEL_*. The lights themselves are left out by who asks
// for the other ones (src/frame/choose.cpp); here lobes are told apart. All parts add up to the picture;
// CHANNEL_BACKGROUND is what none of these sends: what is behind all surfaces.
#include "choices.glsl"

// Of the base: light that its diffuse part and its lobe send.
vec3 diffusePart(vec3 light) {
#if LIGHT_PART == CHANNEL_LIGHTS_DIFFUSE || LIGHT_PART == CHANNEL_ENVIRONMENT_DIFFUSE || LIGHT_PART == CHANNEL_INTERREFLECTED
  return light;
#else
  return vec3(0.0);
#endif
}
vec3 specularPart(vec3 light) {
#if LIGHT_PART == CHANNEL_LIGHTS_SPECULAR || LIGHT_PART == CHANNEL_ENVIRONMENT_SPECULAR || LIGHT_PART == CHANNEL_INTERREFLECTED
  return light;
#else
  return vec3(0.0);
#endif
}
// Of layers above it, and of light that comes through: with its lobe, and with its diffuse part.
vec3 layerPart(vec3 light) {
#if LIGHT_PART == CHANNEL_LIGHTS_SPECULAR || LIGHT_PART == CHANNEL_ENVIRONMENT_SPECULAR
  return light;
#else
  return vec3(0.0);
#endif
}
vec3 scatteredPart(vec3 light) {
#if LIGHT_PART == CHANNEL_LIGHTS_DIFFUSE || LIGHT_PART == CHANNEL_ENVIRONMENT_DIFFUSE
  return light;
#else
  return vec3(0.0);
#endif
}
// What shines by itself.
vec3 emittedPart(vec3 light) {
#if LIGHT_PART == CHANNEL_EMITTED
  return light;
#else
  return vec3(0.0);
#endif
}
// Of points, spots and suns.
vec3 lightsPart(vec3 light) {
#if LIGHT_PART == CHANNEL_INTERREFLECTED
  return vec3(0.0);
#else
  return light;
#endif
}
// gain: what surfaces near by make of the environment's light.
vec3 interreflectedPart(vec3 gain) {
#if LIGHT_PART == CHANNEL_INTERREFLECTED
  return gain - 1.0;
#else
  return vec3(1.0);
#endif
}
