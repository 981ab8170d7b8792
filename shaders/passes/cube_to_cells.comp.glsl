// A cube map level as cells of cellTexels^2 texels, for passes that sum over the whole sphere. cells[cellVectors i] = centroid of
// the cell and variance about it (per axis, of unit vectors), cells[cellVectors i + 1] = the same of its luminance,
// cells[cellVectors i + 2] = mean radiance, solid angle. Centroids lie within the sphere: kernels that are linear over a cell
// are summed exactly.
#include "layout.h"
#include "luminance.glsl"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) readonly uniform imageCube cube;
layout(std430, binding = computeOutputBinding) writeonly buffer CellBlock { vec4 cells[]; };
layout(location = cellTexelsLocation) uniform int cellTexels;

// |d| = 1: the variances along all three axes sum to 1 - |mean|^2, those along the sphere are two of them.
float varianceAbout(vec3 mean) { return max(0.0, 0.5 - 0.5 * dot(mean, mean)); }

void main() {
  int texels = imageSize(cube).x, size = texels / cellTexels;
  ivec3 cell = ivec3(gl_GlobalInvocationID);
  if (cell.x >= size || cell.y >= size) return;
  vec3 middle = vec3(0.0), radiance = vec3(0.0), bright = vec3(0.0);
  float solidAngle = 0.0, brightness = 0.0;
  for (int y = 0; y < cellTexels; ++y)
    for (int x = 0; x < cellTexels; ++x) {
      ivec2 texel = cell.xy * cellTexels + ivec2(x, y);
      vec3 d = normalize(directionFromCube(cell.z, (vec2(texel) + 0.5) * (2.0 / float(texels)) - 1.0));
      vec4 value = imageLoad(cube, ivec3(texel, cell.z));
      float light = value.a * luminance(value.rgb);
      solidAngle += value.a;
      middle += value.a * d;
      radiance += value.a * value.rgb;
      brightness += light;
      bright += light * d;
    }
  middle /= solidAngle;
  bright = brightness > 0.0 ? bright / brightness : middle;
  int index = cellVectors * ((cell.z * size + cell.y) * size + cell.x);
  cells[index] = vec4(middle, varianceAbout(middle));
  cells[index + 1] = vec4(bright, varianceAbout(bright));
  cells[index + 2] = vec4(radiance / solidAngle, solidAngle);
}
