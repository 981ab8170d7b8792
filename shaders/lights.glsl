// KHR_lights_punctual: how much light of unit intensity arrives. The twin is src/optics/lights.cpp.

#include "mapping.glsl"

// Inverse square with the extension's range window; inverseRange2 = 1 / range^2, 0 without a range.
// Bounded for lights at the very surface: distances below 1e-6 m count as that.
float distanceAttenuation(float distance2, float inverseRange2) {
  float q = distance2 * inverseRange2;
  float window = clamp(1.0 - q * q, 0.0, 1.0);
  return window / max(distance2, 1e-12);
}

// The extension's recommended smooth cone: scale = 1 / max(0.001, cos inner - cos outer), offset = -cos outer * scale.
float coneAttenuation(float cosAngle, float scale, float offset) {
  float t = clamp(cosAngle * scale + offset, 0.0, 1.0);
  return t * t;
}

// A point of the unit square as a direction within a disc of that angular radius about the axis; equal areas.
vec3 directionInDisc(vec3 axis, float angularRadius, vec2 u) {
  float theta = angularRadius * sqrt(u.x), phi = 2.0 * PI * u.y;
  return frameAround(axis) * vec3(sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta));
}

// Width of a lobe that reflects a disc in place of a point: exact at the highlight's peak for a mirror, where the disc
// is seen (D(0) / 4 = 1 / (pi radius^2)), and for lobes much wider than the disc.
float alphaOfDisc(float alpha, float angularRadius) { return sqrt(alpha * alpha + 0.25 * angularRadius * angularRadius); }
