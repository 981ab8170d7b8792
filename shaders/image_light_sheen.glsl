vec3 sheenRadiance(Surface s, vec3 irradiance) { return irradiance; }
