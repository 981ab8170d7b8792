// Directions of an environment, drawn by how much its texels radiate: a table of their shares, halved along
// both axes from level to level until one is left. A texel of the texture holds the shares of four (upper left, upper
// right, lower left, lower right). Within a texel of the table all directions are alike. The twin is
// src/optics/environment_texels.cpp.
#include "layout.h"
#include "mapping.glsl"

layout(binding = environmentTexelsUnit) uniform sampler2D environmentTexels;

// Solid angle of a texel in that row of a table of that size [sr].
float texelSolidAngle(uint row, vec2 size) {
  // sin a - sin b = 2 cos((a + b) / 2) sin((a - b) / 2), latitudes of the row's edges
  float middle = PI * ((float(row) + 0.5) / size.y - 0.5), halfHeight = 0.5 * PI / size.y;
  return 2.0 * cos(middle) * sin(halfHeight) * (2.0 * PI / size.x);
}

// Density of a direction in the environment's space [1/sr].
float texelDensity(vec3 direction) {
  vec2 size = 2.0 * vec2(textureSize(environmentTexels, 0));
  uvec2 texel = min(uvec2(equirectFromDirection(direction) * size), uvec2(size) - 1u);
  vec4 shares = texelFetch(environmentTexels, ivec2(texel / 2u), 0);
  return shares[(texel.x & 1u) + 2u * (texel.y & 1u)] / texelSolidAngle(texel.y, size);
}

struct TexelSample {
  vec3 direction;  // in the environment's space
  float density;   // [1/sr]
};

// Takes a half by its share of both and stretches what is left of u to [0, 1).
bool takeSecond(float first, float second, inout float u) {
  float share = first + second > 0.0 ? first / (first + second) : 0.5;
  bool taken = u >= share;
  u = taken ? (u - share) / (1.0 - share) : u / share;
  u = clamp(u, 0.0, 0.99999994);
  return taken;
}

// u in [0, 1)^2.
TexelSample sampleTexels(vec2 u) {
  uvec2 texel = uvec2(0u);
  vec4 shares = vec4(0.0);
  uint which = 0u;
  for (int level = textureQueryLevels(environmentTexels) - 1; level >= 0; --level) {
    shares = texelFetch(environmentTexels, ivec2(texel), level);
    bool lower = takeSecond(shares.x + shares.y, shares.z + shares.w, u.y);
    vec2 row = lower ? shares.zw : shares.xy;
    bool right = takeSecond(row.x, row.y, u.x);
    which = (right ? 1u : 0u) + (lower ? 2u : 0u);
    texel = 2u * texel + uvec2(right ? 1u : 0u, lower ? 1u : 0u);
  }
  vec2 size = 2.0 * vec2(textureSize(environmentTexels, 0));
  float top = sin(PI * (0.5 - float(texel.y) / size.y)), bottom = sin(PI * (0.5 - float(texel.y + 1u) / size.y));
  float y = mix(top, bottom, u.y), across = sqrt(max(1.0 - y * y, 0.0));
  float azimuth = 2.0 * PI * ((float(texel.x) + u.x) / size.x - 0.5);
  return TexelSample(vec3(across * cos(azimuth), y, across * sin(azimuth)), shares[which] / texelSolidAngle(texel.y, size));
}
