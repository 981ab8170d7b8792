float roughnessOverPixel(float perceptualRoughness, vec3 dNdx, vec3 dNdy) { return perceptualRoughness; }
