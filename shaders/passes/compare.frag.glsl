// Two pictures as one is shown: side by side, or how they differ.
#include "layout.h"
#include "display.glsl"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;
layout(binding = comparedUnit) uniform sampler2D compared;
layout(location = displayParametersLocation) uniform vec4 parameters;  // of displayed()
layout(location = displayBackdropLocation) uniform vec4 backdrop;
layout(location = comparisonLocation) uniform vec4 comparison;  // x pixels from the left that show the first; y factor on the absolute
                                               // difference of display values; z 1: shows that difference

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 a = displayed(texelFetch(source, at, 0), parameters, backdrop);
  vec4 b = displayed(texelFetch(compared, at, 0), parameters, backdrop);
  if (comparison.z > 0.5)
    outColor = vec4(comparison.y * abs(a.rgb - b.rgb), 1.0);
  else
    outColor = gl_FragCoord.x < comparison.x ? a : b;
}
