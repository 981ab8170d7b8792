// Irradiance / pi by steps in both angles over the hemisphere, at the cube's full resolution: the usual way, for
// comparison. sum L cos sin / sum cos sin.
#include "layout.h"
#include "mapping.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = sourceUnit) uniform samplerCube environment;
layout(binding = 0, rgba32f) writeonly uniform imageCube result;
layout(location = riemannStepLocation) uniform float stepAngle;

void main() {
  int size = imageSize(result).x;
  ivec3 texel = ivec3(gl_GlobalInvocationID);
  if (texel.x >= size || texel.y >= size) return;
  mat3 worldFromLocal = frameAround(normalize(directionFromCube(texel.z, (vec2(texel.xy) + 0.5) * (2.0 / float(size)) - 1.0)));
  vec3 sum = vec3(0.0);
  float weights = 0.0;
  for (float phi = 0.0; phi < 2.0 * PI; phi += stepAngle)
    for (float theta = 0.0; theta < 0.5 * PI; theta += stepAngle) {
      vec3 d = vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
      float w = cos(theta) * sin(theta);
      sum += w * textureLod(environment, worldFromLocal * d, 0.0).rgb;
      weights += w;
    }
  imageStore(result, texel, vec4(sum / weights, 1.0));
}
