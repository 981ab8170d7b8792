// The lobe's mean direction.
vec3 lobeRadiance(vec3 N, vec3 V, float NoV, float perceptualRoughness, vec3 dfg) {
  return fetchLd(environmentFromWorld(meanDirection(N, V, dfg.z)), perceptualRoughness);
}
