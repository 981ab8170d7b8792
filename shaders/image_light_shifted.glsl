// The mirror direction moved towards N (Lagarde and de Rousiers 2014, "Moving Frostbite to PBR", section 4.9.3).
vec3 lobeRadiance(vec3 N, vec3 V, float NoV, float perceptualRoughness, vec3 dfg) {
  float alpha = perceptualRoughness * perceptualRoughness;
  float smoothness = 1.0 - alpha;
  vec3 d = mix(N, reflect(-V, N), smoothness * (sqrt(smoothness) + alpha));
  return fetchLd(environmentFromWorld(d), perceptualRoughness);
}
