vec3 diffusePart(vec3 light) { return light; }
vec3 specularPart(vec3 light) { return light; }
vec3 layerPart(vec3 light) { return light; }
vec3 scatteredPart(vec3 light) { return light; }
vec3 emittedPart(vec3 light) { return light; }
vec3 lightsPart(vec3 light) { return light; }
vec3 interreflectedPart(vec3 gain) { return gain; }
