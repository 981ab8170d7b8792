// What a layer leaves for those below it, and the coat of KHR_materials_clearcoat. The rule, and what the Fresnel term
// in the place of the albedo costs, are in src/optics/layers.hpp. Cosines are those of the layer's own normal.
#include "microfacet.glsl"

const float coatF0 = 0.04;

// Schlick 1994 with f0 = 0.04, f90 = 1.
float F_Coat(float VoH) {
  float m = clamp(1.0 - VoH, 0.0, 1.0), m2 = m * m;
  return coatF0 + (1.0 - coatF0) * (m2 * m2 * m);
}

// f NoL of the coat's lobe [1/sr], weight 1. V below the coat's horizon counts as minNoV above it; L below: 0.
float coatLobe(vec3 coatNormal, vec3 V, vec3 L, float alpha) {
  float NoL = min(dot(coatNormal, L), 1.0);
  vec3 VL = V + L;
  float length2 = dot(VL, VL);
  if (NoL <= 0.0 || length2 < 1e-12) return 0.0;
  vec3 H = VL * inversesqrt(length2);
  float NoV = clamp(dot(coatNormal, V), minNoV, 1.0);
  alpha = max(alpha, minAnalyticAlpha);
  return D_GGX(coatNormal, H, alpha) * V_SmithGGXCorrelated(NoV, NoL, alpha) * F_Coat(dot(V, H)) * NoL;
}

// Sample of that lobe in the frame of the coat's normal; its weight has F_Coat in it, its density is ggxDensity.
LobeSample sampleCoat(vec3 V, float alpha, vec2 u) {
  LobeSample drawn = sampleGgx(V, alpha, u);
  drawn.weight *= F_Coat(drawn.VoH);
  return drawn;
}

// The rule: 1 - weight E(V), E of the layer's lobe. Never a gain, none lost over a white base.
float layerTransmittance(float weight, float albedoV) { return clamp(1.0 - weight * albedoV, 0.0, 1.0); }
