// The kernel D(H) NoL of N = V = R summed over the whole sphere: sum K L dw / sum K dw, exact for a constant map
// whatever the texel count. alpha = 1: irradiance / pi. list[2 i] = (direction, solid angle), list[2 i + 1] = radiance.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = computeInputBinding) readonly buffer ListBlock { vec4 list[]; };
layout(binding = 0, rgba32f) writeonly uniform imageCube result;
layout(location = 0) uniform float alpha2;
layout(location = 1) uniform int firstFace;

void main() {
  int size = imageSize(result).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID) + ivec3(0, 0, firstFace);
  if (texel.x >= size || texel.y >= size) return;
  vec3 N = normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  int count = list.length() / 2;
  for (int i = 0; i < count; ++i) {
    vec4 d = list[2 * i];
    float c = dot(N, d.xyz);
    float y = mix(1.0, alpha2, 0.5 + 0.5 * c);  // sin^2 + alpha^2 cos^2 of the half angle
    float w = max(c, 0.0) / (y * y) * d.w;
    sum += w * list[2 * i + 1].rgb;
    weights += w;
  }
  imageStore(result, texel, vec4(sum / weights, 1.0));
}
