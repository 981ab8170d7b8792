// A lobe as a sum of IMAGE_LIGHT_MODEL - 3 lobes of the LD chain, fitted by tools/fit_taps.cpp: each with its tilt (as
// meanDirection's), perceptual roughness and weight. The table lies as the DFG table, a block of rows for each tap.
layout(binding = tapsUnit) uniform sampler2D tapsTable;

const int tapCount = IMAGE_LIGHT_MODEL - 3;

vec3 lookUpTap(int tap, float NoV, float perceptualRoughness) {
  float last = float(tapsTableSize - 1);
  vec2 texel = vec2(sqrt(clamp(NoV, 0.0, 1.0)), clamp(perceptualRoughness, 0.0, 1.0)) * last + 0.5;
  texel.y += float((tapCount * (tapCount - 1) / 2 + tap) * tapsTableSize);
  return textureLod(tapsTable, texel / vec2(textureSize(tapsTable, 0)), 0.0).xyz;
}

vec3 lobeRadiance(vec3 N, vec3 V, float NoV, float perceptualRoughness, vec3 dfg) {
  vec3 sum = vec3(0.0);
  float narrowest = 1.0;
  for (int i = 0; i < tapCount; ++i) {
    vec3 tap = lookUpTap(i, NoV, perceptualRoughness);
    sum += tap.z * fetchRoughLd(environmentFromWorld(meanDirection(N, V, tap.x)), tap.y);
    narrowest = min(narrowest, tap.y);
  }
  for (int i = narrowest < ldKnot(ldMirrorLayerCount) ? 0 : tapCount; i < tapCount; ++i) {
    vec3 tap = lookUpTap(i, NoV, perceptualRoughness);
    sum += tap.z * fetchMirrorLd(environmentFromWorld(meanDirection(N, V, tap.x)), tap.y);
  }
  return sum;
}
