// The paths under way and the lists of them (paths.h).
#include "paths.h"
#include "layout.h"
#include "frame.glsl"
#include "sobol.glsl"

layout(std430, binding = computeInputBinding) buffer PathsBlock { PathState paths[]; };
layout(std430, binding = computeOutputBinding) buffer WorkBlock { uint work[]; };

layout(std140, binding = pathsBinding) uniform PathUniformsBlock { PathUniforms pathsShared; };

uint listAt(uint list, uint i) { return workClasses + 3u * pathsShared.classes + list * pathsShared.paths + i; }
uint activeList() { return work[workTurn] & 1u; }
uint nextList() { return 1u - activeList(); }
// Kinds of light, one of which a surface looks at, in this order: the environment, the punctual lights, what glows.
#ifdef HAS_ENVIRONMENT
const int punctualKind = 1;
#else
const int punctualKind = 0;
#endif
#ifdef HAS_PUNCTUAL_LIGHTS
const int glowingKind = punctualKind + 1;
#else
const int glowingKind = punctualKind;
#endif
#ifdef GLOWING
const int lightKinds = glowingKind + 1;
#else
const int lightKinds = glowingKind;
#endif
const float lightChance = 1.0 / float(max(lightKinds, 1));  // of each
// Veach 1997, the power heuristic: weight of what was drawn with `density` where the other could have drawn it, too.
float drawnWeight(float density, float other) {
  float ratio = other / density;
  return density > 0.0 ? 1.0 / (1.0 + ratio * ratio) : 0.0;
}
const uint sortedList = 2u, lightsList = 3u;

// One that has neither met nor gathered anything.
PathState newPath(uvec2 pixel) {
  PathState p;
  p.pixel = pixel.x | pixel.y << 16;
  p.origin = p.direction = vec4(0.0);
  p.throughput = vec4(1.0);
  p.radiance = vec4(0.0, 0.0, 0.0, 1.0);
  p.lightOrigin = p.lightRadiance = p.onMiss = vec4(0.0);
  p.lightDirection = vec3(0.0);
  p.triangle = p.instance = p.vertices = p.media = p.outerMedia = 0u;
  p.distance = 0.0;
  p.weights = vec2(0.0);
  return p;
}
uvec2 pathPixel(PathState p) { return uvec2(p.pixel & 0xffffu, p.pixel >> 16); }

// Pairs of numbers in (0, 1)^2 that a sample of a pixel uses: first the pixel's, then four for each surface that is met.
const uint pixelPair = 0u, lightPair = 1u, lobePair = 2u, choicePair = 3u, lightChoicePair = 4u, pairsOfVertex = 4u;
const uint pathsUse = 0x70617468u;
uint pathSeed(PathState p) { return pixelSeed(pathPixel(p), pathsUse ^ uint(frame.options.w)); }
vec2 pathDraw(PathState p, uint pair) {
  return owenSobol2(pathsShared.number, pair + (pair == pixelPair ? 0u : p.vertices * pairsOfVertex), pathSeed(p));
}

// Of what stops a ray by chance.
uint pathRaySeed(PathState p) {
  return hashedBits(p.pixel ^ hashedBits(pathsShared.number ^ hashedBits((p.vertices + 0x72617973u) ^ (uint(frame.options.w) << 8))));
}

#include "paths_sum.glsl" if DIFFERENCE
