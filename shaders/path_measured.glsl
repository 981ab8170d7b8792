// A measured BRDF, or the model that was fitted to it, as paths meet it: as path_bsdf.glsl has it for materials.
#include "material.glsl"
#include "measured_surface.glsl"

struct PathSample {
  vec3 L;
  float density;  // [1/sr]; 0: nothing was drawn
  bool broad;     // of a broad lobe
};

struct PathBsdf {
  MeasuredSurface s;
  vec3 Ng;
};

PathBsdf pathBsdf(inout PathState p, PathSurface at, vec3 baseColor, float choice) {
  vec3 V = -p.direction.xyz;
  return PathBsdf(makeMeasuredSurface(materialNormal(at.v, V), at.v.tangent, V, 1.0), at.Ng);
}

// f(V, L) NoL [1/sr].
vec3 evaluatePath(PathBsdf b, vec3 L) {
  vec3 local = L * b.s.worldFromLocal;
  if (local.z <= 0.0 || dot(b.Ng, L) <= 0.0) return vec3(0.0);
  return measuredBrdf(b.s.V, local) * local.z;
}
float pathDensity(PathBsdf b, vec3 L) {
  vec3 local = L * b.s.worldFromLocal;
  return local.z > 0.0 ? pdfProxy(measured.lobe, measured.table.x, b.s.V, local) : 0.0;
}
PathSample samplePath(PathBsdf b, vec3 u) {
  vec3 local = sampleProxy(measured.lobe, measured.table.x, b.s.V, u.xy);
  vec3 L = b.s.worldFromLocal * local;
  return PathSample(L, pathDensity(b, L), false);
}
float emissionLeft(PathBsdf b) { return 1.0; }
