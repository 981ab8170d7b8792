// The base's lobe is round, of the model that was chosen.
#include "models.glsl"
#include "energy.glsl"

struct Grain {
  bool none;
};

void setGrain(inout Grain grain, vec3 along, vec3 N, float alpha, float strength) {}
void setGrainDfg(Grain grain, vec3 N, vec3 V, inout vec3 dfg) {}
void spreadGrain(inout Grain grain, float angularRadius) {}
void widenGrain(inout Grain grain, float alpha) {}

float lobeFacets(Grain grain, vec3 N, vec3 V, float NoV, vec3 L, float NoL, vec3 H, float alpha) {
  alpha = max(alpha, minAnalyticAlpha);
  return modelD(N, H, alpha) * modelV(NoV, NoL, dot(N, H), dot(V, H), alpha);
}

float lobeMultipleShape(Grain grain, float albedoL, float missing) { return multipleShapeKullaConty(albedoL, missing); }
