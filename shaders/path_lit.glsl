// A path at a lit surface: next-event estimation of one light and one direction drawn from the lobes, joined by the power
// heuristic (Veach 1997), and Russian roulette.
#if defined(MERL_BRDF) || defined(UTIA_BRDF)
#include "path_measured.glsl"
#else
#include "path_bsdf.glsl"
#endif
#include "path_environment.glsl" if HAS_ENVIRONMENT
#include "path_through.glsl" if BACKGROUND_BLUR
#ifdef HAS_PUNCTUAL_LIGHTS
#define SAMPLED_PIXEL gl_GlobalInvocationID.xy  // of a light's disc, where there is no fragment
#include "arriving_light.glsl"

#endif
#include "path_difference.glsl" if DIFFERENCE
#include "path_glow.glsl" if GLOWING

// Vertices from which on paths end by chance.
const uint rouletteVertices = 4u;

struct PathTurn {
  PathState path;
  bool lit;     // there is a light to be seen
  bool goesOn;
};

// The light that is looked at from the surface, into p; false: none reaches it.
bool seeLight(inout PathState p, PathSurface at, PathBsdf b) {
  vec3 L, reflected = vec3(0.0);
  float distance = 3e38;
  bool environment = false;
#if defined(HAS_PUNCTUAL_LIGHTS) || defined(GLOWING)
  vec2 choice = pathDraw(p, lightChoicePair);
  int kind = min(int(choice.x * float(lightKinds)), lightKinds - 1);
#endif
#ifdef GLOWING
  if (kind == glowingKind) {
    GlowPoint there = sampleGlow(pathDraw(p, lightPair));
    vec3 towards = there.position - at.v.position;
    distance = length(towards);
    L = towards / max(distance, 1e-30);
    float density = lightChance * glowSolidAngleDensity(there.radiance, distance, dot(there.facing, L));
    if (density > 0.0) reflected = there.radiance / density * drawnWeight(density, pathDensity(b, L)) * evaluatePath(b, L);
    distance *= 0.9999;  // in front of it
  } else
#endif
#ifdef HAS_PUNCTUAL_LIGHTS
  if (kind == punctualKind) {
    LightUniforms light = lights[min(uint(choice.y * float(pathsShared.lights)), pathsShared.lights - 1u)];
    vec3 arriving = arrivingLight(light, at.v.position, at.Ng, L) * float(pathsShared.lights) / lightChance;
    if (arriving != vec3(0.0)) reflected = arriving * evaluatePath(b, L);
    if (light.position.w > 0.5) distance = length(light.position.xyz - at.v.position);
  } else
#endif
  {
#ifdef HAS_ENVIRONMENT
    environment = true;
    if (byTables(p, b)) {
      if (!seeSun(at, b, L, reflected)) return false;
      reflected /= lightChance;
    } else {
      TexelSample texel = sampleEnvironment(pathDraw(p, lightPair));
      L = texel.direction;
      float density = lightChance * texel.density;
      if (density > 0.0) reflected = radianceFromAfar(p, at, L) / density * drawnWeight(density, pathDensity(b, L)) * evaluatePath(b, L);
    }
#endif
  }
  vec3 radiance = p.throughput.rgb * reflected;
  if (!(max(radiance.r, max(radiance.g, radiance.b)) > 0.0) || staysDrawn(p, at, L)) return false;
  p.lightOrigin = vec4(leaveSurface(at, L), distance);
  p.lightDirection = L;
  p.lightRadiance = vec4(radiance, correcting(p) ? broadShare(b, L, pathDensity(b, L)) : p.throughput.w);
  rememberUnblocked(p, p.lightRadiance.rgb, p.lightRadiance.w, environment);
  return true;
}

// Of emission that a drawn direction meets, where light is looked for there, too.
float emissionWeight(PathState p, PathSurface at) {
  if (p.direction.w == 0.0 || !at.glowing) return 1.0;
  float density = lightChance * glowSolidAngleDensity(material.emission, p.distance, dot(at.Ng, p.direction.xyz));
  return drawnWeight(abs(p.direction.w), density);
}

PathTurn turnAt(PathState p, PathSurface at, vec3 baseColor) {
  PathTurn turn;
  turn.lit = turn.goesOn = false;
  vec2 choice = pathDraw(p, choicePair);
  PathBsdf b = pathBsdf(p, at, baseColor, choice.y);
  if (correcting(p))
    rememberFirst(p, at, b);
  else
    gather(p, p.throughput.rgb * materialEmission(at.v) * emissionLeft(b) * emissionWeight(p, at), p.throughput.w);
  turn.path = p;
  if (p.vertices >= pathsShared.mostVertices) return turn;
  bool tables = byTables(p, b);
  turn.lit = seeLight(p, at, b);
  PathSample drawn = samplePath(b, vec3(pathDraw(p, lobePair), choice.x));
  turn.path = p;
  if (!(drawn.density > 0.0)) return turn;
  vec3 throughput = p.throughput.rgb * evaluatePath(b, drawn.L) / drawn.density;
  float most = max(throughput.r, max(throughput.g, throughput.b));
  if (!(most > 0.0) || isinf(most) || staysDrawn(p, at, drawn.L)) return turn;
  float broad = p.throughput.w;
  if (correcting(p)) broad = broadShare(b, drawn.L, drawn.density);
#ifdef SOFT_CAUSTICS
  broad = drawn.broad ? 1.0 : p.vertices == 0u ? 0.0 : broad;
#endif
  float survival = 1.0;
  if (p.vertices + 1u >= rouletteVertices) {
    survival = min(most, 0.95);
    if (owenSobol2(pathsShared.number, 0x10000u + p.vertices, pathSeed(p)).x >= survival) return turn;
    throughput /= survival;
  }
  rememberUnblocked(turn.path, throughput * unblockedRadiance(drawn), broad, true);
#ifdef HAS_VOLUME
  if (dot(at.Ng, drawn.L) < 0.0 && materialThickness(at.v) > 0.0) {
    uvec2 media = at.front ? enterMedium(mediaOf(p), at.material) : leaveMedium(mediaOf(p), at.material);
    turn.path.media = media.x, turn.path.outerMedia = media.y;
  }
#endif
  turn.goesOn = true;
  turn.path.origin = vec4(leaveSurface(at, drawn.L), 0.0);
  turn.path.direction = vec4(drawn.L, tables ? 1e30 : passingDensity(p, at, drawn.L, drawn.density));  // what is not looked at is all found by the lobes
  turn.path.onMiss = tables ? vec4(p.throughput.rgb / survival, 1.0) * onMiss(at, b, unblockedLight(at, b, false), drawn) : vec4(0.0);
  turn.path.throughput = vec4(throughput, broad);
  turn.path.vertices = p.vertices + 1u;
  return turn;
}
