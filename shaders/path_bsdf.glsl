// The lobes of a material as paths meet them: value, density and sample of all together.
#include "lit_surface.glsl"
#include "bsdf_sampling.glsl"
#include "layers/body.glsl" if HAS_VOLUME
#include "layers/volume.glsl" if HAS_VOLUME
#include "sheen_table.glsl" if HAS_SHEEN

struct PathSample {
  vec3 L;
  float density;  // [1/sr]; 0: nothing was drawn
  bool broad;     // of a broad lobe
};

// A surface as light meets it from either side.
struct PathBsdf {
  Surface s;
  Through through;
  bool inside;  // of a body: its interface from within
  float eta;    // index beyond the interface over that here
  vec3 Ng;
  LobeChances chances;
};

vec3 evaluatePath(PathBsdf b, vec3 L) {
  // Where the shading normal leans: what it reflects must leave the surface, what passes must enter it.
  if (dot(b.s.N, L) * dot(b.Ng, L) <= 0.0) return vec3(0.0);
#ifdef HAS_VOLUME
  if (b.inside) return evaluateInside(b.s, b.eta, b.through.share, L);
#endif
  float NoL = dot(b.s.N, L);
  lightSheen(b.s.sheen, NoL);
#if ENERGY_MODEL == ENERGY_KULLA_CONTY
  vec3 dfgL = lookUpDfg(NoL, b.s.perceptualRoughness);
  b.s.albedoL = dfgL.x + dfgL.y;
#endif
  return evaluateBsdf(b.s, b.through, L);
}
float pathDensity(PathBsdf b, vec3 L) {
#ifdef HAS_VOLUME
  if (b.inside) return insideDensity(b.s, b.eta, L);
#endif
  return bsdfDensity(b.s, b.through, b.chances, L);
}
PathSample samplePath(PathBsdf b, vec3 u) {
  BsdfSample drawn;
#ifdef HAS_VOLUME
  if (b.inside)
    drawn = sampleInside(b.s, b.eta, u);
  else
#endif
    drawn = sampleBsdf(b.s, b.through, u);
  bool broad = drawn.lobe == diffuseLobe || drawn.lobe == scatteredLobe || drawn.lobe == sheenLobeIndex;
  return PathSample(drawn.L, drawn.density, broad);
}

// Of what the surface emits: it lies below the coat (KHR_materials_clearcoat).
float emissionLeft(PathBsdf b) { return coatLeft(b.s); }

#if defined(DIFFERENCE) || defined(SOFT_CAUSTICS)
// Of surfaces that broad lobes see: how sharp they mirror does not tell in what few paths find there, but how seldom they
// mirror a lamp does.
void widenLobe(PathState p, inout Surface s) {
#ifdef DIFFERENCE
  float share = mix(p.radiance.a, 1.0, p.throughput.w);
#else
  float share = p.throughput.w;
#endif
  float least = p.vertices > 0u ? 0.25 * share : 0.0;
#ifdef SOFT_CAUSTICS
  widenCoat(s.coat, least);
  widenGrain(s.grain, least);
#endif
  if (s.alpha < least) {
    setRoughness(s, sqrt(least));
    s.dfg = lookUpDfg(s.NoV, s.perceptualRoughness);
  }
#ifdef SOFT_CAUSTICS
  setGrainDfg(s.grain, s.N, s.V, s.dfg);
#endif
}
#endif

PathBsdf pathBsdf(inout PathState p, PathSurface at, vec3 baseColor, float choice) {
  vec3 V = -p.direction.xyz;
  LitSurface lit = litSurface(at.v, V, baseColor);
#if defined(DIFFERENCE) || defined(SOFT_CAUSTICS)
  widenLobe(p, lit.s);
#endif
  PathBsdf b;
  b.s = lit.s;
  b.Ng = at.Ng;
  b.through = opaque();
  b.inside = false;
  b.eta = 1.0;
#if defined(HAS_TRANSMISSION) || defined(HAS_DIFFUSE_TRANSMISSION)
  float ior = material.ior;
#ifdef HAS_DISPERSION
  if (min(p.throughput.r, min(p.throughput.g, p.throughput.b)) > 0.0) {  // the path is of one colour from here on
    int channel = min(int(3.0 * choice), 2);
    p.throughput.rgb *= 3.0 * vec3(channel == 0, channel == 1, channel == 2);
  }
  vec3 iors = dispersedIors(ior, material.dispersion);
  ior = p.throughput.r > 0.0 ? iors.r : p.throughput.g > 0.0 ? iors.g : iors.b;
#endif
  bool body = materialThickness(at.v) > 0.0;
  b.through.share = lit.transmitted * baseColor;
  b.through.diffuse = lit.scattered * diffuseTransmittedColor(at.v);
  b.through.alpha = max(body ? lit.s.alpha : transmittedAlpha(lit.s.perceptualRoughness, ior, false), minAnalyticAlpha);
#ifdef HAS_VOLUME
  if (body && lit.transmitted > 0.0) {
    uvec2 outside = at.front ? mediaOf(p) : leaveMedium(mediaOf(p), at.material);
    b.eta = at.front ? ior / mediumIor(outside) : mediumIor(outside) / max(ior, 1e-6);
    if (ior == 0.0) b.eta = at.front ? 0.0 : 1e-6;
    bool bends = abs(b.eta - 1.0) > 1e-3;
    b.inside = !at.front && bends;
    b.through.eta = bends ? b.eta : 0.0;
    if (!bends) b.through.alpha = minAnalyticAlpha;
  }
#endif
  vec3 dfg = lookUpDfg(lit.s.NoV, sqrt(b.through.alpha));
  b.through.albedo = dfg.x + dfg.y;
#endif
  b.chances = lobeChances(b.s, b.through);
  return b;
}
