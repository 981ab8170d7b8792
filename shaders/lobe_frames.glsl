// The frames that a surface's lobes are sampled in.
#include "bsdf.glsl"
#include "mapping.glsl"

struct LobeFrame {
  mat3 worldFromLocal;
  vec3 V;  // in it, minNoV above the horizon at least
};

LobeFrame lobeFrame(mat3 worldFromLocal, vec3 V) {
  vec3 local = V * worldFromLocal;
  return LobeFrame(worldFromLocal, normalize(vec3(local.xy, max(local.z, minNoV))));
}
LobeFrame normalFrame(Surface s) { return lobeFrame(frameAround(s.N), s.V); }

#ifdef HAS_ANISOTROPY
LobeFrame baseFrame(Surface s) { return lobeFrame(mat3(s.grain.T, s.grain.B, s.N), s.V); }
vec2 baseAlpha(Surface s, float least) { return max(s.grain.alpha, least); }
#else
LobeFrame baseFrame(Surface s) { return normalFrame(s); }
float baseAlpha(Surface s, float least) { return max(s.alpha, least); }
#endif
#ifdef HAS_CLEARCOAT
LobeFrame coatFrame(Surface s) { return lobeFrame(frameAround(s.coat.N), s.V); }
#endif
