// The picture as it is shown.
#include "layout.h"
#include "display.glsl"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;
layout(location = displayParametersLocation) uniform vec4 parameters;  // of displayed()
layout(location = displayBackdropLocation) uniform vec4 backdrop;

void main() { outColor = displayed(texelFetch(source, ivec2(gl_FragCoord.xy), 0), parameters, backdrop); }
