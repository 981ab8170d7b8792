float glowSolidAngleDensity(vec3 radiance, float distance, float cosine) { return 0.0; }
