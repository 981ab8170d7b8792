struct Sheen {
  bool none;
};

void setSheen(inout Sheen sheen, vec3 color, float perceptualRoughness, float albedoV) {}
float sheenLeft(Sheen sheen) { return 1.0; }
vec3 underSheen(Sheen sheen, vec3 below, vec3 N, vec3 V, float NoV, vec3 L) { return below; }
