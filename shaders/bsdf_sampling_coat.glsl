// The coat's lobe in a whole surface's sample (bsdf_sampling.glsl), around the coat's own normal.

// Of the light that the surface reflects.
float coatChance(Surface s) { return s.coat.weight * coatAlbedo(s); }

float densityOfCoat(Surface s, vec3 L) {
  LobeFrame coat = coatFrame(s);
  return ggxDensity(coat.V, L * coat.worldFromLocal, max(s.coat.alpha, minAnalyticAlpha));
}

void drawCoat(Surface s, vec2 u, inout LobeFrame at, inout LobeSample drawn) {
  at = coatFrame(s);
  drawn = sampleCoat(at.V, max(s.coat.alpha, minAnalyticAlpha), u);
}
