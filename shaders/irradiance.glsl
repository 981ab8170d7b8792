// Irradiance over pi of the distant light, of a stored 1 (FrameUniforms.environmentScale).
#include "frame.glsl"

layout(binding = irradianceUnit) uniform samplerCube irradianceOverPi;

vec3 lookUpIrradiance(vec3 N) { return textureLod(irradianceOverPi, environmentFromWorld(N), 0.0).rgb; }
