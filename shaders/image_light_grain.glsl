vec3 specularRadiance(Surface s) {
  return fetchLd(environmentFromWorld(specularMeanDirection(s)), s.perceptualRoughness);
}
