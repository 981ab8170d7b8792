// Light that shines through: what is behind, from the copy of the frame (src/frame/behind.hpp), and the lights beyond.
// What is outside the picture is taken to be as its edge; what transmits light itself is not in the copy.
#include "transmitted.glsl"
#include "bsdf.glsl"
#include "frame.glsl"
#ifdef IMAGE_LIGHT_SAMPLES
#include "lobe_frames.glsl"
#include "pixel_points.glsl"
#endif
#include "material.glsl"
#include "layers/volume.glsl" if HAS_VOLUME

layout(binding = opaqueFrameUnit) uniform sampler2D behindColor;
layout(binding = opaqueDepthUnit) uniform sampler2D behindDepth;

// How light passes at one point.
struct Passage {
  vec3 ray;     // from where it enters to where it leaves, metres; 0: a thin wall
  float alpha;  // transmittedAlpha
};

// Pixel of the target where a point (w 1) or direction (w 0) is seen; otherwise where that is behind the viewer.
vec2 behindPixel(vec4 world, vec2 otherwise) {
  vec4 clip = frame.clipFromWorld * world;
  if (clip.w <= 0.0) return otherwise;
  vec2 limit = 8.0 * frame.picture.xy;
  return clamp((0.5 * clip.xy / clip.w + 0.5) * frame.picture.xy, -limit, limit) - vec2(0.0, frame.picture.z);
}

vec4 behindSharp(vec2 pixel) { return textureLod(behindColor, pixel / vec2(textureSize(behindColor, 0)), 0.0); }

// Cubic B-spline by four linear lookups (Sigg and Hadwiger 2005).
vec4 behindSpline(vec2 pixel, int level) {
  vec2 size = vec2(textureSize(behindColor, level));
  vec2 at = clamp(pixel * exp2(-float(level)), vec2(0.0), size) - 0.5;
  vec2 i = floor(at), f = at - i, g = 1.0 - f;
  vec2 w0 = g * g * g / 6.0, w3 = f * f * f / 6.0;
  vec2 w1 = 2.0 / 3.0 - 0.5 * f * f * (2.0 - f);
  vec2 left = w0 + w1, right = 1.0 - left;
  vec2 low = (i - 0.5 + w1 / left) / size, high = (i + 1.5 + w3 / right) / size;
  float lod = float(level);
  return left.y * (left.x * textureLod(behindColor, low, lod) + right.x * textureLod(behindColor, vec2(high.x, low.y), lod)) +
         right.y * (left.x * textureLod(behindColor, vec2(low.x, high.y), lod) + right.x * textureLod(behindColor, high, lod));
}

// Even and odd levels by one lookup each: some drivers take one level for each quad of pixels, and where the pair of
// levels changes, the one that both pairs share has all the weight.
vec4 behindBlurred(vec2 pixel, float variance) {
  if (variance <= 1e-4) return behindSharp(pixel);
  int level;
  float weight;
  findBehindLevel(variance, textureQueryLevels(behindColor), level, weight);
  bool lowIsEven = (level & 1) == 0;
  int even = lowIsEven ? level : level + 1, odd = lowIsEven ? level + 1 : level;
  vec4 atOdd = odd < 0 ? behindSharp(pixel) : behindSpline(pixel, odd);
  return mix(behindSpline(pixel, even), atOdd, lowIsEven ? weight : 1.0 - weight);
}

// Along the view's axis.
float axisDistance(vec3 position) { return dot(frame.eye.xyz - position, frame.towardsEye.xyz); }

// Mean distance of what is behind, about `radius` pixels around; large for the sky.
float behindDistance(vec2 pixel, float radius) {
  float level = min(log2(max(radius, 1.0)), float(textureQueryLevels(behindDepth) - 1));
  int fine = int(level);
  vec2 at = pixel * exp2(-float(fine)) / vec2(textureSize(behindDepth, fine));
  return distanceFromDepth(textureLod(behindDepth, at, float(fine)).r);
}

// Pixels that a metre at that distance along the axis takes.
float pixelsPerMetre(float along) { return frame.picture.w / (frame.eye.w > 0.5 ? max(along, 1e-30) : 1.0); }

// What a smooth surface that bends the view magnifies or shrinks: the picture's own pixels, averaged.
float footprintVariance(vec2 pixel) {
  vec2 size2 = dFdx(pixel) * dFdx(pixel) + dFdy(pixel) * dFdy(pixel);
  return max(0.5 * (size2.x + size2.y) - 1.0, 0.0) * (1.0 / 12.0) / frame.options.z;
}

#ifdef IMAGE_LIGHT_SAMPLES
// A sample reads four times its share of the lobe, as Krivanek and Colbert (2008) advise.
const float behindGain = 4.0;

// The lobe itself, each sample at the pixel where it meets a plane at the distance of what is behind.
vec4 behindSampled(Surface s, vec3 from, vec2 pixel, float along, float alpha) {
  LobeFrame at = normalFrame(s);
  float start = axisDistance(from), perMetre = pixelsPerMetre(along) * max(along - start, 0.0);
  int first = int(frame.options.y) * IMAGE_LIGHT_SAMPLES;
  float total = float(IMAGE_LIGHT_SAMPLES) * frame.options.z;
  vec4 sum = vec4(0.0);
  float weights = 0.0;
  for (int i = first; i < first + IMAGE_LIGHT_SAMPLES; ++i) {
    LobeSample drawn = sampleTransmitted(at.V, alpha, sharedPoint(i, throughPoints));
    vec3 away = at.worldFromLocal * drawn.L;
    float forward = -dot(away, frame.towardsEye.xyz);
    // The same points at all pixels, and no branch: a driver takes one level for each quad of pixels, and those of pixels that are left out are anything.
    float weight = forward > 0.0 ? drawn.weight : 0.0;
    float paths = max(along - start, 0.0) / max(forward, 1e-6);  // length until the plane
    vec2 seen = behindPixel(paths > 1e6 ? vec4(away + from / paths, 1.0 / paths) : vec4(from + away * paths, 1.0), pixel);
    float variance = perMetre * perMetre * behindGain / (total * drawn.density * 4.0 * PI);
    sum += weight * behindBlurred(seen, variance);
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : behindSharp(pixel);
}
#endif

// What is behind a point that is left by a lobe of that alpha. rgb radiance, a how much of the view it covers.
vec4 seenThrough(Surface s, vec3 position, Passage passage) {
  vec3 from = position + passage.ray;
  vec2 here = gl_FragCoord.xy;
  vec2 pixel = passage.ray == vec3(0.0) ? here : behindPixel(vec4(from, 1.0), here);
  float sharp = passage.ray == vec3(0.0) ? 0.0 : footprintVariance(pixel);
  if (passage.alpha <= 0.0) return behindBlurred(pixel, sharp);
  // Pixels of blur by the distance behind, which is the mean of where the blur reaches: two steps from infinity.
  float start = axisDistance(position), a = 2.0 * passage.alpha;
  float reach = frame.eye.w > 0.5 ? a * frame.picture.w : frame.picture.y;
  float along = 0.0;
  for (int i = 0; i < 2; ++i) {
    along = behindDistance(pixel, min(reach, frame.picture.y));
    reach = a * max(along - start, 0.0) * pixelsPerMetre(along);
  }
#ifdef IMAGE_LIGHT_SAMPLES
  return behindSampled(s, from, pixel, along, max(passage.alpha, 1e-5));
#else
  vec2 deviations = reach * transmittedBlur.xz;
  vec2 variances = deviations * deviations + sharp;
  return transmittedBlur.y * behindBlurred(pixel, variances.x) + transmittedBlur.w * behindBlurred(pixel, variances.y);
#endif
}

Passage passageThrough(Surface s, float ior, float thickness) {
  return Passage(bodyRay(s.V, s.N, ior, thickness), transmittedAlpha(s.perceptualRoughness, ior, thickness > 0.0));
}

#include "transmitted_punctual.glsl" if HAS_PUNCTUAL_LIGHTS
#include "layers/dispersion.glsl" if HAS_DISPERSION

// Adds what shines through to the radiance and returns how much of the view is covered. share: transmittedShare.
// Where nothing is behind, the picture stays see-through. A tint has no place in coverage: before a known colour it is
// added to the radiance, before an unknown one coverage takes its mean.
float addTransmittedLight(Surface s, Varyings v, float transmitted, inout vec3 radiance) {
  vec3 share = transmitted * s.baseColor * enteringShare(s);
  float ior = material.ior, thickness = materialThickness(v);
  Passage passage = passageThrough(s, ior, thickness);
  vec4 behind = seenThrough(s, v.position, passage);
  vec3 open = vec3(1.0 - behind.a);
  disperse(s, v.position, ior, thickness, behind, open);
  share *= leftAfter(length(passage.ray));
  radiance += share * behind.rgb * frame.stored.y;
  radiance += layerPart(share * punctualThrough(s, v.position, passage));
  open = clamp(share * open, 0.0, 1.0);
  if (frame.backdrop.w < 0.5) return 1.0 - dot(open, vec3(1.0 / 3.0));
  float white = min(open.r, min(open.g, open.b));
  radiance += (open - white) * frame.backdrop.rgb;
  return 1.0 - white;
}
