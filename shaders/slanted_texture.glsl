// A texture seen at a slant, read along the longer axis of the pixel's footprint by a sampler that filters equally in all
// directions.
#include "footprint.glsl"

vec4 readTexture(sampler2D image, vec2 uv, float mostStretch) {
  vec2 dx = dFdx(uv), dy = dFdy(uv), size = vec2(textureSize(image, 0));
  vec2 reads = footprintReads(dx * size, dy * size, mostStretch);
  vec2 lengths = vec2(dot(dx * size, dx * size), dot(dy * size, dy * size));
  vec2 along = (lengths.x > lengths.y ? dx : dy) / reads.x;
  vec2 at = uv - along * (0.5 * reads.x - 0.5);
  vec4 sum = vec4(0.0);
  float left = reads.x;
  do {
    sum += textureGrad(image, at, dx * reads.y, dy * reads.y);
    at += along;
    left -= 1.0;
  } while (left > 0.5);
  return sum / reads.x;
}
