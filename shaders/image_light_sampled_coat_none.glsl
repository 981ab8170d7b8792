vec3 underLitCoat(Surface s, vec3 below) { return below; }
