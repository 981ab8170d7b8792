#include "constants.glsl"

// Lambert's BRDF [1/sr] of albedo 1, without the cosine.
float Fd_Lambert() { return 1.0 / PI; }
