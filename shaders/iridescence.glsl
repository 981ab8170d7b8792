// A thin film on a base: KHR_materials_iridescence, after Belcour and Barla 2017. The twin, and the error against a
// spectral sum, are in src/optics/iridescence.cpp and its test.
#include "constants.glsl"

// XYZ of cos(2 pi OPD / lambda + shift) by the Gaussians of section 5, to linear Rec. 709. opticalPathNm in [nm]; from
// 1e5 on nothing is left of it, and more would only overflow.
vec3 interferenceColor(float opticalPathNm, vec3 shift) {
  float phase = 2e-9 * PI * min(opticalPathNm, 1e5);
  float phase2 = phase * phase;
  const vec3 weight = vec3(5.4856e-13, 4.4201e-13, 5.2481e-13);
  const vec3 position = vec3(1.6810e6, 1.7953e6, 2.2084e6);
  const vec3 variance = vec3(4.3278e9, 9.3046e9, 6.6121e9);
  vec3 xyz = weight * sqrt(2.0 * PI * variance) * cos(position * phase + shift) * exp(-variance * phase2);
  xyz.x += 9.7470e-14 * sqrt(2.0 * PI * 4.5282e9) * cos(2.2399e6 * phase + shift.x) * exp(-4.5282e9 * phase2);
  const mat3 rec709FromXyz = mat3(3.2404542, -0.9692660, 0.0556434, -1.5371385, 1.8760108, -0.2040259, -0.4985314,
                                  0.0415560, 1.0572252);
  return rec709FromXyz * (xyz / 1.0685e-7);
}

// The same with the exact Fresnel terms of both polarisations and sensitivities that sum to white: an order of
// magnitude nearer to the spectral sum at grazing angles, and no film is no film. The amplitudes are real, so that a phase of pi
// is a sign, and one evaluation of the colour per order serves all channels. Arguments as F_Iridescence; cosine 0: 1.
vec3 F_ThinFilm(float cosine, float outsideIor, float filmIor, float thicknessNm, vec3 baseF0) {
  float c1 = clamp(cosine, 0.0, 1.0);
  thicknessNm = clamp(thicknessNm, 0.0, 1e5);
  float film = max(mix(outsideIor, filmIor, smoothstep(0.0, 0.03, thicknessNm)), 1e-3);
  float ratio = outsideIor / film;
  float cos2Squared = (1.0 - ratio) * (1.0 + ratio) + ratio * ratio * c1 * c1;
  if (cos2Squared <= 0.0 || c1 <= 0.0) return vec3(1.0);
  float c2 = sqrt(cos2Squared);
  vec3 root = sqrt(clamp(baseF0, 0.0, 0.9999));
  vec3 base = (1.0 + root) / (1.0 - root);
  vec3 baseRatio = outsideIor / base;
  vec3 c3 = sqrt(max((1.0 - baseRatio) * (1.0 + baseRatio) + baseRatio * baseRatio * (c1 * c1), 0.0));

  float path = 2.0 * film * thicknessNm * c2;
  vec3 white = interferenceColor(0.0, vec3(0.0));
  vec3 S1 = interferenceColor(path, vec3(0.0)) / white, S2 = interferenceColor(2.0 * path, vec3(0.0)) / white;
  vec3 sum = vec3(0.0);
  for (int polarisation = 0; polarisation < 2; ++polarisation) {
    bool s = polarisation == 0;  // amplitudes: n cos for s, the other medium's n for p
    float a1 = s ? outsideIor * c1 : film * c1, a2 = s ? film * c2 : outsideIor * c2;
    vec3 b2 = s ? vec3(film * c2) : base * c2, b3 = s ? base * c3 : film * c3;
    float r12 = (a1 - a2) / max(a1 + a2, 1e-20);
    vec3 r23 = (b2 - b3) / max(b2 + b3, 1e-20);
    float T121 = 1.0 - r12 * r12;
    vec3 q = -r12 * r23;  // of one round trip in the film
    vec3 Rs = T121 * T121 * r23 * r23 / (1.0 - min(q * q, 0.9999));
    sum += r12 * r12 + Rs + 2.0 * (Rs - T121) * q * (S1 + q * S2);
  }
  return max(0.5 * sum, 0.0);
}

// The f0 for which Schlick's curve with f90 = 1 gives F at this cosine; clamped to [0, 1]. cosine -> 0: 0.
vec3 f0FromSchlick(vec3 F, float cosine) {
  float m = clamp(1.0 - cosine, 0.0, 1.0);
  float weight = m * m * m * m * m;
  return weight < 0.9999 ? clamp((F - weight) / (1.0 - weight), 0.0, 1.0) : vec3(0.0);
}
