void disperse(Surface s, vec3 position, float ior, float thickness, inout vec4 behind, inout vec3 open) {}
