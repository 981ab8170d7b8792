// Alpha in the smaller levels of a masked texture. The twin is src/optics/alpha_mask.cpp.

// Alpha that stands for a share of the area that passes the test; pivot: alpha of a half.
float maskAlpha(float share, float pivot) {
  return share < 0.5 ? 2.0 * share * pivot : pivot + (2.0 * share - 1.0) * (1.0 - pivot);
}
