struct Coat {
  bool none;
};

void setCoat(inout Coat coat, vec3 N, float NoV, float weight, float perceptualRoughness, vec3 dfg) {}
void spreadCoat(inout Coat coat, float angularRadius) {}
void widenCoat(inout Coat coat, float alpha) {}
float coatAlbedo(Coat coat) { return 0.0; }
float coatLeft(Coat coat) { return 1.0; }
vec3 underCoat(Coat coat, vec3 below, vec3 V, vec3 L) { return below; }
