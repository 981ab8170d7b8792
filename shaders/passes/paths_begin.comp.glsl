// A path for each pixel of some rows, from the camera.
#include "paths.glsl"
#include "frame.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x, columns = pathsShared.columns;
  if (i >= pathsShared.rows * columns) return;
  uvec2 pixel = uvec2(pathsShared.firstColumn + i % columns, pathsShared.firstRow + i / columns);
  PathState p = newPath(pixel);
#ifdef DIFFERENCE
  vec2 within = pathsShared.offset;
#else
  vec2 within = pathDraw(p, pixelPair);
#endif
  vec2 at = 2.0 * (vec2(pixel) + within) / frame.picture.xy - 1.0;
  vec3 direction = pathsShared.directions[0].xyz + at.x * pathsShared.directions[1].xyz + at.y * pathsShared.directions[2].xyz;
  float along = length(direction);
  p.origin = vec4(pathsShared.origins[0].xyz + at.x * pathsShared.origins[1].xyz + at.y * pathsShared.origins[2].xyz, pathsShared.origins[0].w * along);
  p.direction = vec4(direction / along, 0.0);
  paths[i] = p;
  work[listAt(nextList(), i)] = i;
}
