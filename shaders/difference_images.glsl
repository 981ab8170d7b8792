// What paths find where something may stand in the light's way, and what smoothing it goes by: sums over the samples of a
// pixel (frame/difference.hpp).
#include "layout.h"
#include "constants.h"
#include "frame.glsl"

layout(binding = 0, rgba16f) uniform image2DArray differenceSums;  // layers: difference layers of layout.h
layout(binding = 1, r32f) uniform image2D distanceSum;              // of the first surfaces from the camera [m]

ivec2 differenceTexel(PathState p) { return ivec2(pathPixel(p)) - ivec2(int(pathsShared.firstColumn), int(frame.picture.z)); }

void addToLayer(PathState p, int layer, vec4 value) {
  ivec3 at = ivec3(differenceTexel(p), layer);
  imageStore(differenceSums, at, clamp(imageLoad(differenceSums, at) + pathsShared.share * value, -maxHalf, maxHalf));
}

// By broad lobes to that share, by sharp ones for the rest.
void addLight(PathState p, int broadLayer, vec3 radiance, float broad) {
  addToLayer(p, broadLayer, vec4(broad * radiance, 0.0));
  addToLayer(p, broadLayer + 1, vec4((1.0 - broad) * radiance, 0.0));
}
