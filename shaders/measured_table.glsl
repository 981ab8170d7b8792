// Look-ups in the measured BRDF that is bound. The twin is src/optics/measured.cpp.
#include "layout.h"
#include "measured.glsl"

// What a cell is stored as: three halves and their unit, or what is there to be compared with (facet report measured):
// MEASURED_THREE_FLOATS, MEASURED_FOUR_FLOATS, MEASURED_SHARED_EXPONENT.
layout(std430, binding = measuredBinding) readonly buffer MeasuredBlock {
  MeasuredUniforms measured;
#if defined MEASURED_THREE_FLOATS
  float measuredCells[];  // the first is negative where nothing was measured
#elif defined MEASURED_FOUR_FLOATS
  vec4 measuredCells[];  // the same, and one that is not used
#elif defined MEASURED_SHARED_EXPONENT
  uint measuredCells[];  // 9, 9 and 9 bits and an exponent of 5 (RGB9_E5); all bits set where nothing was measured
#else
  uvec2 measuredCells[];  // three halves in units of the fourth; the first as of floats
#endif
};

// rgb, and 1; or nothing.
vec4 measuredCell(int index) {
#if defined MEASURED_THREE_FLOATS
  vec3 value = vec3(measuredCells[3 * index], measuredCells[3 * index + 1], measuredCells[3 * index + 2]);
#elif defined MEASURED_FOUR_FLOATS
  vec3 value = measuredCells[index].rgb;
#elif defined MEASURED_SHARED_EXPONENT
  uint cell = measuredCells[index];
  // 2^(exponent - 15 - 9), put together from its bits.
  float unit = uintBitsToFloat((cell >> 27) + 103u << 23) * measured.table.y;
  vec3 value = cell == 0xffffffffu ? vec3(-1.0) : unit * vec3(cell & 511u, cell >> 9 & 511u, cell >> 18 & 511u);
#else
  uvec2 cell = measuredCells[index];
  vec2 high = unpackHalf2x16(cell.y);
  vec3 value = vec3(unpackHalf2x16(cell.x), high.x) * high.y;
#endif
  return value.r < 0.0 ? vec4(0.0) : vec4(value, 1.0);
}

vec3 renormalized(vec4 sum) { return sum.a > 0.0 ? sum.rgb / sum.a : vec3(0.0); }

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
