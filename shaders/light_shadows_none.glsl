#include "arriving_light.glsl"

float reachingShare(LightUniforms light, vec3 position, vec3 N, vec3 L, float occlusion) { return isSun(light) ? occlusion : 1.0; }
