// Adds a share of one draw to the sum of several (blending ONE, ONE).
#include "layout.h"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;
layout(location = gatherShareLocation) uniform float share;

void main() { outColor = texelFetch(source, ivec2(gl_FragCoord.xy), 0) * share; }
