// A path at a lit surface: next-event estimation of one light and one direction drawn from the lobes, joined by the power
// heuristic (Veach 1997), and Russian roulette.
#include "lit_surface.glsl"
#include "bsdf_sampling.glsl"
#include "layers/body.glsl" if HAS_VOLUME
#include "layers/volume.glsl" if HAS_VOLUME
#include "path_environment.glsl" if HAS_ENVIRONMENT
#include "sheen_table.glsl" if HAS_SHEEN
#ifdef HAS_PUNCTUAL_LIGHTS
#include "arriving_light.glsl"

#endif

// Vertices from which on paths end by chance.
const uint rouletteVertices = 4u;

struct PathTurn {
  PathState path;
  bool lit;     // there is a light to be seen
  bool goesOn;
};

// A surface as light meets it from either side.
struct PathBsdf {
  Surface s;
  Through through;
  bool inside;  // of a body: its interface from within
  float eta;    // index beyond the interface over that here
  vec3 Ng;
};

vec3 evaluatePath(PathBsdf b, vec3 L) {
  // Where the shading normal leans: what it reflects must leave the surface, what passes must enter it.
  if (dot(b.s.N, L) * dot(b.Ng, L) <= 0.0) return vec3(0.0);
#ifdef HAS_VOLUME
  if (b.inside) return evaluateInside(b.s, b.eta, b.through.share, L);
#endif
  float NoL = dot(b.s.N, L);
  lightSheen(b.s.sheen, NoL);
#if ENERGY_MODEL == 3
  vec3 dfgL = lookUpDfg(NoL, b.s.perceptualRoughness);
  b.s.albedoL = dfgL.x + dfgL.y;
#endif
  return evaluateBsdf(b.s, b.through, L);
}
float pathDensity(PathBsdf b, LobeChances chances, vec3 L) {
#ifdef HAS_VOLUME
  if (b.inside) return insideDensity(b.s, b.eta, L);
#endif
  return bsdfDensity(b.s, b.through, chances, L);
}
BsdfSample samplePath(PathBsdf b, vec3 u) {
#ifdef HAS_VOLUME
  if (b.inside) return sampleInside(b.s, b.eta, u);
#endif
  return sampleBsdf(b.s, b.through, u);
}

PathBsdf pathBsdf(inout PathState p, PathSurface at, vec3 baseColor, float choice) {
  vec3 V = -p.direction.xyz;
  LitSurface lit = litSurface(at.v, V, baseColor);
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
    uint outside = at.front ? p.media : leaveMedium(p.media, at.material);
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
  return b;
}

// The light that is looked at from the surface, into p; false: none reaches it.
bool seeLight(inout PathState p, PathSurface at, PathBsdf b, LobeChances chances) {
  vec3 L, arriving = vec3(0.0);
  float distance = 3e38;
#ifdef HAS_PUNCTUAL_LIGHTS
  vec2 choice = pathDraw(p, lightChoicePair);
  if (lightChance == 1.0 || choice.x >= lightChance) {
    LightUniforms light = lights[min(uint(choice.y * float(pathsShared.lights)), pathsShared.lights - 1u)];
    arriving = arrivingLight(light, at.v.position, at.Ng, L) * float(pathsShared.lights) / (lightChance == 1.0 ? 1.0 : 1.0 - lightChance);
    if (light.position.w > 0.5) distance = length(light.position.xyz - at.v.position);
  } else
#endif
  {
#ifdef HAS_ENVIRONMENT
    TexelSample drawn = sampleEnvironment(pathDraw(p, lightPair));
    L = drawn.direction;
    float density = lightChance * drawn.density;
    if (density > 0.0) {
      arriving = environmentRadiance(L) / density;
      arriving *= drawnWeight(density, pathDensity(b, chances, L));
    }
#endif
  }
  if (arriving == vec3(0.0)) return false;
  vec3 radiance = p.throughput.rgb * arriving * evaluatePath(b, L);
  if (!(largestOf(radiance) > 0.0)) return false;
  p.lightOrigin = vec4(leaveSurface(at, L), distance);
  p.lightDirection = vec4(L, 0.0);
  p.lightRadiance = vec4(radiance, 0.0);
  return true;
}

PathTurn turnAt(PathState p, PathSurface at, vec3 baseColor) {
  PathTurn turn;
  turn.lit = turn.goesOn = false;
  vec2 choice = pathDraw(p, choicePair);
  PathBsdf b = pathBsdf(p, at, baseColor, choice.y);
  p.radiance.rgb += p.throughput.rgb * materialEmission(at.v) * coatLeft(b.s);
  turn.path = p;
  if (p.vertices >= pathsShared.mostVertices) return turn;
  LobeChances chances = lobeChances(b.s, b.through);
  turn.lit = seeLight(p, at, b, chances);
  BsdfSample drawn = samplePath(b, vec3(pathDraw(p, lobePair), choice.x));
  turn.path = p;
  if (!(drawn.density > 0.0)) return turn;
  vec3 throughput = p.throughput.rgb * evaluatePath(b, drawn.L) / drawn.density;
  float most = largestOf(throughput);
  if (!(most > 0.0) || isinf(most)) return turn;
  if (p.vertices + 1u >= rouletteVertices) {
    float survival = min(most, 0.95);
    if (owenSobol2(pathsShared.number, 0x10000u + p.vertices, pixelSeed(pathPixel(p), pathsUse)).x >= survival) return turn;
    throughput /= survival;
  }
#ifdef HAS_VOLUME
  if (dot(at.Ng, drawn.L) < 0.0 && materialThickness(at.v) > 0.0)
    turn.path.media = at.front ? enterMedium(p.media, at.material) : leaveMedium(p.media, at.material);
#endif
  turn.goesOn = true;
  turn.path.origin = vec4(leaveSurface(at, drawn.L), 0.0);
  turn.path.direction = vec4(drawn.L, drawn.density);
  turn.path.throughput = vec4(throughput, 0.0);
  turn.path.vertices = p.vertices + 1u;
  return turn;
}
