vec3 underLitSheen(Surface s, vec3 below) { return below; }
