vec3 sheenSampled(Surface s) {
  LobeFrame at = normalFrame(s);
  float guard = sheenGainGuard(s.sheen.albedoV, s.sheen.albedoL);
  vec3 sum = vec3(0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleSheen(at.V, s.sheen.alpha, lightPoint(i, sheenPoints));
    sum += drawn.weight * guard * sampledRadiance(at.worldFromLocal * drawn.L, drawn.density);
    if (!lampsThere()) continue;
    LampSample lamp = sampleLamps(i, sheenPoints);
    vec3 L = lamp.L * at.worldFromLocal;
    sum += lamp.radiance * (sheenValue(at.V, L, s.sheen.alpha) * guard / (lamp.density + sheenDensity(L)));
  }
  return sum / float(IMAGE_LIGHT_SAMPLES);
}

vec3 underLitSheen(Surface s, vec3 below) { return below * sheenLeft(s) + layerPart(s.sheen.color * sheenSampled(s)); }
