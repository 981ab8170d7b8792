vec3 coatSampled(Surface s) {
  LobeFrame at = coatFrame(s);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleCoat(at.V, max(s.coat.alpha, leastSampledAlpha), samplePoint(i));
    if (drawn.weight <= 0.0) continue;
    sum += drawn.weight * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}

vec3 underLitCoat(Surface s, vec3 below) { return below * coatLeft(s) + s.coat.weight * coatSampled(s); }
