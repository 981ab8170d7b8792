// Which samples of its pixel a masked surface covers (glTF 2.0, 3.9.4). The texture is read for each where it is, finer
// than the pixel, so that the test stays one as long as texels can be told apart. Beyond, levels hold the share of their
// area that passes (src/frame/mask_levels.hpp), and as many samples are covered: hair and fences stay as dense as they
// are, however far.
#include "alpha_mask.glsl"
#include "pixel_points.glsl"

#ifdef HAS_BASE_COLOR_TEXTURE
// From the middle of the pixel; of four samples where most hardware has them.
vec2 coverageSample(int i, int count) {
  if (count == 1) return vec2(0.0);
  return vec2(fract(0.375 + 0.5 * float(i) - 0.25 * float(i / 2)), (float(i) + 0.5) / float(count)) - 0.5;
}

float hashedChance(uint seed) { return float(hashedBits(seed) >> 8) * (1.0 / 16777216.0); }

// In [0, 1)^2: x which shares are covered, y which level is read. Even over each square of 4 x 4 pixels, with another
// start for each and for each triangle, since layers would hide the same of what is behind. Of several draws each pixel
// has its own sequence.
vec2 maskChances(uint surface) {
  uvec2 p = sampledPixel();
  if (frame.options.z > 1.5) return fract(samplePoint(int(frame.options.y), maskPoints) + hashedChance(surface));
  uint x = p.x ^ p.y, y = p.y, order = (x & 1u) << 3 | (y & 1u) << 2 | (x & 2u) | (y & 2u) >> 1;
  uint square = surface ^ hashedBits(p.x >> 2 | p.y >> 2 << 16);
  return vec2(fract(float(order) / 16.0 + hashedChance(square)), hashedChance(square ^ order ^ 0x6c76u));
}

// texel: alpha at that level, the finest is 0; factor: on it; chance: of the share of the area that is to be covered.
bool passesMask(float texel, float factor, float level, float chance) {
  if (level < 1.0) return factor * texel >= material.alphaCutoff;
  return factor >= material.alphaCutoff && texel > maskAlpha(chance, material.maskPivot);
}

// False where none is.
bool coverMasked(Varyings v, float alpha, uint surface) {
  int count = gl_NumSamples;
  vec2 uv = slotTexCoord(v, material.baseColorSlot), size = vec2(textureSize(baseColorTexture, 0));
  vec2 dx = dFdx(uv), dy = dFdy(uv), inTexels = vec2(dot(dx * size, dx * size), dot(dy * size, dy * size));
  // Texels across the shorter axis of a sample's share: along the other one samples take their chance.
  float longest = sqrt(max(inTexels.x, inTexels.y));
  float shortest = abs(dx.x * dy.y - dx.y * dy.x) * size.x * size.y / max(longest, 1e-12);
  float draws = max(frame.options.z, 1.0);
  float level = log2(max(max(shortest, 0.125 * longest) * inversesqrt(float(count) * draws), 1e-12));
  // Shares are of the factor's threshold; where it is another one, samples take their chance of the finest level.
  if (material.maskPivot == 0.0 || v.color.a != 1.0) level = min(level, 0.0);
  vec2 chances = maskChances(surface);
  // Texels up to two a sample, shares from four on: what is between does not mix.
  level = level > 1.0 + chances.y ? min(level, float(textureQueryLevels(baseColorTexture) - 1)) : 0.0;
  vec2 read = exp2(level) * (draws > 1.5 ? 4.0 * sqrt(draws) : 1.0) / size;  // without the sampler's bias (setTextureDetail)
  if (level <= 0.0) read *= 0.5;
  float factor = material.baseColorFactor.a * v.color.a;
  int covered = 0, turn = int(chances.x * float(count));
  for (int i = 0; i < count; ++i) {
    vec2 at = coverageSample(i, count);
    float texel = textureGrad(baseColorTexture, uv + at.x * dx + at.y * dy, vec2(read.x, 0.0), vec2(0.0, read.y)).a;
    float stratum = (float((i + turn) % count) + fract(chances.x * float(count))) / float(count);
    covered |= passesMask(texel, factor, level, stratum) ? 1 << i : 0;
  }
  gl_SampleMask[0] = covered;
  return covered != 0;
}
#else
bool coverMasked(Varyings v, float alpha, uint surface) { return alpha >= material.alphaCutoff; }
#endif
