#extension GL_ARB_shader_draw_parameters : require
#include "frame.glsl"
#include "tex_coords.glsl"

layout(std430, binding = instanceBinding) readonly buffer InstanceBlock { Instance instances[]; };

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
#ifdef HAS_VERTEX_COLOR
layout(location = colorLocation) in vec4 inColor;
layout(location = 3) out vec4 outColor;
#endif
#define DECLARE(n) \
  layout(location = texCoordLocation + n) in vec2 inTexCoord##n; \
  layout(location = 4 + n) out vec2 outTexCoord##n;
EACH_TEXCOORD(DECLARE)

// Unit where there is a length at all; far from 1 in meshes of extreme scale otherwise.
vec3 direction(vec3 v) {
  float m = max(abs(v.x), max(abs(v.y), abs(v.z)));
  return m > 0.0 ? normalize(v / m) : vec3(0.0);
}

void main() {
  Instance instance = instances[gl_BaseInstanceARB + gl_InstanceID];
  vec4 world = instance.worldFromLocal * vec4(inPosition, 1.0);
  outPosition = world.xyz;
#ifdef HAS_NORMAL
  outNormal = direction(mat3(instance.normalFromLocal[0].xyz, instance.normalFromLocal[1].xyz,
                             instance.normalFromLocal[2].xyz) * inNormal);
#endif
#ifdef HAS_TANGENT
  // w of the first column is the sign of the determinant: a mirrored node turns the bitangent round.
  outTangent = vec4(direction(mat3(instance.worldFromLocal) * inTangent.xyz), inTangent.w * instance.normalFromLocal[0].w);
#endif
#ifdef HAS_VERTEX_COLOR
  outColor = inColor;
#endif
#define HAND_OVER(n) outTexCoord##n = inTexCoord##n;
  EACH_TEXCOORD(HAND_OVER)
  gl_Position = frame.clipFromWorld * world;
}
