float environmentShare(float textureShare) { return textureShare; }
vec3 interreflected(float share, vec3 albedo) { return vec3(1.0); }
