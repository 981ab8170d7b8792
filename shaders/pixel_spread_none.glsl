float spreadRoughness(float perceptualRoughness, vec3 N) { return perceptualRoughness; }
