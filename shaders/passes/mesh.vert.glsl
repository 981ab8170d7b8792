#extension GL_ARB_shader_draw_parameters : require
#include "frame.glsl"
#include "deformation.glsl"
#include "tex_coords.glsl"

layout(std430, binding = instanceBinding) readonly buffer InstanceBlock { Instance instances[]; };

layout(std430, binding = visibleBinding) readonly buffer VisibleBlock { uint visibleInstances[]; };

layout(location = positionLocation) in vec3 inPosition;
layout(location = 0) out vec3 outPosition;
#ifdef HAS_NORMAL
layout(location = normalLocation) in vec3 inNormal;
layout(location = 1) out vec3 outNormal;
#endif
#ifdef HAS_TANGENT
layout(location = tangentLocation) in vec4 inTangent;
layout(location = 2) out vec4 outTangent;
#endif
#ifdef HAS_COAT_TANGENT
layout(location = coatTangentLocation) in vec4 inCoatTangent;
layout(location = 15) out vec4 outCoatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
layout(location = grainTangentLocation) in vec4 inGrainTangent;
layout(location = 14) out vec4 outGrainTangent;
#endif
#ifdef HAS_VERTEX_COLOR
layout(location = colorLocation) in vec4 inColor;
layout(location = 3) out vec4 outColor;
#endif
#define DECLARE(n) \
  layout(location = texCoordLocation + n) in vec2 inTexCoord##n; \
  layout(location = 4 + n) out vec2 outTexCoord##n;
EACH_TEXCOORD(DECLARE)

#ifdef HAS_VOLUME
layout(location = 12) out float outScale;
#endif
#ifdef ALPHA_MASK
layout(location = 13) flat out uint outInstance;
#endif
#ifdef SHOWS_NODE
layout(location = 14) flat out uint outNode;
#endif

// Unit where there is a length at all; far from 1 in meshes of extreme scale otherwise.
vec3 direction(vec3 v) {
  float m = max(abs(v.x), max(abs(v.y), abs(v.z)));
  return m > 0.0 ? normalize(v / m) : vec3(0.0);
}

void main() {
  uint index = visibleInstances[gl_BaseInstanceARB + gl_InstanceID];
  Instance instance = instances[index];
#ifdef ALPHA_MASK
  outInstance = index;
#endif
#ifdef SHOWS_NODE
  outNode = instance.deformation.w;
#endif
  vec3 position = inPosition;
#ifdef HAS_NORMAL
  vec3 normal = inNormal;
#endif
#ifdef HAS_TANGENT
  vec3 tangent = inTangent.xyz;
#endif
#ifdef HAS_COAT_TANGENT
  vec3 coatTangent = inCoatTangent.xyz;
#endif
#ifdef HAS_GRAIN_TANGENT
  vec3 grainTangent = inGrainTangent.xyz;
#endif
#ifdef HAS_MORPH
  Offsets offsets = morphOffsets(instance, uint(gl_VertexID));
  position += offsets.position;
#ifdef MORPH_NORMALS
  normal += offsets.normal;
#endif
#ifdef MORPH_TANGENTS
#ifdef HAS_TANGENT
  tangent += offsets.tangent;
#endif
#ifdef HAS_COAT_TANGENT
  coatTangent += offsets.coatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
  grainTangent += offsets.grainTangent;
#endif
#endif
#endif
#ifdef HAS_SKIN
  mat4 worldFromLocal = skinMatrix(instance, uint(gl_VertexID));
  mat3 normalFromLocal = normalMatrix(mat3(worldFromLocal));
#else
  mat4 worldFromLocal = instance.worldFromLocal;
  mat3 normalFromLocal =
      mat3(instance.normalFromLocal[0].xyz, instance.normalFromLocal[1].xyz, instance.normalFromLocal[2].xyz);
#endif
  vec4 world = worldFromLocal * vec4(position, 1.0);
  outPosition = world.xyz;
#ifdef HAS_NORMAL
  outNormal = direction(normalFromLocal * normal);
#endif
#ifdef HAS_TANGENT
  // w of the first column is the sign of the determinant: a mirrored node turns the bitangent round.
  outTangent = vec4(direction(mat3(worldFromLocal) * tangent), inTangent.w * instance.normalFromLocal[0].w);
#endif
#ifdef HAS_COAT_TANGENT
  outCoatTangent = vec4(direction(mat3(worldFromLocal) * coatTangent), inCoatTangent.w * instance.normalFromLocal[0].w);
#endif
#ifdef HAS_GRAIN_TANGENT
  outGrainTangent = vec4(direction(mat3(worldFromLocal) * grainTangent), inGrainTangent.w * instance.normalFromLocal[0].w);
#endif
#ifdef HAS_VERTEX_COLOR
  outColor = inColor;
#ifdef MORPH_COLORS
  outColor = clamp(outColor + offsets.color, 0.0, 1.0);  // glTF 2.0, 3.7.2.2
#endif
#endif
#ifdef HAS_VOLUME
  // The geometric mean along the mesh's axes.
  vec3 lengths2 = vec3(dot(worldFromLocal[0], worldFromLocal[0]), dot(worldFromLocal[1], worldFromLocal[1]),
                       dot(worldFromLocal[2], worldFromLocal[2]));
  outScale = exp2(dot(log2(lengths2), vec3(1.0 / 6.0)));
#endif
#define HAND_OVER(n) outTexCoord##n = inTexCoord##n;
  EACH_TEXCOORD(HAND_OVER)
#ifdef MORPH_TEXCOORDS
#define MOVE(n) outTexCoord##n += offsets.texCoords[n];
  EACH_TEXCOORD(MOVE)
#endif
  gl_Position = frame.clipFromWorld * world;
}
