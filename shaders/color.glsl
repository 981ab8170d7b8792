// Display: exposure is applied before; linear Rec. 709 in, linear [0, 1] out, then the sRGB curve.
// The twin is src/optics/color.cpp.
#include "choices.glsl"

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 c) {
  c = clamp(c, 0.0, 1.0);
  return mix(c * 12.92, 1.055 * pow(max(c, 0.0031308), vec3(1.0 / 2.4)) - 0.055, greaterThan(c, vec3(0.0031308)));
}

vec3 decodeSrgb(vec3 c) {
  return mix(c / 12.92, pow((max(c, 0.04045) + 0.055) / 1.055, vec3(2.4)), greaterThan(c, vec3(0.04045)));
}

// Reinhard et al. 2002, eq. 3, per channel.
vec3 toneReinhard(vec3 c) { return c / (1.0 + c); }

// For bytes that are encoded by the power 1 / 2.2.
vec3 toneReinhardPower(vec3 c) { return decodeSrgb(pow(toneReinhard(min(c, 1e15)), vec3(1.0 / 2.2))); }

// Hable 2010, "Uncharted 2: HDR Lighting"; white 11.2, exposure bias 2.
vec3 hable(vec3 x) {
  return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3;
}
vec3 toneUncharted2(vec3 c) { return clamp(hable(2.0 * min(c, 1e6)) / hable(vec3(11.2)), 0.0, 1.0); }

// Hill 2016, a fit of the ACES RRT and ODT, without the pre-exposure of 1 / 0.6 that some viewers add.
vec3 toneAces(vec3 c) {
  const mat3 inputMatrix = mat3(0.59719, 0.07600, 0.02840, 0.35458, 0.90834, 0.13383, 0.04823, 0.01566, 0.83777);
  const mat3 outputMatrix = mat3(1.60475, -0.10208, -0.00327, -0.53108, 1.10813, -0.07276, -0.07367, -0.00605, 1.07602);
  vec3 v = inputMatrix * min(c, 1e6);
  v = (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  return clamp(outputMatrix * v, 0.0, 1.0);
}

// Sobotka's AgX in the minimal form of Wrensch 2023: log2 range -12.47393 .. 4.026069 and a sixth-order fit of the curve.
vec3 toneAgx(vec3 c) {
  const mat3 inset = mat3(0.842479062253094, 0.0423282422610123, 0.0423756549057051, 0.0784335999999992,
                          0.878468636469772, 0.0784336, 0.0792237451477643, 0.0791661274605434, 0.879142973793104);
  const mat3 outset = mat3(1.19687900512017, -0.0528968517574562, -0.0529716355144438, -0.0980208811401368,
                           1.15190312990417, -0.0980434501171241, -0.0990297440797205, -0.0989611768448433,
                           1.15107367264116);
  const float minEv = -12.47393, maxEv = 4.026069;
  vec3 v = inset * c;
  v = (clamp(log2(max(v, 1e-10)), minEv, maxEv) - minEv) / (maxEv - minEv);
  vec3 v2 = v * v, v4 = v2 * v2;
  v = 15.5 * v4 * v2 - 40.14 * v4 * v + 31.96 * v4 - 6.868 * v2 * v + 0.4298 * v2 + 0.1191 * v - 0.00232;
  v = outset * v;
  return pow(clamp(v, 0.0, 1.0), vec3(2.2));
}

// PBR Neutral Tone Mapper, Khronos 2024.
vec3 toneNeutral(vec3 c) {
  const float startCompression = 0.8 - 0.04;
  const float desaturation = 0.15;
  float x = min(c.r, min(c.g, c.b));
  c -= x < 0.08 ? x - 6.25 * x * x : 0.04;
  float peak = max(c.r, max(c.g, c.b));
  if (peak < startCompression) return c;
  float d = 1.0 - startCompression;
  float newPeak = 1.0 - d * d / (peak + d - startCompression);
  c *= newPeak / peak;
  float g = 1.0 - 1.0 / (desaturation * (peak - newPeak) + 1.0);
  return mix(c, vec3(newPeak), g);
}

// mapper: TONE_*. c >= 0; anything else counts as 0.
vec3 toneMap(int mapper, vec3 c) {
  c = max(c, 0.0);
  switch (mapper) {
    case TONE_REINHARD: return toneReinhard(c);
    case TONE_REINHARD_POWER: return toneReinhardPower(c);
    case TONE_UNCHARTED2: return toneUncharted2(c);
    case TONE_ACES: return toneAces(c);
    case TONE_AGX: return toneAgx(c);
    case TONE_NEUTRAL: return toneNeutral(c);
    default: return min(c, 1.0);
  }
}
