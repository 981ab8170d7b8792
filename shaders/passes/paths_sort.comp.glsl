// The paths under way in the order of what they have met.
#include "paths.glsl"
#include "rays.glsl"
#include "scene_primitives.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= work[workActive]) return;
  uint path = work[listAt(activeList(), i)], triangle = paths[path].triangle, met = missClass;
  if (triangle != rayNone) met = scenePrimitives[rayTriangle(triangle).primitive & rayPrimitiveMask].shading;
  uint at = workClasses + 3u * met;
  work[listAt(sortedList, work[at + 1u] + atomicAdd(work[at + 2u], 1u))] = path;
}
