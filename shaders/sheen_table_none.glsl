#include "layers/sheen_none.glsl"

float lookUpSheenAlbedo(float NoX, float perceptualRoughness) { return 0.0; }
void lightSheen(inout Sheen sheen, float NoL) {}
