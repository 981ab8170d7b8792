// The DFG table (dfg_table.glsl): A = int (1 - Fc) f NoL dw, B = int Fc f NoL dw with f = D G2 / (4 NoL NoV) and
// Fc = (1 - VoH)^5. Over visible normals (Heitz 2018) the integrand is G2 / G1 times the Fresnel part:
//   int f NoL dw = int [D_v(H) / (4 VoH)] [G2 / G1] dw = mean over the unit square of G2 / G1,
// where the square maps to half the disc of visible normals, the other half being its mirror image. Radii are squeezed
// towards the rim, r^2 = 1 - (1 - t)^2, where L nears the horizon and the integrand falls to 0 within alpha. nodes[i] =
// (position, weight) of Gauss-Legendre on [0, 1], first those of the radius, then those of the angle. 32 x 8: A and B
// are off by at most 0.002 and 0.0008 for NoV >= 0.02 (16 x 16 without the squeezing: 0.011).
// The weighted mean of L is where the lobe looks; stored is the sine of its angle to N over that of the mirror
// direction, which varies little: the sine itself has an infinite slope at NoV = 1.
#include "layout.h"
#include "microfacet.glsl"

layout(local_size_x = groupSize, local_size_y = groupSize) in;
layout(binding = 0, rgba16f) writeonly uniform image2D table;
layout(std430, binding = computeInputBinding) readonly buffer NodeBlock { vec2 nodes[]; };
layout(location = dfgRadiiLocation) uniform int radii;

// Half vector for the polar disc point (r, phi), Heitz 2018, section 3; V in the plane x = 0.
vec3 visibleNormal(vec3 V, float alpha, float r, float phi) {
  vec3 Vh = normalize(vec3(alpha * V.x, alpha * V.y, V.z));
  vec3 T1 = vec3(-1.0, 0.0, 0.0);
  vec3 T2 = cross(Vh, T1);
  float t1 = r * cos(phi), t2 = r * sin(phi);
  float s = 0.5 * (1.0 + Vh.z);
  t2 = mix(sqrt(max(0.0, 1.0 - t1 * t1)), t2, s);
  vec3 Nh = t1 * T1 + t2 * T2 + sqrt(max(0.0, 1.0 - t1 * t1 - t2 * t2)) * Vh;
  return normalize(vec3(alpha * Nh.x, alpha * Nh.y, max(1e-6, Nh.z)));
}

void main() {
  ivec2 size = imageSize(table);
  ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
  if (texel.x >= size.x || texel.y >= size.y) return;
  vec2 uv = vec2(texel) / vec2(size - 1);
  float alpha = uv.y * uv.y;
  vec2 result;
  float tilt;
  if (alpha < 1e-6) {
    float m = 1.0 - uv.x * uv.x;
    float grazing = m * m * m * m * m;
    result = vec2(1.0 - grazing, grazing);  // a mirror
    tilt = 1.0;
  } else {
    // Along N there is no mirror direction to compare with; A and B differ by at most 2e-4 from those at NoV = 1.
    float NoV = clamp(uv.x * uv.x, 1e-6, 0.999);
    vec3 V = vec3(0.0, sqrt(1.0 - NoV * NoV), NoV);
    result = vec2(0.0);
    vec2 mean = vec2(0.0);
    for (int i = 0; i < radii; ++i)
      for (int j = radii; j < nodes.length(); ++j) {
        // Over the half disc t1 > 0.
        float rim = 1.0 - nodes[i].x;
        vec3 H = visibleNormal(V, alpha, sqrt(1.0 - rim * rim), PI * (nodes[j].x - 0.5));
        float VoH = clamp(dot(V, H), 0.0, 1.0);
        float NoL = 2.0 * VoH * H.z - V.z;
        if (NoL <= 0.0) continue;
        float weight = 2.0 * rim * nodes[i].y * nodes[j].y * V_SmithGGXCorrelated(NoV, NoL, alpha) * 4.0 * NoV * NoL /
                       G1_GGX(NoV, alpha);
        float q = 1.0 - VoH;
        float fc = q * q * q * q * q;
        result += weight * vec2(1.0 - fc, fc);
        mean += weight * vec2(V.y - 2.0 * VoH * H.y, NoL);
      }
    tilt = mean.x / (max(length(mean), 1e-12) * V.y);
  }
  imageStore(table, texel, vec4(result, clamp(tilt, 0.0, 1.0), 0.0));
}
