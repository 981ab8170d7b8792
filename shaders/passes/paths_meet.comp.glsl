// What the rays of all paths under way meet, and how many meet a surface of each class.
#include "paths.glsl"
#include "met_class.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= work[workActive]) return;
  uint path = work[listAt(activeList(), i)];
  holesSeed = pathRaySeed(paths[path]);
  RayHit hit = RayHit(rayNone, 0u, 3e38, vec2(0.0));
  walkRay(paths[path].origin.xyz, paths[path].direction.xyz, paths[path].origin.w, false, paths[path].direction.w == 0.0, hit);
  paths[path].triangle = hit.triangle;
  paths[path].instance = hit.instance;
  paths[path].distance = hit.distance;
  paths[path].weights = hit.weights;
  atomicAdd(work[workClasses + 3u * metClass(hit.triangle)], 1u);
}
