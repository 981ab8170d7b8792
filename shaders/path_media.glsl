// Bodies that a path is in, by the numbers of their materials, the innermost first (PathState.media,
// outerMedia): eight at most.
#include "layout.h"
#include "transmission.glsl"

const uint mostMedia = 255u;  // materials beyond do not absorb

uvec2 enterMedium(uvec2 media, uint material) {
  return uvec2(media.x << 8 | min(material + 1u, mostMedia), media.y << 8 | media.x >> 24);
}

// The body that is left need not be the innermost.
uvec2 leaveMedium(uvec2 media, uint material) {
  uint number = min(material + 1u, mostMedia);
  for (int word = 0; word < 2; ++word)
    for (uint shift = 0u; shift < 32u; shift += 8u)
      if (((media[word] >> shift) & 0xffu) == number) {
        uint inner = media[word] & ((1u << shift) - 1u);
        media[word] = (shift < 24u ? (media[word] >> (shift + 8u)) << shift : 0u) | inner;
        if (word == 0) media = uvec2(media.x | media.y << 24, media.y >> 8);
        return media;
      }
  return media;
}

// Index of refraction around the path.
float mediumIor(uvec2 media) {
  uint number = media.x & 0xffu;
  return number == 0u || number == mostMedia ? 1.0 : sceneMaterials[number - 1u].ior;
}

// What is left of the light after that distance [m].
vec3 mediumTransmittance(uvec2 media, float distance) {
  uint number = media.x & 0xffu;
  if (number == 0u || number == mostMedia) return vec3(1.0);
  MaterialUniforms m = sceneMaterials[number - 1u];
  return volumeTransmittance(m.attenuationColor, m.inverseAttenuationDistance, distance);
}

uvec2 mediaOf(PathState p) { return uvec2(p.media, p.outerMedia); }
