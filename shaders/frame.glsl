#include "layout.h"

layout(std140, binding = frameBinding) uniform FrameBlock { FrameUniforms frame; };

vec3 environmentFromWorld(vec3 d) {
  float c = frame.environmentRotation.x, s = frame.environmentRotation.y;
  return vec3(c * d.x - s * d.z, d.y, s * d.x + c * d.z);
}
vec3 worldFromEnvironment(vec3 d) {
  float c = frame.environmentRotation.x, s = frame.environmentRotation.y;
  return vec3(c * d.x + s * d.z, d.y, c * d.z - s * d.x);
}

// Along the view's axis.
float distanceFromDepth(float depth) {
  vec4 k = frame.distanceFromDepth;
  return (k.y - k.w * depth) / max(k.x - k.z * depth, 1e-30);
}
