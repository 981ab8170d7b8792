// The angle of a direction in a plane. The twin is std::atan2.
#include "constants.glsl"

// atan(y, x) by its series: off by 2e-7 of the angle, where drivers' own may be off by more than a cell's hundredth.
float arcTangent(float y, float x) {
  float a = abs(x), b = abs(y);
  float low = min(a, b), high = max(a, b);
  if (high == 0.0) return 0.0;
  bool far = low > 0.41421356 * high;  // tan(pi / 8)
  float t = far ? (low - high) / (low + high) : low / high;
  float z = t * t, series = 0.0;
  for (int k = 9; k >= 0; --k) series = 1.0 / float(2 * k + 1) - z * series;
  float angle = t * series + (far ? 0.25 * PI : 0.0);
  if (b > a) angle = 0.5 * PI - angle;
  if (x < 0.0) angle = PI - angle;
  return y < 0.0 ? -angle : angle;
}
