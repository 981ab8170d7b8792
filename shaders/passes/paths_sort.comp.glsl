// The paths under way in the order of what they have met.
#include "paths.glsl"
#include "met_class.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= work[workActive]) return;
  uint path = work[listAt(activeList(), i)];
  uint at = workClasses + 3u * metClass(paths[path].triangle);
  work[listAt(sortedList, work[at + 1u] + atomicAdd(work[at + 2u], 1u))] = path;
}
