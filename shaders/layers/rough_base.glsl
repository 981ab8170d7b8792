// KHR_materials_diffuse_roughness: the roughness of what is below the dielectric's interface. Its model is EON
// (src/shading/model_features.cpp).
struct RoughBase {
  float perceptualRoughness;
};

void setRoughBase(inout RoughBase base, float perceptualRoughness) { base.perceptualRoughness = perceptualRoughness; }
float diffuseRoughness(RoughBase base, float lobes) { return base.perceptualRoughness; }
