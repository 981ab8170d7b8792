// Point i of n that are all used together: a disc's spiral (Vogel 1979) where x is the square of a radius and y a turn,
// as cosine lobes and visible normals map them. Evener than the first n of a sequence, but uneven before the last one.
// The twin is optics::spiralPoint.
vec2 spiralPoint(int i, int n) {
  return vec2((float(i) + 0.5) / float(n), float(uint(i) * 2654435769u) * (1.0 / 4294967296.0));
}
