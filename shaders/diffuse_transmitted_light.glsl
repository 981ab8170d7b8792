// KHR_materials_diffuse_transmission: light that enters beyond the surface and leaves on this side, scattered.
#include "transmission.glsl"
#include "bsdf.glsl"

// share: of the light that enters, rgb. thickness in metres: the way through the body, 0: thin walls.
vec3 diffuseTransmittedLight(Surface s, vec3 position, vec3 share, float thickness) {
  vec3 radiance = vec3(0.0);
#ifdef HAS_PUNCTUAL_LIGHTS
  for (int i = 0; i < lights.length(); ++i) {
    vec3 L;
    vec3 arriving = arrivingLight(lights[i], position, -s.N, L);
    radiance += arriving * (max(-dot(s.N, L), 0.0) / PI);
  }
#endif
#ifdef HAS_ENVIRONMENT
  radiance += textureLod(irradianceOverPi, environmentFromWorld(-s.N), 0.0).rgb * (frame.environmentScale.x * s.occlusion);
#endif
#ifdef HAS_DFG
  share *= enteringShare(s);
#endif
#ifdef HAS_VOLUME
  share *= volumeTransmittance(material.attenuation.rgb, material.attenuation.w, thickness);
#endif
  return share * radiance;
}
