// A shading normal for paths. The twin is src/optics/bent_normal.cpp.

// N, bent towards the geometric normal Ng as far as V needs, dot(Ng, V) >= 0, to be mirrored to the outside: what leaned
// further would reflect light into the surface, where it is lost. All unit. As Cycles does (Blender's
// ensure_valid_specular_reflection), but in the plane of the mirror direction and Ng.
vec3 bentNormal(vec3 N, vec3 Ng, vec3 V) {
  vec3 R = 2.0 * dot(N, V) * N - V;
  float least = min(0.9 * dot(Ng, V), 0.01), above = dot(Ng, R);
  if (above >= least) return N;
  vec3 H = V + normalize(R + Ng * (least - above));
  float length2 = dot(H, H);
  return length2 > 1e-12 ? H * inversesqrt(length2) : Ng;
}
