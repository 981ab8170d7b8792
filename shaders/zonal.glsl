// Sums over the sphere of few cells of radiance. The twin is src/optics/zonal.cpp.

// Mean of max(x, 0) over x spread evenly about c with that variance: what a cell of that size sends across the horizon.
float spreadCosine(float c, float variance) {
  float halfWidth = sqrt(3.0 * variance);
  if (abs(c) >= halfWidth) return max(c, 0.0);
  float above = c + halfWidth;
  return above * above / (4.0 * halfWidth);
}

// D(H) NoL of N = V = R, but for a factor, at the cosine c of light and normal, for light spread about it.
float spreadZonalKernel(float c, float variance, float alpha2) {
  float y = mix(1.0, alpha2, 0.5 + 0.5 * c);  // sin^2 + alpha^2 cos^2 of the half angle
  return spreadCosine(c, variance) / (y * y);
}
