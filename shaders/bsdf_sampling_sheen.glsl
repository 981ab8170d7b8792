// Sheen's lobe in a whole surface's sample (bsdf_sampling.glsl), around the base's normal.

// Of the light that the surface reflects.
float sheenChance(Surface s) { return meanOf(s.sheen.color) * min(s.sheen.albedoV, 1.0) * coatLeft(s); }

float densityOfSheen(vec3 local) { return sheenDensity(local); }

void drawSheen(Surface s, vec2 u, inout LobeFrame at, inout LobeSample drawn) {
  drawn = sampleSheen(at.V, s.sheen.alpha, u);
}
