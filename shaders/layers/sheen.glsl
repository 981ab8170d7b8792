// KHR_materials_sheen: cloth over the base.
#include "sheen.glsl"
#include "light_parts.glsl" if LIGHT_PART

struct Sheen {
  vec3 color;
  float perceptualRoughness;
  float alpha;
  float albedoV, albedoL;  // E of the lobe at V and, where a light is evaluated, at L: sheen_table.glsl
};

void setSheen(inout Sheen sheen, vec3 color, float perceptualRoughness, float albedoV) {
  sheen.color = color;
  sheen.perceptualRoughness = perceptualRoughness;
  sheen.alpha = perceptualRoughness * perceptualRoughness;
  sheen.albedoV = albedoV;
  sheen.albedoL = albedoV;
}

// Lobe times NoL without its colour.
float sheenLobe(Sheen sheen, vec3 N, vec3 V, float NoV, vec3 L) {
  float NoL = dot(N, L);
  vec3 VL = V + L;
  float length2 = dot(VL, VL);
  if (NoL <= 0.0 || length2 < 1e-12) return 0.0;
  float NoH = dot(N, VL) * inversesqrt(length2);
  float guard = sheenGainGuard(sheen.albedoV, sheen.albedoL);
  return D_Charlie(NoH, sheen.alpha) * V_Charlie(NoV, NoL, sheen.alpha) * guard * min(NoL, 1.0);
}

// Share of what the base returns that passes it, for distant light.
float sheenLeft(Sheen sheen) {
  float albedo = min(sheen.albedoV, 1.0);
  return sheenScaling(sheen.color, albedo, albedo);
}

// f NoL of the base, below: of both.
vec3 underSheen(Sheen sheen, vec3 below, vec3 N, vec3 V, float NoV, vec3 L) {
  return below * sheenScaling(sheen.color, min(sheen.albedoV, 1.0), min(sheen.albedoL, 1.0)) +
         layerPart(sheen.color * sheenLobe(sheen, N, V, NoV, L));
}
