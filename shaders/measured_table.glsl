// Look-ups in the measured BRDF that is bound. The twin is src/optics/measured.cpp.
#include "layout.h"
#include "measured.glsl"

layout(std430, binding = measuredBinding) readonly buffer MeasuredBlock {
  MeasuredUniforms measured;
  uvec2 measuredCells[];  // three halves in units of the scale; the first is negative where nothing was measured
};

// rgb, and 1; or nothing.
vec4 measuredCell(int index) {
  uvec2 cell = measuredCells[index];
  vec3 value = vec3(unpackHalf2x16(cell.x), unpackHalf2x16(cell.y).x);
  return value.r < 0.0 ? vec4(0.0) : vec4(value, 1.0);
}

vec3 renormalized(vec4 sum) { return sum.a > 0.0 ? sum.rgb * (measured.table.y / sum.a) : vec3(0.0); }

#ifdef UTIA_BRDF
int utiaEntry(vec2 at) {
  return min(int(at.x + 0.5), utiaThetaSteps - 1) * utiaPhiSteps + int(at.y + 0.5) % utiaPhiSteps;
}
vec3 lookUpMeasured(vec3 V, vec3 L) {
  const int directions = utiaThetaSteps * utiaPhiSteps;
  vec2 atV = utiaPosition(V), atL = utiaPosition(L);
#ifdef MEASURED_NEAREST
  return renormalized(measuredCell(utiaEntry(atL) * directions + utiaEntry(atV)));
#else
  GridAxis axes[4] = GridAxis[](heldAxis(atL.x, utiaThetaSteps), wrappedAxis(atL.y, utiaPhiSteps),
                                heldAxis(atV.x, utiaThetaSteps), wrappedAxis(atV.y, utiaPhiSteps));
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 16; ++corner) {
    float weight = 1.0;
    int index = 0;
    for (int a = 0; a < 4; ++a) {
      bool high = (corner >> a & 1) != 0;
      weight *= high ? axes[a].share : 1.0 - axes[a].share;
      index = index * ((a & 1) == 0 ? utiaThetaSteps : utiaPhiSteps) + (high ? axes[a].high : axes[a].low);
    }
    if (weight > 0.0) sum += weight * measuredCell(index);
  }
  return renormalized(sum);
#endif
}
#else
vec3 lookUpMeasured(vec3 V, vec3 L) {
  int phiSteps = int(measured.table.z);
  vec3 at = merlPosition(halfDifference(V, L), measured.table.z);
#ifdef MEASURED_NEAREST
  ivec3 cell = clamp(ivec3(at), ivec3(0), ivec3(merlThetaSteps - 1, merlThetaSteps - 1, phiSteps - 1));
  return renormalized(measuredCell((cell.x * merlThetaSteps + cell.y) * phiSteps + cell.z));
#else
  GridAxis x = heldAxis(at.x - 0.5, merlThetaSteps), y = heldAxis(at.y - 0.5, merlThetaSteps);
  GridAxis z = wrappedAxis(at.z - 0.5, phiSteps);
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 4; ++corner) {
    bool highX = (corner & 1) != 0, highY = (corner & 2) != 0;
    float weight = (highX ? x.share : 1.0 - x.share) * (highY ? y.share : 1.0 - y.share);
    if (weight <= 0.0) continue;
    int row = ((highX ? x.high : x.low) * merlThetaSteps + (highY ? y.high : y.low)) * phiSteps;
    sum += weight * ((1.0 - z.share) * measuredCell(row + z.low) + z.share * measuredCell(row + z.high));
  }
  return renormalized(sum);
#endif
}
#endif

// f_r [1/sr], linear RGB; 0 below the horizon.
vec3 measuredBrdf(vec3 V, vec3 L) { return V.z > 0.0 && L.z > 0.0 ? lookUpMeasured(V, L) : vec3(0.0); }
