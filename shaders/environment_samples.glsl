// Samples of the environment: where they lie, and what they see. Lamps (src/ibl/lamps.hpp) get samples of their own
// beside those of each lobe, and the two are combined by the balance heuristic (Veach and Guibas 1995); of the rest a
// lobe's sample reads a level by the size of its share (filtered importance sampling, Krivanek and Colbert 2008).
#include "sequence.glsl"
#include "pixel_points.glsl"
#include "layout.h"
#include "constants.glsl"
#include "frame.glsl"
#include "mapping.glsl"

layout(binding = environmentRestUnit) uniform samplerCube environmentRest;
layout(binding = lampCubeUnit) uniform samplerCube lampCube;  // alpha: about the density of samples of the lamps [1/sr]
layout(binding = lampPointsUnit) uniform sampler2D lampPoints;

// Of its share of the lobe a sample reads so much: the levels' filter is already wider than a texel.
const float filterGain = 0.5;

bool sampledAtOnce() { return frame.options.z < 1.5; }

// Where this draw has all the pixel's samples they lie on a spiral, the same one at every pixel: no noise, at the price of
// an error that neighbours share. x: a turn, y: the square of a radius.
vec2 lightPoint(int i, uint use) {
  return sampledAtOnce() ? spiralPoint(i, IMAGE_LIGHT_SAMPLES).yx : samplePoint(i, use);
}

// Radiance from direction L as one of all the pixel's samples sees it that were drawn with that density [1/sr]; of the
// lamps the share that samples of the lobe have.
vec3 sampledRadiance(vec3 L, float density) {
  float faceSize = float(textureSize(environmentRest, 0).x);
  float texelSolidAngle = 4.0 * PI / (6.0 * faceSize * faceSize);
  float total = float(IMAGE_LIGHT_SAMPLES) * frame.options.z;
  float level = 0.5 * log2(max(filterGain / (total * density * texelSolidAngle), 1.0));
  vec3 d = environmentFromWorld(L);
  vec4 lamp = textureLod(lampCube, d, 0.0);
  return textureLod(environmentRest, d, level).rgb + lamp.rgb * (density / (density + lamp.a));
}

// A sample of the lamps counts by value (radiance / (density + the lobe's density)): as much as all of them with one for
// each of the lobe's.
struct LampSample {
  vec3 L;          // in the world
  float density;
  vec3 radiance;
};

bool lampsThere() { return textureSize(lampPoints, 0).x > 1; }

// Within each of the curve's shares x goes on along the texel's columns, y along its rows. The density by which samples
// are combined is the interpolated one, which any direction can look up.
LampSample sampleLamps(int i, uint use) {
  vec2 u = lightPoint(i, use + lampPointsOf).yx;
  ivec2 tableSize = textureSize(lampPoints, 0);
  float place = u.x * float(tableSize.x * tableSize.y);
  int point = int(place), size = textureSize(lampCube, 0).x;
  vec2 entry = texelFetch(lampPoints, ivec2(point % tableSize.x, point / tableSize.x), 0).xy;
  int texel = int(entry.x);
  vec2 st = (vec2(texel % size, texel / size % size) + vec2(fract(place), u.y)) * (2.0 / float(size)) - 1.0;
  vec3 d = normalize(directionFromCube(texel / (size * size), st));
  vec4 seen = textureLod(lampCube, d, 0.0);
  float density = entry.y / cubeSolidAngleDensity(st);
  return LampSample(worldFromEnvironment(d), seen.a, seen.rgb * (seen.a / density));
}
