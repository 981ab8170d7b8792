// A mixture of a cosine lobe and of a GGX lobe's visible normals, to draw samples of a measured BRDF from: pure
// functions in tangent space. lobe: x, y alpha along and across; z cos, w sin of the azimuth of the first. cosineChance:
// share of the samples that the cosine gets. The twin is src/optics/measured_proxy.cpp.
#include "anisotropy.glsl"
#include "diffuse.glsl"

vec3 turnedTo(vec4 lobe, vec3 d) { return vec3(lobe.z * d.x + lobe.w * d.y, lobe.z * d.y - lobe.w * d.x, d.z); }
vec3 turnedFrom(vec4 lobe, vec3 d) { return vec3(lobe.z * d.x - lobe.w * d.y, lobe.z * d.y + lobe.w * d.x, d.z); }

// L; below the horizon where the normal that was drawn mirrors V there. u.x chooses too, so that both lobes get evenly
// spread points.
vec3 sampleProxy(vec4 lobe, float cosineChance, vec3 V, vec2 u) {
  if (u.x < cosineChance) return sampleCosine(vec2(u.y, u.x / cosineChance)).L;
  vec2 rest = vec2((u.x - cosineChance) / (1.0 - cosineChance), u.y);
  return turnedFrom(lobe, sampleGgx(turnedTo(lobe, V), lobe.xy, rest).L);
}

// Of both together [1/sr], for L above the horizon.
float pdfProxy(vec4 lobe, float cosineChance, vec3 V, vec3 L) {
  float facets = ggxDensity(turnedTo(lobe, V), turnedTo(lobe, L), lobe.xy);
  return cosineChance * cosineDensity(L) + (1.0 - cosineChance) * facets;
}
