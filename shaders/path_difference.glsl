// Paths that correct a drawn picture (frame/difference.hpp). At the first surface they find which share of the light that is
// drawn arrives, and what other surfaces send in the place of the rest. At surfaces beyond, tables stand for the
// environment, each lobe's where a direction drawn from it meets nothing: few samples of lamps would be noise there.
#if defined(HAS_ENVIRONMENT) && !defined(MERL_BRDF) && !defined(UTIA_BRDF)
#define PATH_TABLES
#include "image_light.glsl"
#endif
#if defined(HAS_PUNCTUAL_LIGHTS) || defined(PATH_SUN)
#define DRAWN_LIGHTS
#ifndef SAMPLED_PIXEL
#define SAMPLED_PIXEL gl_GlobalInvocationID.xy
#endif
#ifdef PATH_TABLES
#include "punctual_light.glsl"
#else
#include "arriving_light.glsl"
#endif
#endif

bool correcting(PathState p) { return p.vertices == 0u; }

// What is drawn of light that passes is not what paths would bring without anything in their way: it stays as it is drawn.
bool staysDrawn(PathState p, PathSurface at, vec3 L) {
#ifdef HAS_TRANSMISSION
  return correcting(p) && dot(at.Ng, L) < 0.0;
#else
  return false;
#endif
}

// Tables stand for the environment.
bool byTables(PathState p, PathBsdf b) {
#ifdef PATH_TABLES
  return !correcting(p) && !b.inside;
#else
  return false;
#endif
}

// Share of the broad lobes in light from there. Any share would do for the picture; this one keeps apart what may be smoothed
// over wide distances from what may not.
float broadShare(PathBsdf b, vec3 L, float density) {
#if defined(MERL_BRDF) || defined(UTIA_BRDF)
  return 0.0;
#else
  float cosine = dot(b.s.N, L) / PI;
  float broad = cosine > 0.0 ? b.chances.of[diffuseLobe] * cosine : -b.chances.of[scatteredLobe] * cosine;
  return density > 0.0 ? clamp(broad / density, 0.0, 1.0) : 0.0;
#endif
}

#ifdef DRAWN_LIGHTS
PathBsdf underLight(PathBsdf b, LightUniforms light) {
#ifdef PATH_TABLES
  if (isSun(light)) b.s = sunlit(b.s, light);
#endif
  return b;
}
#endif

// Broad and sharp, of light that nothing blocks: that of the environment and, with `punctual`, of all lights and its sun.
struct UnblockedLight {
  vec3 broad, sharp;
};
UnblockedLight noLight() { return UnblockedLight(vec3(0.0), vec3(0.0)); }
UnblockedLight unblockedLight(PathSurface at, PathBsdf b, bool punctual) {
  UnblockedLight light = noLight();
#ifdef PATH_TABLES
  if (!b.inside) {
    light.broad = lookUpIrradiance(b.s.N) * irradianceAlbedo(b.s) * layersLeft(b.s) * frame.environmentScale.x;
    light.sharp = max(imageLight(b.s) - light.broad, 0.0);
#ifdef HAS_DIFFUSE_TRANSMISSION
    if (punctual) light.broad += lookUpIrradiance(-b.s.N) * b.through.diffuse * enteringShare(b.s) * frame.environmentScale.x;
#endif
  }
#endif
#ifdef DRAWN_LIGHTS
  for (uint i = 0u; punctual && i < uint(lights.length()); ++i) {
    vec3 L, arriving = arrivingLight(lights[i], at.v.position, at.Ng, L);
    if (arriving == vec3(0.0)) continue;
    PathBsdf lit = underLight(b, lights[i]);
    vec3 radiance = evaluatePath(lit, L) * arriving;
    float broad = broadShare(lit, L, pathDensity(lit, L));
    light.broad += broad * radiance;
    light.sharp += (1.0 - broad) * radiance;
  }
#endif
  return light;
}

void rememberFirst(inout PathState p, PathSurface at, PathBsdf b) {
  UnblockedLight light = unblockedLight(at, b, true);
  addLight(p, tableLayer, light.broad, light.sharp);
#if defined(MERL_BRDF) || defined(UTIA_BRDF)
  const float measuredAlpha = 0.3;  // nothing is known of its lobes
  addToLayer(p, firstNormalLayer, vec4(b.s.worldFromLocal[2], measuredAlpha));
  addToLayer(p, firstAlbedoLayer + 1, vec4(1.0));
#else
  float left = layersLeft(b.s), sharpest = b.s.alpha;
#ifdef HAS_CLEARCOAT
  if (b.s.coat.weight > 0.0) sharpest = min(sharpest, b.s.coat.alpha);
#endif
  p.radiance.a = sharpest;
  addToLayer(p, firstNormalLayer, vec4(b.s.N, sharpest));
  addToLayer(p, firstAlbedoLayer, vec4(irradianceAlbedo(b.s) * left + b.through.diffuse * enteringShare(b.s) + sheenChance(b.s), 0.0));
  addToLayer(p, firstAlbedoLayer + 1, vec4(prefilteredAlbedo(b.s) * left + coatChance(b.s), 0.0));
#endif
  addToLayer(p, visibleLayer, vec4(0.0, 0.0, 0.0, 1.0));
  ivec2 texel = differenceTexel(p);
  imageStore(distanceSum, texel, imageLoad(distanceSum, texel) + pathsShared.share * p.distance);
}

// What comes to the first surface as if nothing were in its way.
void rememberUnblocked(inout PathState p, vec3 radiance, float broad, bool environment) {
  if (!correcting(p)) return;
  addLight(p, unblockedLayer, radiance, broad);
#ifndef PATH_TABLES
  if (environment) addLight(p, tableLayer, radiance, broad);  // what is drawn has no table either
#endif
}

// The sun as a surface beyond the first one sees it; false: there is none.
bool seeSun(PathSurface at, PathBsdf b, out vec3 L, out vec3 reflected) {
  L = reflected = vec3(0.0);
#if defined(PATH_SUN) && defined(PATH_TABLES)
  LightUniforms sun = lights[pathsShared.lights];
  vec3 arriving = arrivingLight(sun, at.v.position, at.Ng, L);
  reflected = evaluatePath(underLight(b, sun), L) * arriving;
  return true;
#else
  return false;
#endif
}

// What the environment brings by the drawn lobe if nothing is met.
vec4 onMiss(PathSurface at, PathBsdf b, UnblockedLight light, PathSample drawn) {
#ifdef PATH_TABLES
  if (dot(at.Ng, drawn.L) <= 0.0) return vec4(0.0);  // through the surface: texels
  float broad = b.chances.of[diffuseLobe] + b.chances.of[sheenLobeIndex];
  float sharp = b.chances.of[specularLobe] + b.chances.of[coatLobeIndex];
  return vec4(drawn.broad ? light.broad / max(broad, 1e-4) : light.sharp / max(sharp, 1e-4), 1.0);
#else
  return vec4(0.0);
#endif
}

// What the environment adds from where nothing is met.
vec3 unblockedRadiance(PathSample drawn) {
#ifdef HAS_ENVIRONMENT
  return environmentRadiance(drawn.L) * drawnWeight(drawn.density, lightChance * environmentDensity(drawn.L));
#else
  return vec3(0.0);
#endif
}
