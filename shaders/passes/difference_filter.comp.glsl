// What paths have found beside a drawn picture, smoothed: steps a trous (Dammertz et al. 2010) over pixels whose surfaces lie
// in one plane and face the same way; of sharp lobes only as far as their roughness allows. STEP 1: one such step; 2: the
// correction of what is drawn. The visible share of light is that of smoothed sums (Heitz et al. 2018), so that what nothing
// blocks stays as it is drawn and what is blocked leaves nothing.
#include "paths.h"
#include "layout.h"
#include "constants.h"
#include "frame.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(std140, binding = pathsBinding) uniform PathUniformsBlock { PathUniforms pathsShared; };
layout(binding = 0) uniform sampler2DArray smoothedSums;  // layers up to smoothedLayers
layout(binding = 1) uniform sampler2DArray differenceSums;
layout(binding = 2) uniform sampler2D distanceSum;
layout(location = differenceStepLocation) uniform vec4 parameters;

const float leastAlbedo = 1e-3;

vec3 albedo(ivec2 at, int lobes) { return max(texelFetch(differenceSums, ivec3(at, firstAlbedoLayer + lobes), 0).rgb, leastAlbedo); }

#if STEP == 1
// parameters: x distance of the taps in pixels, y how far sharp lobes of alpha 1 are smoothed, z 1: the first step, w how far shares of
// visible light differ by chance.
layout(binding = 0) writeonly uniform image2DArray smoothed;

struct Seen {
  vec3 position, N;
  float alpha, hits;
};

Seen seen(ivec2 at) {
  float hits = texelFetch(differenceSums, ivec3(at, visibleLayer), 0).a;
  if (hits == 0.0) return Seen(vec3(0.0), vec3(0.0), 0.0, 0.0);
  vec2 ndc = 2.0 * (vec2(at) + 0.5 + vec2(float(pathsShared.firstColumn), frame.picture.z)) / frame.picture.xy - 1.0;
  vec3 origin = pathsShared.origins[0].xyz + ndc.x * pathsShared.origins[1].xyz + ndc.y * pathsShared.origins[2].xyz;
  vec3 direction = pathsShared.directions[0].xyz + ndc.x * pathsShared.directions[1].xyz + ndc.y * pathsShared.directions[2].xyz;
  vec4 normal = texelFetch(differenceSums, ivec3(at, firstNormalLayer), 0);
  float length2 = dot(normal.xyz, normal.xyz), distance = texelFetch(distanceSum, at, 0).r;
  return Seen(origin + normalize(direction) * (distance / hits), normal.xyz * (length2 > 0.0 ? inversesqrt(length2) : 0.0), normal.w / hits, hits);
}

vec3 sumAt(ivec2 at, int layer) {
  vec3 sum = texelFetch(smoothedSums, ivec3(at, layer), 0).rgb;
  return parameters.z > 0.5 && layer >= returnedLayer ? sum / albedo(at, layer - returnedLayer) : sum;
}

// Of the unblocked light, what arrives: x by broad lobes, y by sharp ones.
vec2 visibleShares(ivec2 at) {
  vec2 shares;
  for (int lobes = 0; lobes < 2; ++lobes) {
    float visible = dot(texelFetch(smoothedSums, ivec3(at, visibleLayer + lobes), 0).rgb, vec3(1.0));
    float unblocked = dot(texelFetch(smoothedSums, ivec3(at, unblockedLayer + lobes), 0).rgb, vec3(1.0));
    shares[lobes] = unblocked > 0.0 ? min(visible / unblocked, 1.0) : 1.0;
  }
  return shares;
}

float pixelSize(vec3 position) {
  bool parallel = dot(pathsShared.directions[1].xyz, pathsShared.directions[1].xyz) == 0.0;
  return parallel ? 2.0 * length(pathsShared.origins[2].xyz) / frame.picture.y : length(position - pathsShared.origins[0].xyz) / frame.picture.w;
}

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy), size = textureSize(distanceSum, 0);
  if (at.x >= size.x || at.y >= size.y) return;
  Seen here = seen(at);
  vec3 sums[smoothedLayers];
  for (int i = 0; i < smoothedLayers; ++i) sums[i] = vec3(0.0);
  if (here.hits > 0.0) {
    int stride = int(parameters.x);
    float pixel = pixelSize(here.position) * float(stride), reach = clamp(parameters.y * here.alpha / parameters.x, 0.0, 1.0);
    vec2 total = vec2(1.0), sharesHere = visibleShares(at);
    for (int i = 0; i < smoothedLayers; ++i) sums[i] = sumAt(at, i);
    for (int y = -1; y <= 1; ++y)
      for (int x = -1; x <= 1; ++x) {
        ivec2 there = at + stride * ivec2(x, y);
        if ((x == 0 && y == 0) || there.x < 0 || there.y < 0 || there.x >= size.x || there.y >= size.y) continue;
        Seen other = seen(there);
        if (other.hits == 0.0) continue;
        vec3 apart = other.position - here.position;
        float plane = max(abs(dot(apart, here.N)), abs(dot(apart, other.N))) / pixel;
        float facing = max(dot(here.N, other.N), 0.0);
        float facing2 = facing * facing, facing4 = facing2 * facing2, facing8 = facing4 * facing4;
        vec2 alike = (visibleShares(there) - sharesHere) / parameters.w;
        alike = exp(-alike * alike);
        float broad = alike.x * (x == 0 || y == 0 ? 0.5 : 0.25) * exp(-plane * plane) * facing8 * facing8 * facing8 * facing8;
        float sharp = alike.y / max(alike.x, 1e-6) * broad * reach * exp(-8.0 * abs(other.alpha - here.alpha));
        for (int i = 0; i < smoothedLayers; i += 2) {
          sums[i] += broad * sumAt(there, i);
          sums[i + 1] += sharp * sumAt(there, i + 1);
        }
        total += vec2(broad, sharp);
      }
    for (int i = 0; i < smoothedLayers; ++i) sums[i] /= total[i & 1];
  }
  for (int i = 0; i < smoothedLayers; ++i) imageStore(smoothed, ivec3(at, i), vec4(min(sums[i], frame.stored.z), here.hits));
}
#else
// parameters: x first row that is kept, y how many are, z row of the picture of the first one, w 1: nothing was smoothed.
layout(binding = 0) writeonly uniform image2D difference;

void main() {
  ivec2 at = ivec2(gl_GlobalInvocationID.xy) + ivec2(0, int(parameters.x));
  if (at.x >= int(pathsShared.columns) || at.y >= int(parameters.x + parameters.y)) return;
  vec3 sum = vec3(0.0);
  for (int lobes = 0; lobes < 2; ++lobes) {
    vec3 visible = texelFetch(smoothedSums, ivec3(at, visibleLayer + lobes), 0).rgb;
    vec3 unblocked = texelFetch(smoothedSums, ivec3(at, unblockedLayer + lobes), 0).rgb;
    vec3 returned = texelFetch(smoothedSums, ivec3(at, returnedLayer + lobes), 0).rgb;
    vec3 share = mix(vec3(1.0), min(visible / max(unblocked, 1e-30), 1.0), greaterThan(unblocked, vec3(0.0)));
    sum += texelFetch(differenceSums, ivec3(at, tableLayer + lobes), 0).rgb * (share - 1.0);
    sum += parameters.w > 0.5 ? returned : returned * albedo(at, lobes);
  }
  imageStore(difference, at + ivec2(int(pathsShared.firstColumn), int(parameters.z)), vec4(clamp(sum, -frame.stored.z, frame.stored.z), 0.0));
}
#endif
