// Each pixel's standard error on the screen as a colour: of the channel that is off most, by the logarithm, for the
// window to lay over the picture.
#include "layout.h"
#include "display.glsl"

layout(location = 0) out vec4 outColor;
layout(binding = sourceUnit) uniform sampler2D source;        // the sum of the draws
layout(binding = comparedUnit) uniform sampler2D contrasts;   // passes/contrast_add.comp.glsl
layout(location = displayParametersLocation) uniform vec4 parameters;  // of displayed(), w for the mean
layout(location = displayBackdropLocation) uniform vec4 backdrop;
layout(location = errorPartsLocation) uniform vec4 parts;  // x contrasts * this: the mean's variance; y, z least and largest error
layout(location = errorStopsLocation) uniform vec4 stops[errorStopCount];

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  vec4 mean = texelFetch(source, at, 0) * parameters.w, off = sqrt(texelFetch(contrasts, at, 0) * parts.x);
  vec4 plain = vec4(parameters.xyz, 1.0);
  vec3 apart = abs(displayed(mean + off, plain, backdrop).rgb - displayed(max(mean - off, 0.0), plain, backdrop).rgb) * 0.5;
  float error = max(apart.r, max(apart.g, apart.b));
  float place = clamp(log(max(error, 1e-9) / parts.y) / log(parts.z / parts.y), 0.0, 1.0) * float(errorStopCount - 1);
  int first = min(int(place), errorStopCount - 2);
  outColor = vec4(mix(stops[first].rgb, stops[first + 1].rgb, place - float(first)), 1.0);
}
