// The paths that have met a surface of one class, or nothing.
#include "paths.glsl"

layout(location = pathsClassLocation) uniform uint pathsClass;

// False: there is no such path.
bool pathOfClass(uint i, out uint path) {
  uint at = workClasses + 3u * pathsClass;
  if (i >= work[at]) return false;
  path = work[listAt(sortedList, work[at + 1u] + i)];
  return true;
}
