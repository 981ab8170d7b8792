// What hides the environment from a pixel's surface, as far as the depth buffer tells (passes/horizons.frag.glsl).
#include "frame.glsl"
#include "horizons.glsl"

layout(binding = horizonsUnit) uniform sampler2D horizons;  // r open share, g distance along the view's axis / screen.z, up to farthestHorizon

// From the four texels around the pixel, those at the surface's own distance.
float openShare() {
  vec2 size = vec2(textureSize(horizons, 0)), at = (gl_FragCoord.xy + vec2(0.0, frame.picture.z)) * frame.screen.xy - 0.5;
  vec2 first = floor(at), part = at - first, gathered = (first + 1.0) / size;
  vec4 open = textureGather(horizons, gathered, 0), distances = textureGather(horizons, gathered, 1);
  vec4 weights = vec4(part.y, part.y, 1.0 - part.y, 1.0 - part.y) * vec4(1.0 - part.x, part.x, part.x, 1.0 - part.x);
  float distance = min(distanceFromDepth(gl_FragCoord.z) / frame.screen.z, farthestHorizon);
  weights *= 1.0 / (1e-3 + abs(distances / distance - 1.0));
  return dot(open, weights) / dot(weights, vec4(1.0));
}

// An occlusion texture tells of what is too fine for texels of the depth buffer; the product is nearer than the darker of
// both (src/frame/README.md).
float environmentShare(float textureShare) { return textureShare * openShare(); }

vec3 interreflected(float share, vec3 albedo) { return interreflection(share, albedo); }
