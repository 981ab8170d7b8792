// What paths have found at the floor as shares of its unblocked light, smoothed over texels of similar shares.
#include "layout.h"
#include "luminance.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0) uniform sampler2DArray groundSums;
layout(binding = 0, rgba32f) writeonly uniform image2DArray groundShares;
layout(location = groundNoiseLocation) uniform vec4 parameters;  // x how far shares of visible light differ by chance, y all samples over those that are done

vec3 groundSum(ivec2 at, int layer) { return texelFetch(groundSums, ivec3(at, layer), 0).rgb; }
float visibleShare(ivec2 at) {
  float unblocked = luminance(groundSum(at, groundUnblockedSum));
  return unblocked > 0.0 ? luminance(groundSum(at, groundVisibleSum)) / unblocked : 1.0;
}

const int reach = 3;

// What is returned at most: a caustic that few paths have found in one texel is no light of its neighbours'.
float mostReturned(ivec2 at, ivec2 size) {
  float sum = 0.0, most = 0.0;
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      float returned = luminance(groundSum(clamp(at + ivec2(x, y), ivec2(0), size - 1), groundReturnedSum));
      sum += returned;
      most = max(most, returned);
    }
  float others = float((2 * reach + 1) * (2 * reach + 1) - 1);
  return 4.0 * (sum - most) / others;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = textureSize(groundSums, 0).xy;
  if (at.x >= size.x || at.y >= size.y) return;
  float here = visibleShare(at), total = 0.0, limit = mostReturned(at, size);
  vec3 visible = vec3(0.0), returned = vec3(0.0), unblocked = vec3(0.0);
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x) {
      ivec2 there = clamp(at + ivec2(x, y), ivec2(0), size - 1);
      float apart = (visibleShare(there) - here) / parameters.x;
      float weight = exp(-0.25 * float(x * x + y * y) - apart * apart);
      visible += weight * groundSum(there, groundVisibleSum);
      vec3 sent = groundSum(there, groundReturnedSum);
      returned += weight * sent * min(limit / max(luminance(sent), 1e-30), 1.0);
      unblocked += weight * groundSum(there, groundUnblockedSum);
      total += weight;
    }
  vec3 share = mix(vec3(1.0), (visible + returned) / max(unblocked, 1e-30), greaterThan(unblocked, vec3(0.0)));
  float cover = clamp(1.0 - luminance(share), 0.0, 1.0);
  vec3 added = max(share - (1.0 - cover), 0.0) * (0.5 * parameters.y * unblocked / total);
  imageStore(groundShares, ivec3(at, groundShareLayer), vec4(share, 1.0));
  imageStore(groundShares, ivec3(at, groundCoverLayer), vec4(added, cover));
}
