// The DFG table over u = sqrt(NoV), v = perceptual roughness, texel centres at the end points 0 and 1: A in x, B in y,
// in z the sine of the angle from N to the lobe's mean direction over that of the mirror direction.
#include "layout.h"

layout(binding = dfgUnit) uniform sampler2D dfgTable;

vec3 lookUpDfg(float NoV, float perceptualRoughness) {
  vec2 size = vec2(textureSize(dfgTable, 0));
  vec2 uv = vec2(sqrt(clamp(NoV, 0.0, 1.0)), clamp(perceptualRoughness, 0.0, 1.0));
  return textureLod(dfgTable, (uv * (size - 1.0) + 0.5) / size, 0.0).rgb;
}
