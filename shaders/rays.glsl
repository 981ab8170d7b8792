// Rays through a scene's trees (rays.h): nearest triangle, or any. The twin is src/rays/traced_scene.cpp.
#include "rays.h"
#include "layout.h"
#include "ray_holes.glsl" if RAY_HOLES

layout(binding = rayNodesUnit) uniform usamplerBuffer rayNodes;
layout(binding = rayTrianglesUnit) uniform usamplerBuffer rayTriangles;
#ifdef RAY_PLACEMENTS
layout(binding = rayPlacementsUnit) uniform usamplerBuffer rayPlacements;
#endif

struct RayHit {
  uint triangle;  // in the order of the leaves
  uint instance;  // of the placement, where there are any
  float distance;
  vec2 weights;   // of the second and third corner
};

struct RayTriangle {
  vec3 corner, edge1, edge2;
  uint primitive, triangle, instance;
};

RayTriangle rayTriangle(uint index) {
  int at = int(index * rayTriangleTexels);
  uvec4 a = texelFetch(rayTriangles, at), b = texelFetch(rayTriangles, at + 1), c = texelFetch(rayTriangles, at + 2);
  return RayTriangle(uintBitsToFloat(a.xyz), uintBitsToFloat(b.xyz), uintBitsToFloat(c.xyz), a.w, b.w, c.w);
}

vec3 inverseDirection(vec3 d) {
  vec3 least = vec3(d.x < 0.0 ? -1e-30 : 1e-30, d.y < 0.0 ? -1e-30 : 1e-30, d.z < 0.0 ? -1e-30 : 1e-30);
  return 1.0 / vec3(abs(d.x) > 1e-30 ? d.x : least.x, abs(d.y) > 1e-30 ? d.y : least.y, abs(d.z) > 1e-30 ? d.z : least.z);
}

// Where it enters and leaves along one axis of four boxes.
void clipRange(int texel, float origin, float inverse, inout vec4 near, inout vec4 far) {
  vec4 low = (uintBitsToFloat(texelFetch(rayNodes, texel)) - origin) * inverse;
  vec4 high = (uintBitsToFloat(texelFetch(rayNodes, texel + 1)) - origin) * inverse;
  near = max(near, min(low, high));
  far = min(far, max(low, high));
}

// Nearest first: of four children those that are nearer change places.
#define RAY_ORDER(a, b) \
  if (near.b < near.a) { \
    float n = near.a; near.a = near.b; near.b = n; \
    uint c = children.a; children.a = children.b; children.b = c; \
  }

#define RAY_LATER(a) \
  if (near.a < 3e38) { \
    entries[size] = near.a; \
    stack[size++] = children.a; \
  }

// True where the ray meets a triangle between `from` and hit.distance [lengths of direction]; any: whichever. camera:
// backs of what has one side only are not there.
bool walkRay(vec3 origin, vec3 direction, float from, bool any, bool camera, inout RayHit hit) {
  uint stack[rayStackSize];
  float entries[rayStackSize];  // where the ray enters them: what is behind the nearest triangle by then is not looked at
  entries[0] = 0.0;
  stack[0] = 0u;
  int size = 1;
  vec3 o = origin, d = direction, inverse = inverseDirection(direction);
  bool found = false;
#ifdef RAY_PLACEMENTS
  int below = -1;  // entries of the upper tree while a placement is walked
  uint instance = 0u;
#endif
  while (size > 0) {
#ifdef RAY_PLACEMENTS
    if (size == below) {
      o = origin;
      d = direction;
      inverse = inverseDirection(direction);
      below = -1;
    }
#endif
    --size;
    if (entries[size] >= hit.distance) continue;
    uint at = stack[size];
    if ((at & rayLeaf) == 0u) {
      int texel = int(at * rayNodeTexels);
      vec4 near = vec4(from), far = vec4(hit.distance);
      clipRange(texel, o.x, inverse.x, near, far);
      clipRange(texel + 2, o.y, inverse.y, near, far);
      clipRange(texel + 4, o.z, inverse.z, near, far);
      uvec4 children = texelFetch(rayNodes, texel + 6);
      far = mix(far * (1.0 + 4e-7), vec4(-1.0), equal(children, uvec4(rayNone)));
      near = mix(vec4(3e38), near, lessThanEqual(near, far));
      RAY_ORDER(x, y)
      RAY_ORDER(z, w)
      RAY_ORDER(x, z)
      RAY_ORDER(y, w)
      RAY_ORDER(y, z)
      RAY_LATER(w)
      RAY_LATER(z)
      RAY_LATER(y)
      RAY_LATER(x)
      continue;
    }
#ifdef RAY_PLACEMENTS
    if ((at & rayPlacementLeaf) == rayPlacementLeaf) {
      int texel = int((at & rayFirstMask) * rayPlacementTexels);
      vec4 x = uintBitsToFloat(texelFetch(rayPlacements, texel));
      vec4 y = uintBitsToFloat(texelFetch(rayPlacements, texel + 1));
      vec4 z = uintBitsToFloat(texelFetch(rayPlacements, texel + 2));
      uvec4 where = texelFetch(rayPlacements, texel + 3);
      o = vec3(dot(x, vec4(origin, 1.0)), dot(y, vec4(origin, 1.0)), dot(z, vec4(origin, 1.0)));
      d = vec3(dot(x.xyz, direction), dot(y.xyz, direction), dot(z.xyz, direction));
      inverse = inverseDirection(d);
      instance = where.y;
      below = size;
      entries[size] = 0.0;
      stack[size++] = where.x;
      continue;
    }
#endif
    uint first = at & rayFirstMask, last = first + ((at >> rayCountShift) & 7u);
    for (uint i = first; i <= last; ++i) {
      RayTriangle t = rayTriangle(i);
      vec3 p = cross(d, t.edge2);
      float determinant = dot(t.edge1, p), scale = 1.0 / determinant;
      vec3 s = o - t.corner;
      float u = dot(s, p) * scale;
      vec3 q = cross(s, t.edge1);
      float v = dot(d, q) * scale, distance = dot(t.edge2, q) * scale;
      bool met = determinant != 0.0 && u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > from && distance < hit.distance;
      if (met && camera && (t.primitive & rayOneSided) != 0u)
        met = (determinant > 0.0) != ((t.primitive & rayMirrored) != 0u);
      if (met && (t.primitive & rayHoled) != 0u) met = stopsRay(t.primitive & rayPrimitiveMask, t.triangle, vec2(u, v));
      if (!met) continue;
      found = true;
      hit.triangle = i;
      hit.distance = distance;
      hit.weights = vec2(u, v);
#ifdef RAY_PLACEMENTS
      hit.instance = instance;
#endif
      if (any) {
        size = 0;
        break;
      }
    }
  }
  return found;
}
