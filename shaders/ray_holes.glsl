// Triangles that may let a ray pass: masks and coverage by the base colour's alpha, its texture read as it is stored,
// without smaller levels. Coverage stops a ray by chance.
#define MATERIAL_BY_INDEX
#include "scene_by_index.glsl"
#include "rays.h"
#include "paths.h"
#include "sobol.glsl"

layout(std430, binding = rayHolesBinding) readonly buffer HolesBlock { RayHoles rayHoles[]; };
layout(binding = rayAlphaUnit) uniform samplerBuffer rayAlpha;

uint holesSeed;  // of the ray

// Texel of an axis of that size, or -1 at the border.
int wrappedTexel(int i, int size, uint wrap) {
  if (wrap == wrapClamp) return clamp(i, 0, size - 1);
  int period = wrap == wrapMirror ? 2 * size : size;
  i = i % period;
  if (i < 0) i += period;
  return i < size ? i : 2 * size - 1 - i;
}

float holesTexel(RayHoles h, ivec2 at) {
  int x = wrappedTexel(at.x, int(h.width), h.wrapS), y = wrappedTexel(at.y, int(h.height), h.wrapT);
  return texelFetch(rayAlpha, int(h.first) + y * int(h.width) + x).r;
}

float holesAlpha(RayHoles h, vec2 uv) {
  vec2 at = uv * vec2(h.width, h.height);
  if (h.nearest != 0u) return holesTexel(h, ivec2(floor(at)));
  at -= 0.5;
  ivec2 i = ivec2(floor(at));
  vec2 f = at - vec2(i);
  return mix(mix(holesTexel(h, i), holesTexel(h, i + ivec2(1, 0)), f.x),
             mix(holesTexel(h, i + ivec2(0, 1)), holesTexel(h, i + ivec2(1, 1)), f.x), f.y);
}

// primitive, triangle: of a triangle that is marked.
bool stopsRay(uint primitive, uint triangle, vec2 weights) {
  ScenePrimitive p = scenePrimitives[primitive];
  uint first = 3u * (p.firstTriangle + triangle);
  uvec3 corners = uvec3(sceneTriangles[first], sceneTriangles[first + 1u], sceneTriangles[first + 2u]);
  vec3 shares = vec3(1.0 - weights.x - weights.y, weights);
  float alpha = sceneMaterials[p.material].baseColorFactor.a;
  if (p.color != noAttribute)
    alpha *= dot(shares, vec3(sceneAttributes[p.color + 4u * corners.x + 3u], sceneAttributes[p.color + 4u * corners.y + 3u],
                              sceneAttributes[p.color + 4u * corners.z + 3u]));
  RayHoles h = rayHoles[p.material];
  if (h.width > 0u) {
    SlotUniforms slot = sceneMaterials[p.material].baseColorSlot;
    uint coordinates = p.texCoord[uint(slot.texCoord)];
    if (coordinates != noAttribute) {
      vec3 uv = vec3(sceneAttribute(coordinates, 2u, corners, shares, vec4(0.0)).xy, 1.0);
      alpha *= holesAlpha(h, vec2(dot(slot.u, uv), dot(slot.v, uv)));
    }
  }
  if (h.masked != 0u) return alpha >= sceneMaterials[p.material].alphaCutoff;
  uint bits = hashedBits(holesSeed ^ hashedBits(triangle ^ hashedBits(primitive)));
  return (float(bits >> 9) + 0.5) * (1.0 / 8388608.0) < alpha;
}
