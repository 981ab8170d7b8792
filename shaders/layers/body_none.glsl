vec3 evaluateInside(Surface s, float eta, vec3 tint, vec3 L) { return vec3(0.0); }
float insideDensity(Surface s, float eta, vec3 L) { return 0.0; }
BsdfSample sampleInside(Surface s, float eta, vec3 u) { return BsdfSample(s.N, 0.0, throughLobe); }
