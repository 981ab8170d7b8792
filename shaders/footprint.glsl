// How a pixel's footprint on a texture is read. The twin is src/optics/footprint.cpp.

// x: how many reads share the footprint; y: factor on the derivatives for each of them. dx, dy: texels to the next pixels;
// mostStretch: longer over shorter axis that counts, 1: one read as it is. Axes below a texel count as one. A read takes
// up to twice as much along the axis as across: its level is that of the mean of the two.
vec2 footprintReads(vec2 dx, vec2 dy, float mostStretch) {
  float longest2 = max(dot(dx, dx), dot(dy, dy));
  float area = abs(dx.x * dy.y - dx.y * dy.x);
  float stretch = clamp(longest2 / max(max(area, sqrt(longest2)), 1e-12), 1.0, mostStretch);
  float reads = ceil(0.5 * stretch);
  return vec2(reads, inversesqrt(stretch * reads));
}
