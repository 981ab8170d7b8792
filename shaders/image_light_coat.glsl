// What the layers below send, and what the coat adds.
vec3 underLitCoat(Surface s, vec3 below) {
  vec3 reflected = lobeRadiance(s.coat.N, s.V, s.coat.NoV, s.coat.perceptualRoughness, s.coat.dfg);
  return below * coatLeft(s) + layerPart(s.coat.weight * coatAlbedo(s) * reflected);
}
