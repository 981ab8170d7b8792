// Equirectangular map -> cube map: each texel is the mean radiance over its solid angle, from taps x taps samples.
// Where they differ by more than `steep` in a channel, from steepTaps x steepTaps: a sun of one source texel is a tent
// two texels wide, whose flux 4 x 4 taps miss by up to 2 %, 16 x 16 by 0.12 %. Alpha holds the texel's solid angle.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = equirectUnit) uniform sampler2D equirect;
layout(binding = 0, rgba32f) writeonly uniform imageCube cube;
layout(location = cubeTapsLocation) uniform int taps;
layout(location = cubeSteepTapsLocation) uniform int steepTaps;
layout(location = cubeSteepLocation) uniform float steep;
layout(location = cubeFirstFaceLocation) uniform int firstFace;

vec3 radianceAt(int face, vec2 st) {
  return textureLod(equirect, equirectFromDirection(normalize(directionFromCube(face, st))), 0.0).rgb;
}

// low and high take in the samples.
vec3 meanRadiance(ivec3 texel, float texelSize, int n, inout vec3 low, inout vec3 high) {
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      vec2 st = (vec2(texel.xy) + (vec2(i, j) + 0.5) / float(n)) * texelSize - 1.0;
      float w = cubeSolidAngleDensity(st);
      vec3 radiance = radianceAt(texel.z, st);
      low = min(low, radiance);
      high = max(high, radiance);
      sum += w * radiance;
      weights += w;
    }
  return sum / weights;
}

void main() {
  int size = imageSize(cube).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstFace);
  if (texel.x >= size || texel.y >= size) return;
  float texelSize = 2.0 / float(size);
  vec2 centre = (vec2(texel.xy) + 0.5) * texelSize - 1.0;
  float solidAngle = cubeSolidAngleDensity(centre) * texelSize * texelSize;
#ifdef ONE_TAP
  vec3 mean = radianceAt(texel.z, centre);
#else
  vec3 low = vec3(3e38), high = vec3(0.0);
  // A sun that only the texel's margin sees, outside the outermost samples, shows at a corner.
  for (int corner = 0; corner < 4; ++corner) {
    vec3 radiance = radianceAt(texel.z, (vec2(texel.xy) + vec2(corner % 2, corner / 2)) * texelSize - 1.0);
    low = min(low, radiance);
    high = max(high, radiance);
  }
  vec3 mean = meanRadiance(texel, texelSize, taps, low, high);
  vec3 range = high - low;
  if (max(range.r, max(range.g, range.b)) > steep) mean = meanRadiance(texel, texelSize, steepTaps, low, high);
#endif
  imageStore(cube, texel, vec4(mean, solidAngle));
}
