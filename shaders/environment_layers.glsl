// Where a roughness lies in the LD chain. Knots of perceptual roughness: 0, .05, .1, .15, .2, then steps of .1 up to 1.
// Shares its numbers with src/ibl/layers.hpp; a test holds the two together.

float ldKnot(int layer) { return layer <= 4 ? 0.05 * float(layer) : 0.1 * float(layer - 2); }

// Layer below and the weight of the one above; linear in alpha, because LD changes evenly with alpha.
void findLdLayer(float perceptualRoughness, out int layer, out float weight) {
  float r = clamp(perceptualRoughness, 0.0, 1.0);
  layer = r < 0.2 ? int(r * 20.0) : min(int(r * 10.0) + 2, 11);
  float r0 = ldKnot(layer), r1 = ldKnot(layer + 1);
  weight = clamp((r * r - r0 * r0) / (r1 * r1 - r0 * r0), 0.0, 1.0);
}
