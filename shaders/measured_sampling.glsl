// A mixture of a cosine lobe and of a GGX lobe's visible normals, to draw samples of a measured BRDF from: pure
// functions in tangent space. lobe: x, y alpha along and across; z cos, w sin of the azimuth of the first. cosineChance:
// share of the samples that the cosine gets. The twin is src/optics/measured_proxy.cpp.
#include "anisotropy.glsl"

vec3 turnedTo(vec4 lobe, vec3 d) { return vec3(lobe.z * d.x + lobe.w * d.y, lobe.z * d.y - lobe.w * d.x, d.z); }
vec3 turnedFrom(vec4 lobe, vec3 d) { return vec3(lobe.z * d.x - lobe.w * d.y, lobe.z * d.y + lobe.w * d.x, d.z); }

// L; below the horizon where the normal that was drawn mirrors V there. u.x chooses too, so that both lobes get evenly
// spread points.
vec3 sampleProxy(vec4 lobe, float cosineChance, vec3 V, vec2 u) {
  if (u.x < cosineChance) {
    float x = u.x / cosineChance, r = sqrt(x), phi = 2.0 * PI * u.y;
    return vec3(r * cos(phi), r * sin(phi), sqrt(max(1.0 - x, 0.0)));
  }
  vec2 rest = vec2((u.x - cosineChance) / (1.0 - cosineChance), u.y);
  vec3 H = turnedFrom(lobe, sampleVisibleNormalAnisotropic(turnedTo(lobe, V), lobe.xy, rest));
  return 2.0 * dot(V, H) * H - V;
}

// Of both together [1/sr], for L above the horizon.
float pdfProxy(vec4 lobe, float cosineChance, vec3 V, vec3 L) {
  vec3 S = V + L;
  vec3 H = S / max(length(S), 1e-7);
  vec3 localV = turnedTo(lobe, V);
  float facets = G1_GGXAnisotropic(localV, lobe.xy) * D_GGXAnisotropic(turnedTo(lobe, H), lobe.xy) / (4.0 * V.z);
  return cosineChance * L.z / PI + (1.0 - cosineChance) * facets;
}
