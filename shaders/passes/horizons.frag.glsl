// Horizons of the depth buffer around each of its texels: which share of the sky over the surface nothing hides (ground-truth
// ambient occlusion, Jimenez et al. 2016), cosine-weighted. What is nearer hides all that is behind it, however
// thin it is.
#include "frame.glsl"
#include "horizons.glsl"

layout(binding = sourceUnit) uniform sampler2D depths;
layout(location = horizonReachLocation) uniform vec4 parameters;  // x how far horizons are looked for; y slices, z steps a side
layout(location = 0) out vec2 outShare;  // as horizon_occlusion.glsl reads it

// In units of screen.z, which scenes of all sizes fill alike. Viewer's space: x right, y up, z towards the viewer.
vec3 positionAt(ivec2 texel) {
  float distance = distanceFromDepth(texelFetch(depths, texel, 0).r) / frame.screen.z;
  vec2 pixel = (vec2(texel) + 0.5) / frame.screen.xy - 0.5 * frame.picture.xy;
  return vec3(pixel / frame.picture.w * (frame.eye.w > 0.5 ? distance : 1.0 / frame.screen.z), -distance);
}

bool covered(ivec2 texel) { return texelFetch(depths, texel, 0).r > 0.0; }

// To the next texel of the same surface: that of both neighbours which is nearer; without any it faces the viewer.
vec3 nearer(vec3 here, ivec2 texel, ivec2 to, ivec2 size, float texelSize) {
  ivec2 ahead = min(texel + to, size - 1), behind = max(texel - to, ivec2(0));
  bool any = false;
  vec3 step = vec3(vec2(to) * texelSize, 0.0);
  if (ahead != texel && covered(ahead)) step = positionAt(ahead) - here, any = true;
  if (behind != texel && covered(behind)) {
    vec3 other = here - positionAt(behind);
    if (!any || abs(other.z) < abs(step.z)) step = other;
  }
  return step;
}

void main() {
  ivec2 texel = ivec2(gl_FragCoord.xy), size = textureSize(depths, 0);
  if (!covered(texel)) {
    outShare = vec2(1.0, 6e4);
    return;
  }
  vec3 here = positionAt(texel);
  vec3 V = frame.eye.w > 0.5 ? -normalize(here) : vec3(0.0, 0.0, 1.0);
  float texelSize = (frame.eye.w > 0.5 ? -here.z : 1.0 / frame.screen.z) / (frame.picture.w * frame.screen.x);
  vec3 N = normalize(cross(nearer(here, texel, ivec2(1, 0), size, texelSize), nearer(here, texel, ivec2(0, 1), size, texelSize)));
  float reach = min(parameters.x / texelSize, float(max(size.x, size.y)));
  int slices = int(parameters.y), steps = int(parameters.z);
  // Each of 4 x 4 texels looks along other lines, at other distances.
  int turn = (texel.x & 3) * 4 + (texel.y & 3), start = (texel.x + 2 * texel.y) & 3;
  float open = 0.0;
  for (int slice = 0; slice < slices; ++slice) {
    float phi = (float(slice) + float(turn) / 16.0) * PI / float(slices);
    vec3 along = vec3(cos(phi), sin(phi), 0.0);
    vec3 across = normalize(cross(along, V));  // the slice's normal
    vec3 tangent = cross(V, across), projected = N - across * dot(N, across);
    float weight = length(projected);
    float n = atan(dot(projected, tangent), dot(projected, V));
    vec2 highest = vec2(cos(n + 0.5 * PI), cos(n - 0.5 * PI));  // cosines of both horizons: at first the surface's own
    for (int j = 0; j < steps; ++j) {
      float part = (float(j) + (float(start) + 0.5) / 4.0) / float(steps);
      float ahead = max(reach * part * part, 1.0 + float(j));
      for (int side = 0; side < 2; ++side) {
        ivec2 at = texel + ivec2(round((side == 0 ? ahead : -ahead) * along.xy));
        if (any(lessThan(at, ivec2(0))) || any(greaterThanEqual(at, size)) || !covered(at)) continue;
        vec3 to = positionAt(at) - here;
        float distance = length(to);
        if (distance < parameters.x) highest[side] = max(highest[side], dot(to, V) / max(distance, 1e-30));
      }
    }
    float h0 = keptHorizon(acos(clamp(highest.x, -1.0, 1.0)), n), h1 = keptHorizon(-acos(clamp(highest.y, -1.0, 1.0)), n);
    open += weight * (openArc(h0, n) + openArc(h1, n));
  }
  outShare = vec2(min(open / float(slices), 1.0), min(-here.z, farthestHorizon));
}
