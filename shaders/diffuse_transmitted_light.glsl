// KHR_materials_diffuse_transmission: light that enters beyond the surface and leaves on this side, scattered.
#include "bsdf.glsl"
#include "material.glsl"
#include "layers/volume.glsl" if HAS_VOLUME
#include "irradiance.glsl" if HAS_ENVIRONMENT

// Of the light that enters the dielectric and does not pass through, what is scattered out beyond.
float diffuseTransmittedShare(Varyings v) {
  return clamp(material.diffuseTransmissionFactor * diffuseTransmissionTexel(v).a, 0.0, 1.0);
}

// transmitted: of all the light that enters.
vec3 diffuseTransmittedLight(Surface s, Varyings v, float transmitted) {
  vec3 share = transmitted * (material.diffuseTransmissionColorFactor * diffuseTransmissionColorTexel(v).rgb);
  vec3 radiance = punctualIrradiance(-s.N, v.position);
  radiance += lookUpIrradiance(-s.N) * (frame.environmentScale.x * s.occlusion);
  share *= enteringShare(s);
  share *= leftAfter(materialThickness(v));
  return share * radiance;
}
