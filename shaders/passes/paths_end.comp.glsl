// What the paths of some rows have brought, onto the picture's sum.
#include "paths.glsl"
#include "frame.glsl"

layout(local_size_x = groupInvocations) in;
layout(binding = 0, rgba32f) uniform image2D sum;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= pathsShared.rows * pathsShared.columns) return;
  ivec2 at = ivec2(pathPixel(paths[i])) - ivec2(0, int(frame.picture.z));
  imageStore(sum, at, imageLoad(sum, at) + pathsShared.share * paths[i].radiance * vec4(vec3(frame.stored.x), 1.0));
}
