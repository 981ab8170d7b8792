// Where the radiance of paths goes that correct a drawn picture: to what smoothing makes of it.
#include "difference_images.glsl"

// Radiance that reaches the pixel, by broad lobes of the first surface to that share.
void gather(inout PathState p, vec3 radiance, float broad) { addLight(p, returnedLayer, radiance, broad); }
void gatherLight(inout PathState p, vec3 radiance, float broad, bool first) {
  addLight(p, first ? visibleLayer : returnedLayer, radiance, broad);
}
