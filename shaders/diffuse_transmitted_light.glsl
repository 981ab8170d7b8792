// KHR_materials_diffuse_transmission: light that enters beyond the surface and leaves on this side, scattered.
#include "bsdf.glsl"
#include "material.glsl"
#include "layers/scattering.glsl" if HAS_DIFFUSE_TRANSMISSION
#include "layers/volume.glsl" if HAS_VOLUME
#include "irradiance.glsl" if HAS_ENVIRONMENT

// transmitted: of all the light that enters.
vec3 diffuseTransmittedLight(Surface s, Varyings v, float transmitted) {
  vec3 share = transmitted * diffuseTransmittedColor(v);
  vec3 radiance = punctualIrradiance(-s.N, v.position);
  radiance += lookUpIrradiance(-s.N) * (frame.environmentScale.x * s.occlusion);
  share *= enteringShare(s);
  share *= leftAfter(materialThickness(v));
  return scatteredPart(share * radiance);
}
