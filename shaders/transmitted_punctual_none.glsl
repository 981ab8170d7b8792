vec3 punctualThrough(Surface s, vec3 position, Passage passage) { return vec3(0.0); }
