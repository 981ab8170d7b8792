vec3 coatSampled(Surface s) {
  LobeFrame at = coatFrame(s);
  float alpha = max(s.coat.alpha, leastSampledAlpha);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleCoat(at.V, alpha, lightPoint(i, coatPoints));
    if (drawn.weight > 0.0) sum += drawn.weight * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, coatPoints);
    vec3 L = lamp.L * at.worldFromLocal;
    float value = ggxValue(at.V, L, alpha) * F_Coat(dot(at.V, halfVector(at.V, L)));
    sum += lamp.radiance * (value / (lamp.density + ggxDensity(at.V, L, alpha)));
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}

vec3 underLitCoat(Surface s, vec3 below) { return below * coatLeft(s) + layerPart(s.coat.weight * coatSampled(s)); }
