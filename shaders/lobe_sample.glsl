// What the samplers of the lobes return. Directions are in the frame of the lobe's own normal: +Z, V on its side.
struct LobeSample {
  vec3 L;
  float density;  // of L [1/sr], also where L is on the wrong side of the surface; 0: nothing was drawn
  float weight;   // value / density, the value f |NoL| with F = 1; 0 on the wrong side
  float VoH;      // at the facet, for the Fresnel term; 1 where the lobe has no facets
};
LobeSample noSample() { return LobeSample(vec3(0.0, 0.0, 1.0), 0.0, 0.0, 1.0); }

vec3 mirroredBelow(vec3 L) { return vec3(L.xy, -L.z); }

// Half vector [unit]; L = -V: 0.
vec3 halfVector(vec3 V, vec3 L) {
  vec3 VL = V + L;
  float length2 = dot(VL, VL);
  return length2 > 1e-12 ? VL * inversesqrt(length2) : vec3(0.0);
}
