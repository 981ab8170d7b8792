// The DFG table by importance sampling of the normals' distribution, NoV = u at texel centres: the usual way, for
// comparison. Weight G2 VoH / (NoH NoV) (Karis 2013), with the height-correlated term.
#include "layout.h"
#include "microfacet.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba32f) writeonly uniform image2D table;
layout(location = dfgSamplesLocation) uniform int samples;

void main() {
  ivec2 size = imageSize(table);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) return;
  vec2 uv = (vec2(texel) + 0.5) / vec2(size);
  float NoV = uv.x, alpha = max(uv.y * uv.y, 1e-4);
  vec3 V = vec3(sqrt(1.0 - NoV * NoV), 0.0, NoV);
  vec2 sum = vec2(0.0);
  for (int i = 0; i < samples; ++i) {
    float phi = 2.0 * PI * float(i) / float(samples);
    float u = float(bitfieldReverse(uint(i))) * 2.3283064365386963e-10;
    float cosine = sqrt((1.0 - u) / (1.0 + (alpha * alpha - 1.0) * u)), sine = sqrt(max(1.0 - cosine * cosine, 0.0));
    vec3 H = vec3(sine * cos(phi), sine * sin(phi), cosine);
    float VoH = max(dot(V, H), 0.0), NoL = 2.0 * VoH * H.z - V.z;
    if (NoL <= 0.0) continue;
    float weight = V_SmithGGXCorrelated(NoV, NoL, alpha) * 4.0 * NoL * VoH / max(H.z, 1e-6);
    float q = 1.0 - VoH, fc = q * q * q * q * q;
    sum += weight * vec2(1.0 - fc, fc);
  }
  imageStore(table, texel, vec4(sum / float(samples), 0.0, 0.0));
}
