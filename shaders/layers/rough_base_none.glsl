// The diffuse part is as rough as the lobes, where its model asks.
struct RoughBase {
  bool none;
};

void setRoughBase(inout RoughBase base, float perceptualRoughness) {}
float diffuseRoughness(RoughBase base, float lobes) { return lobes; }
