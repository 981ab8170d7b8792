// Where nothing asks for it.
vec3 lookUpDfg(float NoV, float perceptualRoughness) { return vec3(1.0, 0.0, 0.0); }
