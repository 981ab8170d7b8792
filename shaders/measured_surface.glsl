// A point of a surface whose BRDF was measured: of the table, or of the model that was fitted to it; and the lobe that was
// fitted to draw samples from (src/optics/measured_proxy.hpp).
#ifdef FITTED_BRDF
#include "measured_fitted.glsl"
#else
#include "measured_table.glsl"
#endif
#include "measured_sampling.glsl"
#include "mapping.glsl"

// V in the frame around the normal.
struct MeasuredSurface {
  mat3 worldFromLocal;
  vec3 V;
  float occlusion;
};

// UTIA's azimuths begin at the tangent; where there is none, at the direction along N that is level in the world.
mat3 measuredFrame(vec3 N, vec4 tangent) {
#ifdef UTIA_BRDF
#ifdef HAS_TANGENT
  vec3 T = tangent.xyz - dot(tangent.xyz, N) * N;
  float side = tangent.w < 0.0 ? -1.0 : 1.0;
#else
  vec3 T = vec3(N.z, 0.0, -N.x);
  float side = 1.0;
#endif
  if (dot(T, T) > 1e-12) {
    T = normalize(T);
    return mat3(T, side * cross(N, T), N);
  }
#endif
  return frameAround(N);
}

MeasuredSurface makeMeasuredSurface(vec3 N, vec4 tangent, vec3 V, float occlusion) {
  mat3 worldFromLocal = measuredFrame(N, tangent);
  vec3 local = V * worldFromLocal;
  return MeasuredSurface(worldFromLocal, normalize(vec3(local.xy, max(local.z, minNoV))), occlusion);
}
