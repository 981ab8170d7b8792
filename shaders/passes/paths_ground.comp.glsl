// A path for each texel of the floor: one light that it looks at and one direction of a white Lambertian surface's, joined as at
// any other (path_lit.glsl). Sums are irradiance over pi.
#include "paths.glsl"
#include "diffuse.glsl"
#include "path_environment.glsl" if HAS_ENVIRONMENT
#ifdef HAS_PUNCTUAL_LIGHTS
#define SAMPLED_PIXEL gl_GlobalInvocationID.xy
#include "arriving_light.glsl"
#endif

layout(local_size_x = groupInvocations) in;

// The light that is looked at as if nothing were in its way, into p; false: none reaches the floor.
bool seeLightFromGround(inout PathState p) {
  const vec3 N = vec3(0.0, 1.0, 0.0);
  vec3 L = N, light = vec3(0.0);
  float distance = 3e38;
#ifdef HAS_PUNCTUAL_LIGHTS
  vec2 choice = pathDraw(p, lightChoicePair);
  if (min(int(choice.x * float(lightKinds)), lightKinds - 1) == punctualKind) {
    LightUniforms chosen = lights[min(uint(choice.y * float(pathsShared.lights)), pathsShared.lights - 1u)];
    light = arrivingLight(chosen, p.origin.xyz, N, L) * float(pathsShared.lights) / lightChance;
    if (chosen.position.w > 0.5) distance = length(chosen.position.xyz - p.origin.xyz);
  } else
#endif
  {
#ifdef HAS_ENVIRONMENT
    TexelSample texel = sampleEnvironment(pathDraw(p, lightPair));
    L = texel.direction;
    float density = lightChance * texel.density;
    if (density > 0.0) light = environmentRadiance(L) / density * drawnWeight(density, max(L.y, 0.0) / PI);
#endif
  }
  light *= max(L.y, 0.0) / PI;
  if (!(max(light.r, max(light.g, light.b)) > 0.0)) return false;
  p.lightOrigin = vec4(p.origin.xyz, distance);
  p.lightDirection = L;
  p.lightRadiance = vec4(light, 1.0);
  addToGround(p, groundUnblockedSum, light);
  return true;
}

void main() {
  uint i = gl_GlobalInvocationID.x, columns = pathsShared.columns;
  if (i >= pathsShared.rows * columns) return;
  PathState p = newPath(uvec2(i % columns, pathsShared.firstRow + i / columns));
  vec2 at = 2.0 * (vec2(pathPixel(p)) + pathDraw(p, pixelPair)) / float(columns) - 1.0;
  p.origin = vec4(frame.ground.x + at.x * frame.ground.w, frame.ground.y, frame.ground.z + at.y * frame.ground.w, 0.0);
  if (seeLightFromGround(p)) work[listAt(lightsList, atomicAdd(work[workLights], 1u))] = i;
  LobeSample drawn = sampleCosine(pathDraw(p, lobePair));
  p.direction = vec4(drawn.L.x, drawn.L.z, -drawn.L.y, drawn.density);
#ifdef HAS_ENVIRONMENT
  addToGround(p, groundUnblockedSum, environmentRadiance(p.direction.xyz) * drawnWeight(drawn.density, lightChance * environmentDensity(p.direction.xyz)));
#endif
  p.vertices = 1u;
  paths[i] = p;
  work[listAt(nextList(), i)] = i;
}
