// The surface that a path has met, in the world: from the triangle and the primitive's data by index.
#include "scene_by_index.glsl"
#include "rays.glsl"
#include "paths.h"

layout(std430, binding = instanceBinding) readonly buffer InstanceBlock { Instance instances[]; };

struct PathSurface {
  Varyings v;
  vec3 Ng;        // geometric normal, unit, on the ray's side
  bool front;     // the front face was met
  bool glowing;   // rayGlowing
  uint material;
  float rounding;  // how far the point may be off its plane [m]
};

// Unit where there is a length at all.
vec3 unitOr(vec3 v, vec3 otherwise) {
  float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
  return largest > 0.0 ? normalize(v / largest) : otherwise;
}

PathSurface pathSurface(PathState p) {
  RayTriangle t = rayTriangle(p.triangle);
  uint primitive = t.primitive & rayPrimitiveMask;
  Instance instance = instances[t.instance == rayOfPlacement ? p.instance : t.instance];
  mat3 normalFromLocal =
      mat3(instance.normalFromLocal[0].xyz, instance.normalFromLocal[1].xyz, instance.normalFromLocal[2].xyz);
  float handedness = instance.normalFromLocal[0].w;
  SceneHit hit = SceneHit(primitive, t.triangle, vec3(1.0 - p.weights.x - p.weights.y, p.weights));
  PathSurface at;
  at.v = varyingsAt(hit);
  at.glowing = (t.primitive & rayGlowing) != 0u;
  at.material = scenePrimitives[primitive].material;
  vec3 position = t.corner + p.weights.x * t.edge1 + p.weights.y * t.edge2;
  vec3 extent = max(max(abs(t.corner), abs(t.corner + t.edge1)), abs(t.corner + t.edge2));
  vec3 facing = cross(t.edge1, t.edge2);
  if (t.instance == rayOfPlacement) {
    mat3 world = mat3(instance.worldFromLocal);
    extent = abs(world[0]) * extent.x + abs(world[1]) * extent.y + abs(world[2]) * extent.z +
             abs(instance.worldFromLocal[3].xyz);
    position = (instance.worldFromLocal * vec4(position, 1.0)).xyz;
    facing = normalFromLocal * facing;
  } else {
    facing *= handedness;
  }
  at.rounding = max(extent.x, max(extent.y, extent.z)) * 2e-6;
  vec3 towards = -p.direction.xyz;
  at.Ng = unitOr(facing, towards);
  at.front = dot(at.Ng, towards) >= 0.0;
  if (!at.front) at.Ng = -at.Ng;
  at.v.position = position;
  at.v.facing = at.Ng;
#ifdef HAS_NORMAL
  at.v.normal = unitOr(normalFromLocal * at.v.normal, vec3(0.0));
#ifdef FLAT_NORMALS
  at.v.normal = at.front ? at.Ng : -at.Ng;
#endif
#endif
#ifdef HAS_TANGENT
  at.v.tangent = vec4(unitOr(mat3(instance.worldFromLocal) * at.v.tangent.xyz, vec3(0.0)), at.v.tangent.w * handedness);
#endif
#ifdef HAS_COAT_TANGENT
  at.v.coatTangent =
      vec4(unitOr(mat3(instance.worldFromLocal) * at.v.coatTangent.xyz, vec3(0.0)), at.v.coatTangent.w * handedness);
#endif
#ifdef HAS_GRAIN_TANGENT
  at.v.grainTangent =
      vec4(unitOr(mat3(instance.worldFromLocal) * at.v.grainTangent.xyz, vec3(0.0)), at.v.grainTangent.w * handedness);
#endif
  if (!at.front) {  // the back face has the reversed shading normal, bumps included
    at.v.normal = -at.v.normal;
    at.v.tangent = -at.v.tangent;
#ifdef HAS_COAT_TANGENT
    at.v.coatTangent = -at.v.coatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
    at.v.grainTangent = -at.v.grainTangent;
#endif
  }
  return at;
}

// Where a ray begins that leaves the surface on the side of `direction`, so that it does not meet it again.
vec3 leaveSurface(PathSurface at, vec3 direction) {
  return at.v.position + at.Ng * (dot(at.Ng, direction) >= 0.0 ? at.rounding : -at.rounding);
}
