// Every draw of the pixel continues the same sequence (Roberts 2018, R2), in 32-bit fixed point, where no count loses
// digits.
vec2 samplePoint(int i) {
  return vec2(uvec2(i) * uvec2(3242174889u, 2447445414u) + 0x80000000u) * (1.0 / 4294967296.0);
}
