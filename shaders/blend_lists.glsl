// What covers a pixel of surfaces that are blended: a list, put in order when all of it is there (Yang et al. 2010).
#include "blend_lists.h"

struct BlendNode {
  vec4 color;     // as outColor has it
  float depth;    // 1 near, 0 far
  uint order;     // of draws, then primitives: what lies at one depth
  uint next;      // noBlendNode: it is the last one
  uint coverage;  // of samples, a bit each
};
const uint noBlendNode = 0xffffffffu;

// All are noBlendNode at first, so that the first node's number is that plus 1.
layout(std430, binding = blendHeadsBinding) coherent buffer BlendHeadsBlock {
  uint lastBlendNode;
  uint blendHeads[];
};
layout(std430, binding = blendNodesBinding) buffer BlendNodesBlock { BlendNode blendNodes[]; };

// pixel: of the target, whose rows have so many.
uint blendHead(ivec2 pixel, int width) { return uint(pixel.y * width + pixel.x); }

// Where there is no room it is counted alone.
void keepBlended(uint head, vec4 color, float depth, uint order, uint coverage) {
  uint node = atomicAdd(lastBlendNode, 1u) + 1u;
  if (node >= uint(blendNodes.length())) return;
  blendNodes[node] = BlendNode(color, depth, order, atomicExchange(blendHeads[head], node), coverage);
}

bool liesBefore(float depth, uint order, float other, uint otherOrder) {
  return depth > other || (depth == other && order > otherOrder);
}

// All that covers the sample over one another, the farthest first: through the list once for each of them. One loop, since
// Mesa 22.3's software OpenGL ends one within another too early where the lists of neighbours differ.
vec4 blendedAt(uint head, uint sampleBit) {
  vec4 sum = vec4(0.0), best = vec4(0.0);
  float depth = -1.0, bestDepth = 2.0;
  uint order = 0u, bestOrder = 0u, i = blendHeads[head];
  bool done = i == noBlendNode, found = false;
  while (!done) {
    BlendNode node = blendNodes[i];
    bool take = (node.coverage & sampleBit) != 0u && liesBefore(node.depth, node.order, depth, order) &&
                (!found || liesBefore(bestDepth, bestOrder, node.depth, node.order));
    best = take ? node.color : best;
    bestDepth = take ? node.depth : bestDepth;
    bestOrder = take ? node.order : bestOrder;
    found = found || take;
    i = node.next;
    bool end = i == noBlendNode;
    sum = end && found ? best + sum * (1.0 - best.a) : sum;
    depth = end ? bestDepth : depth;
    order = end ? bestOrder : order;
    done = end && !found;
    found = found && !end;
    i = end ? blendHeads[head] : i;
  }
  return sum;
}
