// Paths from the camera that have only passed through surfaces see the background as it is seen beside these.
#include "blurred_background.glsl"

// Such paths carry the density of their direction as a negative number.
float passingDensity(PathState p, PathSurface at, vec3 L, float density) {
  bool passes = p.direction.w <= 0.0 && dot(at.Ng, p.direction.xyz) * dot(at.Ng, L) > 0.0;
  return passes ? -density : density;
}
vec3 radianceFromAfar(PathState p, PathSurface at, vec3 L) {
  return passingDensity(p, at, L, 1.0) < 0.0 ? backgroundRadiance(L) : environmentRadiance(L);
}
