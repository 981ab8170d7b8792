// Samples of the environment, for filtered importance sampling: where they lie, and what they see.
#include "sequence.glsl"
#include "layout.h"
#include "constants.glsl"
#include "frame.glsl"
#include "mapping.glsl"

layout(binding = environmentCubeUnit) uniform samplerCube environmentCube;

// A sample reads four times its share of the lobe, as Krivanek and Colbert advise: under a hard sun, texels of exactly its
// share nearly double the picture's error by noise; with sixteen times the share the blur begins to show.
const float filterGain = 4.0;

// Radiance from direction L as one of all the pixel's samples sees it.
vec3 sampledRadiance(vec3 L, float pdf, float gain) {
  float faceSize = float(textureSize(environmentCube, 0).x);
  float texelSolidAngle = 4.0 * PI / (6.0 * faceSize * faceSize);
  float total = float(IMAGE_LIGHT_SAMPLES) * frame.options.z;
  float level = 0.5 * log2(max(gain / (total * pdf * texelSolidAngle), 1.0));
  return textureLod(environmentCube, environmentFromWorld(L), level).rgb;
}
vec3 sampledRadiance(vec3 L, float pdf) { return sampledRadiance(L, pdf, filterGain); }
