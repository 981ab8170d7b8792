// Morph targets and skins of the vertex stage. The twin is src/scene/deformation.cpp.
#include "layout.h"
#include "tex_coords.glsl"

#ifdef HAS_MORPH
struct Offsets {
  vec3 position;
  vec3 normal;
  vec3 tangent, coatTangent, grainTangent;
  vec4 color;
  vec2 texCoords[texCoordSetCount];
};

// Target after target, vertex after vertex: `stride` numbers each, positions first. A draw may read fewer attributes than
// the buffer has, so the places of the others are said here.
layout(std430, binding = morphTargetBinding) readonly buffer MorphTargetBlock {
  uint morphVertexCount;
  uint morphStride;
  uint morphNormalAt, morphTangentAt, morphCoatTangentAt, morphGrainTangentAt, morphColorAt;
  uint morphTexCoordAt[texCoordSetCount];  // 0: nothing changes that set
  float morphDifferences[];
};
layout(std430, binding = morphWeightBinding) readonly buffer MorphWeightBlock { MorphWeight morphWeights[]; };

vec3 difference(uint at) { return vec3(morphDifferences[at], morphDifferences[at + 1u], morphDifferences[at + 2u]); }

// glTF 2.0, 3.7.2.2: base + sum of weight * target.
Offsets morphOffsets(Instance instance, uint vertex) {
  Offsets sum;
  sum.position = sum.normal = sum.tangent = sum.coatTangent = sum.grainTangent = vec3(0.0);
  sum.color = vec4(0.0);
  for (int set = 0; set < texCoordSetCount; ++set) sum.texCoords[set] = vec2(0.0);
  for (uint i = 0u; i < instance.deformation.z; ++i) {
    MorphWeight target = morphWeights[instance.deformation.y + i];
    uint at = (target.target * morphVertexCount + vertex) * morphStride;
    sum.position += target.weight * difference(at);
#ifdef MORPH_NORMALS
    sum.normal += target.weight * difference(at + morphNormalAt);
#endif
#ifdef MORPH_TANGENTS
    sum.tangent += target.weight * difference(at + morphTangentAt);
#ifdef HAS_COAT_TANGENT
    sum.coatTangent += target.weight * difference(at + morphCoatTangentAt);
#endif
#ifdef HAS_GRAIN_TANGENT
    sum.grainTangent += target.weight * difference(at + morphGrainTangentAt);
#endif
#endif
#ifdef MORPH_TEXCOORDS
#define ADD_OFFSET(n) \
    if (morphTexCoordAt[n] != 0u) { \
      uint texCoord = at + morphTexCoordAt[n]; \
      sum.texCoords[n] += target.weight * vec2(morphDifferences[texCoord], morphDifferences[texCoord + 1u]); \
    }
    EACH_TEXCOORD(ADD_OFFSET)
#endif
#ifdef MORPH_COLORS
    uint color = at + morphColorAt;
    sum.color += target.weight * vec4(difference(color), morphDifferences[color + 3u]);
#endif
  }
  return sum;
}
#endif

#ifdef HAS_SKIN
layout(std430, binding = influenceBinding) readonly buffer InfluenceBlock {
  uint influencesPerVertex;
  uint influences[];  // joint, bits of the weight
};
layout(std430, binding = jointBinding) readonly buffer JointBlock { Joint joints[]; };

// World from mesh: the mean of the vertex's joints (glTF 2.0, 3.7.3.3). w is 1 up to rounding, because weights sum to 1.
mat4 skinMatrix(Instance instance, uint vertex) {
  vec4 rows[3] = vec4[3](vec4(0.0), vec4(0.0), vec4(0.0));
  for (uint i = 0u; i < influencesPerVertex; ++i) {
    uint at = 2u * (vertex * influencesPerVertex + i);
    float weight = uintBitsToFloat(influences[at + 1u]);
    if (weight == 0.0) break;  // sorted: only padding follows
    Joint joint = joints[instance.deformation.x + influences[at]];
    for (int row = 0; row < 3; ++row) rows[row] += weight * joint.rows[row];
  }
  return transpose(mat4(rows[0], rows[1], rows[2], vec4(0.0, 0.0, 0.0, 1.0)));
}
#endif

// Takes normals along: sign(det m) cofactor(m), from a matrix scaled so that products neither under- nor overflow.
mat3 normalMatrix(mat3 m) {
  vec3 largest3 = max(max(abs(m[0]), abs(m[1])), abs(m[2]));
  float largest = max(largest3.x, max(largest3.y, largest3.z));
  if (!(largest > 0.0)) return mat3(1.0);
  mat3 a = m / largest;
  mat3 cofactor = mat3(cross(a[1], a[2]), cross(a[2], a[0]), cross(a[0], a[1]));
  return dot(cofactor[2], a[2]) < 0.0 ? -1.0 * cofactor : cofactor;
}
