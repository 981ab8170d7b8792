// What paths find where something may stand in the light's way, and what smoothing it goes by: sums over the samples of a
// pixel (frame/difference.hpp).
#include "layout.h"
#include "constants.h"
#include "frame.glsl"

#ifdef PRECISE
layout(binding = 0, rgba32f)
#else
layout(binding = 0, rgba16f)
#endif
uniform image2DArray differenceSums;                                // layers: difference layers of layout.h
layout(binding = 1, r32f) uniform image2D distanceSum;              // of the first surfaces from the camera [m]

ivec2 differenceTexel(PathState p) { return ivec2(pathPixel(p)) - ivec2(int(pathsShared.firstColumn), int(frame.picture.z)); }

void addToLayer(PathState p, int layer, vec4 value) {
  ivec3 at = ivec3(differenceTexel(p), layer);
  imageStore(differenceSums, at, clamp(imageLoad(differenceSums, at) + pathsShared.share * value, -frame.stored.z, frame.stored.z));
}

void addLight(PathState p, int broadLayer, vec3 broad, vec3 sharp) {
  addToLayer(p, broadLayer, vec4(broad * frame.stored.x, 0.0));
  addToLayer(p, broadLayer + 1, vec4(sharp * frame.stored.x, 0.0));
}

// By broad lobes to that share, by sharp ones for the rest.
void addLight(PathState p, int broadLayer, vec3 radiance, float broad) { addLight(p, broadLayer, broad * radiance, (1.0 - broad) * radiance); }
