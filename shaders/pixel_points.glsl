// The points that a pixel draws samples from.
#include "sobol.glsl"
#include "frame.glsl"

// A sequence of the pixel's for each lobe that is sampled, and with lampPointsOf one for the lamps that it reflects.
const uint basePoints = 0u, coatPoints = 1u, sheenPoints = 2u, multiplePoints = 3u, diffusePoints = 4u, sunPoints = 5u,
           throughPoints = 6u, maskPoints = 7u;
const uint lampPointsOf = 8u;

// Of the whole picture, wherever the rows of a band begin.
#ifdef SAMPLED_PIXEL
uvec2 sampledPixel() { return SAMPLED_PIXEL; }
#else
uvec2 sampledPixel() { return uvec2(gl_FragCoord.xy + vec2(0.0, frame.picture.z)); }
#endif

// Point i of all that the pixel's draws use, in (0, 1)^2.
vec2 samplePoint(int i, uint use) {
  return scrambledSobol2(uint(i), pairSeed(pixelSeed(sampledPixel(), uint(frame.options.w)), use));
}

// The same at all pixels: for what reads levels of a texture that lie far apart, where a driver takes one level for each
// quad of pixels.
vec2 sharedPoint(int i, uint use) { return scrambledSobol2(uint(i), pairSeed(uint(frame.options.w), use)); }
