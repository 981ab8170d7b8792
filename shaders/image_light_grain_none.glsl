// Mean radiance under the base's lobe.
vec3 specularRadiance(Surface s) { return lobeRadiance(s.N, s.V, s.NoV, s.perceptualRoughness, s.dfg); }
