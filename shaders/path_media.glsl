// Bodies that a path is in, by the numbers of their materials, the innermost first (PathState.media).
#include "layout.h"
#include "transmission.glsl"

const uint mostMedia = 255u;  // materials beyond do not absorb

uint enterMedium(uint media, uint material) { return media << 8 | min(material + 1u, mostMedia); }

// The body that is left need not be the innermost.
uint leaveMedium(uint media, uint material) {
  uint number = min(material + 1u, mostMedia);
  for (uint shift = 0u; shift < 32u; shift += 8u)
    if (((media >> shift) & 0xffu) == number) {
      uint inner = media & ((1u << shift) - 1u);
      return (shift < 24u ? (media >> (shift + 8u)) << shift : 0u) | inner;
    }
  return media;
}

// Index of refraction around the path.
float mediumIor(uint media) {
  uint number = media & 0xffu;
  return number == 0u || number == mostMedia ? 1.0 : sceneMaterials[number - 1u].ior;
}

// What is left of the light after that distance [m].
vec3 mediumTransmittance(uint media, float distance) {
  uint number = media & 0xffu;
  if (number == 0u || number == mostMedia) return vec3(1.0);
  MaterialUniforms m = sceneMaterials[number - 1u];
  return volumeTransmittance(m.attenuationColor, m.inverseAttenuationDistance, distance);
}
