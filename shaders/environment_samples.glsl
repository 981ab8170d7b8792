// Samples of the environment, for filtered importance sampling: where they lie, and what they see.
#include "layout.h"
#include "constants.glsl"
#include "frame.glsl"
#include "mapping.glsl"

layout(binding = environmentCubeUnit) uniform samplerCube environmentCube;

// A sample reads four times its share of the lobe, as Krivanek and Colbert advise: under a hard sun, texels of exactly its
// share nearly double the picture's error by noise; with sixteen times the share the blur begins to show.
const float filterGain = 4.0;

// Every draw of the pixel continues the same sequence (Roberts 2018, R2), in 32-bit fixed point, where no count loses
// digits.
vec2 samplePoint(int i) {
  return vec2(uvec2(i) * uvec2(3242174889u, 2447445414u) + 0x80000000u) * (1.0 / 4294967296.0);
}

// Radiance from direction L as one of all the pixel's samples sees it.
vec3 sampledRadiance(vec3 L, float pdf) {
  float faceSize = float(textureSize(environmentCube, 0).x);
  float texelSolidAngle = 4.0 * PI / (6.0 * faceSize * faceSize);
  float total = float(IMAGE_LIGHT_SAMPLES) * frame.options.z;
  float level = 0.5 * log2(max(filterGain / (total * pdf * texelSolidAngle), 1.0));
  return textureLod(environmentCube, environmentFromWorld(L), level).rgb;
}
