vec3 standingNormal(vec3 N, Varyings v, vec3 V) { return N; }
