// What lies at a point of a triangle, from buffers that hold all of a scene (src/frame/scene_buffers.hpp), in the
// mesh's space and as the file has it: no skin, no morph target. With MATERIAL_BY_INDEX, of material.glsl: `material`
// is filled by selectMaterial, and textures are those of the caller.
#include "scene_primitives.glsl"

layout(std430, binding = sceneTrianglesBinding) readonly buffer SceneTrianglesBlock { uint sceneTriangles[]; };
layout(std430, binding = sceneAttributesBinding) readonly buffer SceneAttributesBlock { float sceneAttributes[]; };
layout(std430, binding = sceneMaterialsBinding) readonly buffer SceneMaterialsBlock { MaterialUniforms sceneMaterials[]; };

// weights: of the triangle's corners, adding up to 1.
struct SceneHit {
  uint primitive, triangle;
  vec3 weights;
};

struct Varyings {
  vec3 position;
  vec3 normal;
  vec3 facing;  // geometric normal towards the ray, where it is known
  vec4 tangent, coatTangent, grainTangent;
  vec4 color;
  float scale;
  vec2 texCoord[8];
};

MaterialUniforms material;
void selectMaterial(uint index) { material = sceneMaterials[index]; }

// The attribute of `width` floats that begins at `first`, interpolated; `absent` where the primitive has none.
vec4 sceneAttribute(uint first, uint width, uvec3 corners, vec3 weights, vec4 absent) {
  if (first == noAttribute) return absent;
  vec4 sum = vec4(0.0);
  for (int corner = 0; corner < 3; ++corner)
    for (uint i = 0u; i < width; ++i)
      sum[i] += weights[corner] * sceneAttributes[first + width * corners[corner] + i];
  return sum;
}

Varyings varyingsAt(SceneHit hit) {
  ScenePrimitive p = scenePrimitives[hit.primitive];
  uint at = 3u * (p.firstTriangle + hit.triangle);
  uvec3 corners = uvec3(sceneTriangles[at], sceneTriangles[at + 1u], sceneTriangles[at + 2u]);
  Varyings v;
  v.position = sceneAttribute(p.position, 3u, corners, hit.weights, vec4(0.0)).xyz;
  v.normal = sceneAttribute(p.normal, 3u, corners, hit.weights, vec4(0.0)).xyz;
  v.tangent = sceneAttribute(p.tangent, 4u, corners, hit.weights, vec4(0.0));
#ifdef HAS_COAT_TANGENT
  v.coatTangent = sceneAttribute(p.coatTangent, 4u, corners, hit.weights, vec4(0.0));
#endif
#ifdef HAS_GRAIN_TANGENT
  v.grainTangent = sceneAttribute(p.grainTangent, 4u, corners, hit.weights, vec4(0.0));
#endif
  v.color = sceneAttribute(p.color, 4u, corners, hit.weights, vec4(1.0));
  v.scale = 1.0;
  v.facing = v.normal;
  for (int set = 0; set < 8; ++set)
    v.texCoord[set] = sceneAttribute(p.texCoord[set], 2u, corners, hit.weights, vec4(0.0)).xy;
  return v;
}
