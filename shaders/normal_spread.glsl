// A lobe over all of a pixel's normals, where the pixel is shaded once. The twin is src/optics/normal_spread.cpp.

const float largestSpread = 0.02;  // of alpha^2; beyond, the neighbours are other surfaces

// Perceptual roughness of the lobe, given how far the normal turns from a pixel to the next ones. Normals spread evenly
// over a pixel vary by |dN|^2 / 12 along each axis; half of that is added to alpha^2, because lobes of GGX have long
// tails: of 1/3 to 1/40 of |dN/dx|^2 + |dN/dy|^2 this came nearest to converged pictures.
float roughnessOverPixel(float perceptualRoughness, vec3 dNdx, vec3 dNdy) {
  float alpha = perceptualRoughness * perceptualRoughness;
  float spread = min((dot(dNdx, dNdx) + dot(dNdy, dNdy)) * (1.0 / 24.0), largestSpread);
  return sqrt(sqrt(min(alpha * alpha + spread, 1.0)));
}
