// A path for each pixel of some rows, from the camera.
#include "paths.glsl"
#include "frame.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x, width = uint(frame.picture.x);
  if (i >= pathsShared.rows * width) return;
  uvec2 pixel = uvec2(i % width, pathsShared.firstRow + i / width);
  PathState p;
  p.pixel = pixel.x | pixel.y << 16;
  p.vertices = 0u;
  vec2 at = 2.0 * (vec2(pixel) + pathDraw(p, pixelPair)) / frame.picture.xy - 1.0;
  vec3 direction = pathsShared.directions[0].xyz + at.x * pathsShared.directions[1].xyz + at.y * pathsShared.directions[2].xyz;
  float along = length(direction);
  p.origin = vec4(pathsShared.origins[0].xyz + at.x * pathsShared.origins[1].xyz + at.y * pathsShared.origins[2].xyz, pathsShared.origins[0].w * along);
  p.direction = vec4(direction / along, 0.0);
  p.throughput = vec4(1.0);
  p.radiance = vec4(0.0, 0.0, 0.0, 1.0);
  p.lightOrigin = p.lightDirection = p.lightRadiance = vec4(0.0);
  p.triangle = p.instance = p.media = 0u;
  p.distance = 0.0;
  p.weights = vec2(0.0);
  paths[i] = p;
  work[listAt(nextList(), i)] = i;
}
