// Lights that surfaces see unless something is between.
#include "paths.glsl"
#include "rays.glsl"

layout(local_size_x = groupInvocations) in;

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= work[workLights]) return;
  uint path = work[listAt(lightsList, i)];
  holesSeed = ~pathRaySeed(paths[path]);
  RayHit hit = RayHit(rayNone, 0u, paths[path].lightOrigin.w, vec2(0.0));
  if (walkRay(paths[path].lightOrigin.xyz, paths[path].lightDirection, 0.0, true, false, hit)) return;
  PathState p = paths[path];
  gatherLight(p, p.lightRadiance.rgb, p.lightRadiance.w, work[workTurn] == 1u);
  paths[path].radiance = p.radiance;
}
