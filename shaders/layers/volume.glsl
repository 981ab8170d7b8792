// KHR_materials_volume: a body behind the surface.
#include "material.glsl"
#include "transmission.glsl"

// Metres of the world; 0: thin walls.
float materialThickness(Varyings v) { return material.thicknessFactor * v.scale * thicknessTexel(v).g; }

// From where light enters to where it leaves.
vec3 bodyRay(vec3 V, vec3 N, float ior, float thickness) { return refractedDirection(V, N, ior) * thickness; }

vec3 leftAfter(float distance) {
  return volumeTransmittance(material.attenuationColor, material.inverseAttenuationDistance, distance);
}
