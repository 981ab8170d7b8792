// A level of the tree for passes/prefilter_cut.comp.glsl: nodes[level's offset + (face * size + y) * size + x] = mean
// radiance over the node's solid angle, and the mean square of its luminance.
#include "layout.h"
#include "luminance.glsl"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) readonly uniform imageCube cube;  // the finest level
layout(std430, binding = computeOutputBinding) buffer NodeBlock { vec4 nodes[]; };
layout(location = nodesSizeLocation) uniform int size;
layout(location = nodesOffsetLocation) uniform int offset;
layout(location = nodesFineOffsetLocation) uniform int fineOffset;  // below 0: from the cube

void main() {
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  int index = offset + (texel.z * size + texel.y) * size + texel.x;
  if (fineOffset < 0) {
    vec3 radiance = imageLoad(cube, texel).rgb;
    float y = luminance(radiance);
    nodes[index] = vec4(radiance, y * y);
    return;
  }
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = 0; i < 4; ++i) {
    ivec2 child = texel.xy * 2 + ivec2(i % 2, i / 2);
    float w = cubeTexelSolidAngle((vec2(child) + 0.5) / float(size) - 1.0, float(2 * size));
    sum += w * nodes[fineOffset + (texel.z * 2 * size + child.y) * 2 * size + child.x];
    weights += w;
  }
  nodes[index] = sum / weights;
}
