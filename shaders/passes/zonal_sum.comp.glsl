// The kernel D(H) NoL of N = V = R summed over all cells of passes/cube_to_cells.comp.glsl: sum K L dw / sum K dw, exact
// for a constant map whatever their number. alpha = 1: irradiance / pi.
#include "layout.h"
#include "mapping.glsl"
#include "zonal.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(std430, binding = computeInputBinding) readonly buffer CellBlock { vec4 cells[]; };
layout(binding = 0, rgba32f) writeonly uniform imageCube result;
layout(location = sumAlpha2Location) uniform float alpha2;

const int tileCells = groupInvocations;  // read once by a group
shared vec4 tile[cellVectors * tileCells];

void main() {
  int size = imageSize(result).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int count = cells.length() / cellVectors, mine = int(gl_LocalInvocationIndex);
  for (int first = 0; first < count; first += tileCells) {
    int present = min(tileCells, count - first);
    barrier();
    if (mine < present)
      for (int k = 0; k < cellVectors; ++k) tile[cellVectors * mine + k] = cells[cellVectors * (first + mine) + k];
    barrier();
    for (int i = 0; i < present; ++i) {
      vec4 whole = tile[cellVectors * i], bright = tile[cellVectors * i + 1], radiance = tile[cellVectors * i + 2];
      weights += radiance.a * spreadZonalKernel(dot(N, whole.xyz), whole.w, alpha2);
      sum += radiance.a * spreadZonalKernel(dot(N, bright.xyz), bright.w, alpha2) * radiance.rgb;
    }
  }
  if (texel.x < size && texel.y < size) imageStore(result, texel, vec4(sum / weights, 1.0));
}
