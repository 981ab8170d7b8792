// Surfaces that glow as lights that paths look at: triangles of one emission, chosen by what they send out in all
// (frame/traced.hpp).
#include "rays.h"
#include "layout.h"
#include "luminance.glsl"

layout(binding = glowingUnit) uniform samplerBuffer glowingTriangles;

struct GlowPoint {
  vec3 position, facing, radiance;  // facing: unit
  float density;                    // [1/m^2]
};

// Of any point of a surface that is among them.
float glowDensity(vec3 radiance) { return luminance(radiance) * pathsShared.perGlow; }

// u in [0, 1)^2: x chooses the triangle by its share of all light, and what is left of it a place with y.
GlowPoint sampleGlow(vec2 u) {
  uint low = 0u, high = pathsShared.glowing - 1u;
  while (low < high) {
    uint middle = (low + high) / 2u;
    if (u.x < texelFetch(glowingTriangles, int(glowingTexels * middle)).w)
      high = middle;
    else
      low = middle + 1u;
  }
  int at = int(glowingTexels * low);
  vec4 corner = texelFetch(glowingTriangles, at);
  vec3 edge1 = texelFetch(glowingTriangles, at + 1).xyz, edge2 = texelFetch(glowingTriangles, at + 2).xyz;
  vec4 radiance = texelFetch(glowingTriangles, at + 3);
  float x = sqrt(clamp((u.x - corner.w + radiance.w) / radiance.w, 0.0, 1.0));
  vec3 facing = cross(edge1, edge2);
  float largest = max(abs(facing.x), max(abs(facing.y), abs(facing.z)));
  return GlowPoint(corner.xyz + x * (1.0 - u.y) * edge1 + x * u.y * edge2, normalize(facing / largest), radiance.rgb,
                   glowDensity(radiance.rgb));
}

// The density by solid angle of what is met from there.
float glowSolidAngleDensity(vec3 radiance, float distance, float cosine) {
  return glowDensity(radiance) * distance * distance / max(abs(cosine), 1e-6);
}
