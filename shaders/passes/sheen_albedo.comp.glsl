// The sheen lobe's directional albedo (sheen_table.glsl): E = int D V NoL dL by quadrature. NoL = t^3, dense at the
// horizon, where the lobe is; half the azimuths, the other half mirrors it. nodes[i] = (position, weight) of
// Gauss-Legendre on [0, 1], first those of t, then those of the azimuth.
#include "layout.h"
#include "sheen.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, r32f) writeonly uniform image2D table;
layout(std430, binding = computeInputBinding) readonly buffer NodeBlock { vec2 nodes[]; };
layout(location = sheenHeightsLocation) uniform int heights;

void main() {
  ivec2 size = imageSize(table);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) return;
  vec2 uv = vec2(texel) / vec2(size - 1);
  float alpha = uv.y * uv.y;
  float NoV = clamp(uv.x * uv.x, minNoV, 1.0);
  float sinV = sqrt((1.0 - NoV) * (1.0 + NoV));
  float sum = 0.0;
  for (int i = 0; i < heights; ++i) {
    float t = nodes[i].x, NoL = t * t * t;
    float sinL = sqrt((1.0 - NoL) * (1.0 + NoL));
    float ring = 0.0;
    for (int j = heights; j < nodes.length(); ++j) {
      float length2 = 2.0 + 2.0 * (NoV * NoL + sinV * sinL * cos(PI * nodes[j].x));
      ring += nodes[j].y * D_Charlie((NoV + NoL) * inversesqrt(max(length2, 1e-20)), alpha);
    }
    sum += nodes[i].y * 3.0 * t * t * NoL * V_Charlie(NoV, NoL, alpha) * 2.0 * PI * ring;
  }
  imageStore(table, texel, vec4(sum, 0.0, 0.0, 0.0));
}
