// Directional albedo E of the sheen lobe over u = sqrt(NoX), v = perceptual sheen roughness, texel centres at the end
// points 0 and 1: passes/sheen_albedo.comp.glsl. Unclamped: above 1 where the lobe itself gains (optics/sheen.hpp).
#include "layout.h"
#include "layers/sheen.glsl"

layout(binding = sheenAlbedoUnit) uniform sampler2D sheenAlbedoTable;

float lookUpSheenAlbedo(float NoX, float perceptualRoughness) {
  vec2 size = vec2(textureSize(sheenAlbedoTable, 0));
  vec2 uv = vec2(sqrt(clamp(NoX, 0.0, 1.0)), clamp(perceptualRoughness, 0.0, 1.0));
  return textureLod(sheenAlbedoTable, (uv * (size - 1.0) + 0.5) / size, 0.0).r;
}

// Where a light is to be evaluated.
void lightSheen(inout Sheen sheen, float NoL) {
  sheen.albedoL = lookUpSheenAlbedo(NoL, sheen.perceptualRoughness);
}
