// Where the light of paths goes that begin at the floor: sums of a texel, in layers.
layout(binding = 0, rgba32f) uniform image2DArray groundSums;  // layers: ground sums of layout.h

void addToGround(PathState p, int layer, vec3 light) {
  ivec3 at = ivec3(ivec2(pathPixel(p)), layer);
  imageStore(groundSums, at, imageLoad(groundSums, at) + pathsShared.share * vec4(light, 0.0));
}
void gather(inout PathState p, vec3 radiance, float broad) { addToGround(p, groundReturnedSum, radiance); }
void gatherLight(inout PathState p, vec3 radiance, float broad, bool first) {
  addToGround(p, first ? groundVisibleSum : groundReturnedSum, radiance);
}
