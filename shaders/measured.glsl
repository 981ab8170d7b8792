// Where two directions lie in the grids of measured BRDFs, as pure functions. Directions are unit, leave the surface and
// are in tangent space: x along the tangent, z along the normal. The twin is src/optics/measured.cpp.
#include "arc_tangent.glsl"

// Rusinkiewicz 1998: theta_h, theta_d, phi_d in [0, 2 pi); from differences, so that none of them cancels.
vec3 halfDifference(vec3 V, vec3 L) {
  vec3 S = L + V, D = L - V;
  float sum = length(S), across = V.x * D.y - V.y * D.x;
  float phi = across != 0.0 || D.z != 0.0 ? arcTangent(2.0 * across, -D.z * sum) : 0.0;
  if (phi < 0.0) phi += 2.0 * PI;
  return vec3(arcTangent(length(S.xy), S.z), arcTangent(length(D), sum), phi >= 2.0 * PI ? 0.0 : phi);
}

const int merlThetaSteps = 90, merlPhiSteps = 180;
const int utiaThetaSteps = 6, utiaPhiSteps = 48;

// In cells: cell k reaches from k to k + 1. phiSteps: 180 (phi_d + pi is the same) or 360.
vec3 merlPosition(vec3 angles, float phiSteps) {
  float z = angles.z * (float(merlPhiSteps) / PI);
  return vec3(float(merlThetaSteps) * sqrt(angles.x / (0.5 * PI)), angles.y * (float(merlThetaSteps) / (0.5 * PI)),
              z >= phiSteps ? z - phiSteps : z);
}

// Entry k was measured at k.
vec2 utiaPosition(vec3 direction) {
  float theta = arcTangent(length(direction.xy), direction.z), phi = arcTangent(direction.y, direction.x);
  float y = (phi < 0.0 ? phi + 2.0 * PI : phi) * (float(utiaPhiSteps) / (2.0 * PI));
  return vec2(theta * (12.0 / PI), y >= float(utiaPhiSteps) ? 0.0 : y);
}

// Two neighbours along an axis and the share of the second.
struct GridAxis {
  int low, high;
  float share;
};
GridAxis heldAxis(float x, int steps) {
  float inside = clamp(x, 0.0, float(steps - 1));
  int low = int(inside);
  return GridAxis(low, min(low + 1, steps - 1), inside - float(low));
}
GridAxis wrappedAxis(float x, int steps) {
  float low = floor(x);
  int index = (int(low) + steps) % steps;
  return GridAxis(index, (index + 1) % steps, x - low);
}
