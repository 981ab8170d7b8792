// A line's pixel: covered as far as it reaches, fainter where a surface is nearer.
#include "frame.glsl"

layout(location = 0) noperspective in vec2 inAt;
layout(location = 1) flat in vec2 inSize;
layout(location = 2) flat in vec4 inColor;
layout(location = 3) flat in float inHidden;
layout(location = 4) flat in vec2 inDepths;
layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D surfaces;  // depth
layout(location = overlayDepthLocation) uniform vec4 behind;  // factor on a surface's distance and what is added to it

// The farthest of the surfaces around: lines on them stay whole, at a slant and along their outlines, too.
float surfaceDepth(ivec2 pixel) {
  ivec2 last = textureSize(surfaces, 0) - 1;
  float depth = 1.0;
  for (int y = -1; y <= 1; ++y)
    for (int x = -1; x <= 1; ++x)
      depth = min(depth, texelFetch(surfaces, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).r);
  return depth;
}

void main() {
  float beyond = max(max(-inAt.x, inAt.x - inSize.x), 0.0);
  float covered = clamp(inSize.y + 0.5 - length(vec2(beyond, inAt.y)), 0.0, 1.0);
  float along = inSize.x > 1e-4 ? clamp(inAt.x / inSize.x, 0.0, 1.0) : 0.0;  // its soft ends are no farther than the line
  bool hidden = distanceFromDepth(clamp(mix(inDepths.x, inDepths.y, along), 0.0, 1.0)) > distanceFromDepth(surfaceDepth(ivec2(gl_FragCoord.xy))) * behind.x + behind.y;
  float alpha = inColor.a * covered * (hidden ? inHidden : 1.0);
  if (alpha <= 0.0) discard;
  outColor = vec4(inColor.rgb * alpha, alpha);
}
