// A floor that one sees only by what the scene does to the light on it (src/frame/ground.hpp).
#include "frame.glsl"

layout(binding = groundUnit) uniform sampler2DArray groundShares;  // layers: ground layers of layout.h

const float groundFade = 0.25;  // share of the way from the middle to the edge over which the floor fades

vec2 groundUv(vec2 xz) { return 0.5 + 0.5 * (xz - frame.ground.xz) / frame.ground.w; }
float groundStrength(vec2 uv) {
  vec2 outwards = abs(2.0 * uv - 1.0);
  return 1.0 - smoothstep(1.0 - groundFade, 1.0, max(outwards.x, outwards.y));
}

// Share of the unblocked light that arrives, and is returned by the scene: what is seen behind a Lambertian floor's point is
// multiplied by it, as its albedo is unknown (Debevec 1998, differential rendering, as a ratio).
vec3 groundShare(vec2 uv) { return mix(vec3(1.0), texture(groundShares, vec3(uv, groundShareLayer)).rgb, groundStrength(uv)); }
// The same over a background that is not known: coverage by the shadow, and what the scene adds to a floor of albedo 0.5 [radiance].
vec4 groundCover(vec2 uv) { return texture(groundShares, vec3(uv, groundCoverLayer)) * groundStrength(uv); }

// Where a ray from above meets it, distance along direction; below 0: nowhere.
float groundDistance(vec3 origin, vec3 direction) {
  float above = origin.y - frame.ground.y;
  if (!(above > 0.0 && direction.y < 0.0)) return -1.0;
  float distance = above / -direction.y;
  vec2 from = abs(origin.xz + distance * direction.xz - frame.ground.xz);
  return max(from.x, from.y) < frame.ground.w ? distance : -1.0;
}
