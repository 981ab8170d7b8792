vec3 underLitSheen(Surface s, vec3 below, vec3 irradiance) { return below; }
