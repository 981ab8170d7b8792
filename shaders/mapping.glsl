// Directions and where they lie on an equirectangular map or a cube map.
// The twin is src/optics/mapping.cpp.
#include "constants.glsl"

// u to the right, v DOWN from +Y (texture row 0 is the top): u = atan2(z, x) / 2 pi + 1/2, v = 1/2 - asin(y) / pi. The
// latitude as atan2: asin loses half its digits near the poles, and drivers approximate it to 4e-4 only.
vec2 equirectFromDirection(vec3 d) {
  float u = (d.x == 0.0 && d.z == 0.0) ? 0.5 : atan(d.z, d.x) / (2.0 * PI) + 0.5;
  return vec2(u, 0.5 - atan(d.y, length(d.xz)) / PI);
}

// OpenGL 4.6, table 8.19: face 0..5 = +X -X +Y -Y +Z -Z; st in [-1, 1]. Not normalised.
vec3 directionFromCube(int face, vec2 st) {
  switch (face) {
    case 0: return vec3(1.0, -st.y, -st.x);
    case 1: return vec3(-1.0, -st.y, st.x);
    case 2: return vec3(st.x, 1.0, st.y);
    case 3: return vec3(st.x, -1.0, -st.y);
    case 4: return vec3(st.x, -st.y, 1.0);
    default: return vec3(-st.x, -st.y, -1.0);
  }
}

// Solid angle per unit of st area at st.
float cubeSolidAngleDensity(vec2 st) {
  float r2 = 1.0 + dot(st, st);
  return 1.0 / (r2 * sqrt(r2));
}

// Solid angle [sr] of a texel of a face of size^2 around st: the density's mean to the second order in the texel's half h,
// f + h^2 / 6 (f_ss + f_tt). Off by 1e-4 of it at size 8, by 1e-3 at 4.
float cubeTexelSolidAngle(vec2 st, float size) {
  float h = 1.0 / size, R = 1.0 + dot(st, st);
  return 4.0 * h * h * cubeSolidAngleDensity(st) * (1.0 + h * h / 6.0 * (9.0 * R - 15.0) / (R * R));
}

// Some orthonormal frame around the unit vector n: Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
mat3 frameAround(vec3 n) {
  float s = n.z >= 0.0 ? 1.0 : -1.0;
  float a = -1.0 / (s + n.z);
  float b = n.x * n.y * a;
  return mat3(vec3(1.0 + s * n.x * n.x * a, s * b, -s * n.x), vec3(b, s + n.y * n.y * a, -n.y), n);
}
