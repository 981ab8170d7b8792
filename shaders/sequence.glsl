// Every draw of the pixel continues the same sequence (Roberts 2018, R2), in 32-bit fixed point, where no count loses
// digits.
vec2 samplePoint(int i) {
  return vec2(uvec2(i) * uvec2(3242174889u, 2447445414u) + 0x80000000u) * (1.0 / 4294967296.0);
}

// Point i of n that are all used together: a disc's spiral (Vogel 1979) where x is the square of a radius and y a turn,
// as cosine lobes and visible normals map them. Evener than the first n of samplePoint, but uneven before the last one.
// The twin is optics::spiralPoint.
vec2 spiralPoint(int i, int n) {
  return vec2((float(i) + 0.5) / float(n), float(uint(i) * 2654435769u) * (1.0 / 4294967296.0));
}
