// Between the passes: how many work groups the next ones get. STEP 0: before the rays, 1: what they meet is counted,
// 2: surfaces are shaded.
#include "paths.glsl"

layout(local_size_x = 1) in;
layout(std430, binding = pathGroupsBinding) writeonly buffer GroupsBlock { uint groups[]; };

void setGroups(uint which, uint count) {
  groups[3u * which] = (count + uint(groupInvocations) - 1u) / uint(groupInvocations);
  groups[3u * which + 1u] = 1u;
  groups[3u * which + 2u] = 1u;
}

void countRays(uint count) {
  uint carry;
  work[workRays] = uaddCarry(work[workRays], count, carry);
  work[workRays + 1u] += carry;
}

void main() {
#if STEP == 0
  work[workActive] = work[workNext];
  work[workTurn] += 1u;
  work[workNext] = 0u;
  work[workLights] = 0u;
  for (uint i = 0u; i < pathsShared.classes; ++i) work[workClasses + 3u * i] = 0u;
  setGroups(groupsActive, work[workActive]);
  countRays(work[workActive]);
#elif STEP == 1
  uint first = 0u;
  for (uint i = 0u; i < pathsShared.classes; ++i) {
    uint at = workClasses + 3u * i;
    work[at + 1u] = first;
    work[at + 2u] = 0u;
    first += work[at];
    setGroups(groupsClasses + i, work[at]);
  }
#else
  setGroups(groupsLights, work[workLights]);
  countRays(work[workLights]);
#endif
}
