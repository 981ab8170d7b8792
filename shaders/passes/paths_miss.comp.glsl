// Paths that leave the scene.
#include "path_class.glsl"
#include "path_environment.glsl" if HAS_ENVIRONMENT
#ifdef BACKGROUND_BLUR
#include "blurred_background.glsl"
#endif
#include "ground_seen.glsl" if GROUND_SEEN

layout(local_size_x = groupInvocations) in;

#ifdef HAS_ENVIRONMENT
vec3 radianceFromAfar(PathState p) {
#ifdef BACKGROUND_BLUR
  if (p.direction.w <= 0.0) return backgroundRadiance(p.direction.xyz);  // path_through.glsl
#endif
  return environmentRadiance(p.direction.xyz);
}
#endif

void main() {
  uint path;
  if (!pathOfClass(gl_GlobalInvocationID.x, path)) return;
  PathState p = paths[path];
  bool camera = p.direction.w == 0.0;
#if defined(BACKGROUND) && !defined(DIFFERENCE)
  const bool seen = true;
#else
  const bool seen = false;
#endif
  if (camera && !seen) p.radiance.a = 0.0;
  vec3 share = vec3(1.0);
  if (camera) seeGround(p, seen, share);
#ifdef HAS_ENVIRONMENT
  if (p.onMiss.w > 0.0) {
    gather(p, p.onMiss.rgb, p.throughput.w);
  } else if (!camera || seen) {
    float weight = camera ? 1.0 : drawnWeight(abs(p.direction.w), lightChance * environmentDensity(p.direction.xyz));
    gatherLight(p, p.throughput.rgb * radianceFromAfar(p) * share * weight, p.throughput.w, p.vertices == 1u);
  }
#endif
  paths[path].radiance = p.radiance;
}
