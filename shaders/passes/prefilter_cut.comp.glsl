// LD by a cut through the tree of passes/cut_nodes.comp.glsl: a node is taken as a whole where it is small against the
// scale on which the kernel D w varies there, and where what its radiance varies by (its standard deviation) times the
// kernel's change over it is below `tolerance` of the result. Both sums are over the same nodes: a constant map stays
// what it is. w = NoL, or G1(NoL) = G2 of N = V. The finest texels are divided further, with bilinear radiance, where
// the lobe is narrower.
#include "layout.h"
#include "luminance.glsl"
#include "mapping.glsl"
#include "microfacet.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform samplerCube environment;
layout(binding = 0, rgba16f) writeonly uniform imageCubeArray layer;
layout(std430, binding = computeInputBinding) readonly buffer NodeBlock { vec4 nodes[]; };
layout(std430, binding = computeOutputBinding) buffer CountBlock { uint visits; };
layout(location = layerCubeLocation) uniform int cube;
layout(location = layerFirstFaceLocation) uniform int face;
layout(location = cutFirstRowLocation) uniform int firstRow;
layout(location = cutTreeSizeLocation) uniform int treeSize;     // faces of the finest level
layout(location = cutParametersLocation) uniform vec4 parameters;  // x alpha, y tolerance, z nodes across the kernel's scale, w 1: by G2

const int rootSize = 4;
const int steps = 4;  // parts of a finest texel along each axis

struct Sum {
  vec3 radiance;
  float weight;
  uint visits;  // of nodes whose radiance is read
};

// x = sin^2 of half the angle between N and L; N = V.
float kernel(float x) {
  float alpha = parameters.x, NoL = 1.0 - 2.0 * x;
  float k = alpha / (x + alpha * alpha * (1.0 - x));
  return NoL > 0.0 ? k * k * (parameters.w > 0.0 ? G1_GGX(NoL, alpha) : NoL) : 0.0;
}

float halfSine2(vec3 N, vec3 L) {
  vec3 chord = L - N;
  return 0.25 * dot(chord, chord);
}

void pushChildren(inout uint stack[32], inout int top, uint node, ivec2 at) {
  uint child = (node & 7u << 20) | uint(2 * at.x) | uint(2 * at.y) << 10 | (node >> 23) + 1u << 23;
  stack[top++] = child;
  stack[top++] = child + 1u;
  stack[top++] = child + 1024u;
  stack[top++] = child + 1025u;
}

// limit: of a node's error, in the units of sum.radiance; below 0: none.
void addCut(vec3 N, int root, float limit, float across, inout Sum sum) {
  float alpha = parameters.x;
  uint stack[32];
  int top = 0;
  // 10 bits for column and row each, 3 for the face, the rest for log2(size).
  stack[top++] = uint(root % rootSize) | uint(root / rootSize % rootSize) << 10 |
                 uint(root / (rootSize * rootSize)) << 20 | 2u << 23;
  while (top > 0) {
    uint node = stack[--top];
    ivec2 at = ivec2(node & 1023u, node >> 10 & 1023u);
    int nodeFace = int(node >> 20 & 7u), size = 1 << (node >> 23);
    vec2 st = (vec2(at) + 0.5) * (2.0 / float(size)) - 1.0;
    vec3 L = normalize(directionFromCube(nodeFace, st));
    float solidAngle = cubeTexelSolidAngle(st, float(size)), extent = sqrt(solidAngle);
    float radius = 0.8 * extent;
    if (dot(N, L) < -radius) continue;
    float x = halfSine2(N, L), near = max(sqrt(x) - 0.5 * radius, 0.0);
    float scale = 2.0 * sqrt(alpha * alpha + near * near);
    bool split = across * extent > scale;
    if (split && size < treeSize) {
      pushChildren(stack, top, node, at);
      continue;
    }
    ++sum.visits;
    vec4 value = nodes[8 * (treeSize * treeSize - size * size) + (nodeFace * size + at.y) * size + at.x];
    if (!split && limit >= 0.0) {
      float mean = luminance(value.rgb), deviation = sqrt(max(value.a - mean * mean, 0.0));
      split = deviation * solidAngle * kernel(near * near) * min(extent / scale, 1.0) > limit;
    }
    if (!split || (size == treeSize && across * extent <= scale)) {
      float weight = solidAngle * kernel(x);
      sum.radiance += weight * value.rgb;
      sum.weight += weight;
    } else if (size < treeSize) {
      pushChildren(stack, top, node, at);
    } else {
      sum.visits += uint(steps * steps);
      for (int i = 0; i < steps * steps; ++i) {
        vec2 part = st + ((vec2(i % steps, i / steps) + 0.5) / float(steps) - 0.5) * (2.0 / float(size));
        vec3 d = normalize(directionFromCube(nodeFace, part));
        float weight = solidAngle / float(steps * steps) * kernel(halfSine2(N, d));
        sum.radiance += weight * textureLod(environment, d, 0.0).rgb;
        sum.weight += weight;
      }
    }
  }
}

void main() {
  int size = imageSize(layer).x;
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, firstRow);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(face, (vec2(texel) + 0.5) * (2.0 / float(size)) - 1.0));
  const int roots = 6 * rootSize * rootSize;
  // A rough result, to tell what is small against it; not less than a hundredth of the map's mean.
  Sum rough = Sum(vec3(0.0), 0.0, 0u);
  float mean = 0.0;
  for (int whole = 0; whole < 6; ++whole) mean += luminance(nodes[8 * (treeSize * treeSize - 1) + whole].rgb) / 6.0;
  for (int root = 0; root < roots; ++root) addCut(N, root, -1.0, 0.7, rough);
  float limit = parameters.y * max(luminance(rough.radiance), 0.01 * mean * rough.weight);
  Sum sum = Sum(vec3(0.0), 0.0, 0u);
  for (int root = 0; root < roots; ++root) addCut(N, root, limit, parameters.z, sum);
  atomicAdd(visits, rough.visits + sum.visits + 6u);
  imageStore(layer, ivec3(texel, cube * 6 + face), vec4(min(sum.radiance / sum.weight, maxHalf), 1.0));
}
