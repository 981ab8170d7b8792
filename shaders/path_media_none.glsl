vec3 mediumTransmittance(uvec2 media, float distance) { return vec3(1.0); }
uvec2 mediaOf(PathState p) { return uvec2(0u); }
