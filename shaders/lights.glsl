// KHR_lights_punctual: how much light of unit intensity arrives. The twin is src/optics/lights.cpp.

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
