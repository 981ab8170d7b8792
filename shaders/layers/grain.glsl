// KHR_materials_anisotropy: the base's lobe, long along T.
#include "anisotropy.glsl"
#include "lights.glsl"

struct Grain {
  vec3 T, B;   // with N orthonormal
  vec2 alpha;  // along T and B
};

// along: the direction in the world, of any length; where it is none, or along N, any.
void setGrain(inout Grain grain, vec3 along, vec3 N, float alpha, float strength) {
  vec3 T = along - dot(along, N) * N;
  grain.T = dot(T, T) > 1e-12 ? normalize(T) : frameAround(N)[0];
  grain.B = cross(N, grain.T);
  grain.alpha = alphaFromAnisotropy(alpha, strength);
}
// A and B of the lobe.
void setGrainDfg(Grain grain, vec3 N, vec3 V, inout vec3 dfg) {
  dfg.xy = dfgAnisotropic(V * mat3(grain.T, grain.B, N), max(grain.alpha, minAnalyticAlpha));
}
void spreadGrain(inout Grain grain, float angularRadius) {
  grain.alpha = vec2(alphaOfDisc(grain.alpha.x, angularRadius), alphaOfDisc(grain.alpha.y, angularRadius));
}
void widenGrain(inout Grain grain, float alpha) { grain.alpha = max(grain.alpha, alpha); }

// D V without Fresnel term and cosine [1/sr].
float lobeFacets(Grain grain, vec3 N, vec3 V, float NoV, vec3 L, float NoL, vec3 H, float alpha) {
  vec2 alphas = max(grain.alpha, minAnalyticAlpha);
  mat3 local = mat3(grain.T, grain.B, N);
  vec3 localV = vec3((V * local).xy, NoV);
  return D_GGXAnisotropic(H * local, alphas) * V_GGXAnisotropic(localV, L * local, alphas);
}

// There is no table of E at L: Kulla and Conty's lobe is flat.
float lobeMultipleShape(Grain grain, float albedoL, float missing) { return 1.0; }
