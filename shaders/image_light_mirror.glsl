// The split sum as Karis 2013 has it: the mirror direction, whatever the roughness.
vec3 lobeRadiance(vec3 N, vec3 V, float NoV, float perceptualRoughness, vec3 dfg) {
  return fetchLd(environmentFromWorld(reflect(-V, N)), perceptualRoughness);
}
