#ifdef BLEND_LISTS
#extension GL_ARB_post_depth_coverage : require
layout(early_fragment_tests, post_depth_coverage) in;
#endif
#include "material.glsl"
#if defined(MERL_BRDF) || defined(UTIA_BRDF)
#include "lit_measured.glsl"
#elif !defined(UNLIT)
#include "lit_material.glsl"
#endif
#include "constants.glsl"
#include "light_parts.glsl" if LIGHT_PART
#ifdef BLEND_LISTS
#include "blend_lists.glsl"
layout(location = blendOrderLocation) uniform uint blendOrder;
#endif
#ifdef FLAT_NORMALS
#include "face_normal.glsl"
#endif

layout(location = 0) in vec3 inPosition;
#ifdef HAS_NORMAL
layout(location = 1) in vec3 inNormal;
#endif
#ifdef HAS_TANGENT
layout(location = 2) in vec4 inTangent;
#endif
#ifdef HAS_COAT_TANGENT
layout(location = 15) in vec4 inCoatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
layout(location = 14) in vec4 inGrainTangent;
#endif
#ifdef HAS_VERTEX_COLOR
layout(location = 3) in vec4 inColor;
#endif
#ifdef HAS_VOLUME
layout(location = 12) in float inScale;
#endif
#ifdef ALPHA_MASK
layout(location = 13) flat in uint inInstance;
#include "mask_samples.glsl"
#endif
#define DECLARE(n) layout(location = 4 + n) in vec2 inTexCoord##n;
EACH_TEXCOORD(DECLARE)

layout(location = 0) out vec4 outColor;  // scene-linear as FrameUniforms.stored says, associated alpha

Varyings readVaryings() {
  Varyings v;
  v.position = inPosition;
  v.normal = vec3(0.0);
  v.tangent = vec4(0.0);
  v.color = vec4(1.0);
  v.scale = 1.0;
#ifdef HAS_VOLUME
  v.scale = inScale;
#endif
#ifdef HAS_NORMAL
  v.normal = inNormal;
#endif
#ifdef HAS_TANGENT
  v.tangent = inTangent;
#endif
#ifdef HAS_COAT_TANGENT
  v.coatTangent = inCoatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
  v.grainTangent = inGrainTangent;
#endif
#ifdef HAS_VERTEX_COLOR
  v.color = inColor;
#endif
#define TAKE(n) v.texCoord##n = inTexCoord##n;
  EACH_TEXCOORD(TAKE)
#ifdef FLAT_NORMALS
  vec3 facing = faceNormal(inPosition);
  v.normal = safeNormalize(gl_FrontFacing ? facing : -facing, inNormal);
#endif
#ifdef DOUBLE_SIDED
  if (!gl_FrontFacing) {  // glTF 2.0, 3.9.6: the back face has the reversed shading normal, bumps included
    v.normal = -v.normal;
    v.tangent = -v.tangent;  // with w, so that the bitangent turns round too
#ifdef HAS_COAT_TANGENT
    v.coatTangent = -v.coatTangent;
#endif
#ifdef HAS_GRAIN_TANGENT
    v.grainTangent = -v.grainTangent;
#endif
  }
#endif
  return v;
}

vec3 towardsViewer(vec3 position) {
  return frame.eye.w > 0.5 ? safeNormalize(frame.eye.xyz - position, vec3(0.0, 0.0, 1.0)) : frame.towardsEye.xyz;
}

#ifdef CHANNEL
#ifdef SHOWS_NODE
layout(location = 14) flat in uint inNode;
#else
const uint inNode = 0u;
#endif
#include "channels.glsl"
#endif

void main() {
  Varyings v = readVaryings();
  vec4 baseColor = materialBaseColor(v);
#ifdef ALPHA_MASK
  if (!coverMasked(v, baseColor.a, uint(gl_PrimitiveID) ^ hashedBits(inInstance))) discard;
#endif
#ifdef ALPHA_BLEND
  float coverage = clamp(baseColor.a, 0.0, 1.0);
#else
  float coverage = 1.0;
#endif
#if defined(CHANNEL)
  outColor = vec4(shownChannel(v, towardsViewer(v.position), baseColor, inNode), 1.0);
#elif defined(UNLIT)
#ifdef UNLIT_EMISSION
  baseColor.rgb += materialEmission(v);
#endif
  outColor = vec4(min(emittedPart(baseColor.rgb) * frame.stored.x, frame.stored.z) * coverage, coverage);
#else
  vec4 lit = litRadiance(v, towardsViewer(v.position), baseColor.rgb);
  // What is no number stays none, to be counted and seen: clamp may give anything of it.
  if (!any(isnan(lit.rgb))) lit.rgb = clamp(lit.rgb * frame.stored.x, 0.0, frame.stored.z);
  outColor = lit * coverage;
#ifdef ALPHA_BLEND
  outColor += unblended(gl_FragCoord.xy, coverage);
#endif
#endif
#ifdef BLEND_LISTS
  keepBlended(blendHead(ivec2(gl_FragCoord.xy), int(frame.picture.x)), outColor, gl_FragCoord.z,
              blendOrder + (uint(gl_PrimitiveID) & 0xfffffu), uint(gl_SampleMaskIn[0]));
#endif
}
