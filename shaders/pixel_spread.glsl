// Of the pixel that is being shaded.
#include "normal_spread.glsl"

float spreadRoughness(float perceptualRoughness, vec3 N) { return roughnessOverPixel(perceptualRoughness, dFdx(N), dFdy(N)); }
