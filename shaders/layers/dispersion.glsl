// KHR_materials_dispersion: red and blue see through the body at indices of their own.

// Into what is seen at the index itself.
void disperse(Surface s, vec3 position, float ior, float thickness, inout vec4 behind, inout vec3 open) {
  vec3 iors = dispersedIors(ior, material.dispersion);
  vec4 red = seenThrough(s, position, passageThrough(s, iors.r, thickness));
  vec4 blue = seenThrough(s, position, passageThrough(s, iors.b, thickness));
  behind.rb = vec2(red.r, blue.b);
  open.rb = vec2(1.0 - red.a, 1.0 - blue.a);
}
