#pragma once

// What moves the vertices of a primitive: skins (JOINTS_n, WEIGHTS_n: gltf_influences.cpp) and morph targets
// (gltf_morphs.cpp). The accessors that are named exist and are as long as the positions.

#include <string>
#include <vector>

#include "io/gltf_document.hpp"
#include "io/gltf_draco.hpp"

namespace facet::io {

// ---- Skins ----------------------------------------------------------------------------------------------------------

// Of the skins that a mesh is drawn with, the one with the fewest joints; -1: the mesh is drawn without.
struct JointLimit {
  int skin = -1;
  size_t joints = 0;
};

// By mesh. After readSkins and readNodes.
std::vector<JointLimit> jointLimits(const Document& doc);

// Errors: joints or weights of a type that neither can have.
Result<void> checkInfluences(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place);

// Bytes that they can take once they are read, with Primitive::jointBounds.
uint64_t influenceBytes(const Document& doc, const tinygltf::Primitive& primitive, const JointLimit& limit);

// The attributes to decode; the names belong to the primitive.
void appendInfluenceNames(const tinygltf::Primitive& primitive, std::vector<const char*>& names);

// Fills influences; positions must be there. A mesh that is drawn without a skin gets none. Any number of sets; shares
// of zero are dropped, several of one joint added, the rest sorted (largest first) and normalised. Negative and
// non-finite weights count as zero; a vertex without any follows its first joint, or joint 0 where the skin does not
// have that. Sets of which one half is missing are ignored. Errors: a share of a joint that the skin does not have. May
// throw std::bad_alloc.
Result<void> readInfluences(const Document& doc, const tinygltf::Primitive& from, const DracoGeometry& draco,
                            const std::string& place, const JointLimit& limit, scene::Primitive& primitive,
                            Notes& notes);

// ---- Morph targets --------------------------------------------------------------------------------------------------

// The largest number of targets of the mesh's primitives, which should all have as many.
size_t targetCount(const tinygltf::Mesh& mesh);

// Errors: differences of a type that they cannot have.
Result<void> checkTargets(const Document& doc, const tinygltf::Primitive& primitive, const std::string& place);

// Bytes that they can take once they are read, `count` of them (the mesh's): in memory or on the GPU, where those that
// add nothing take as much as the others. POSITION must be there.
uint64_t targetBytes(const Document& doc, const tinygltf::Primitive& primitive, size_t count);

// Fills targets; the attributes that they change must be there. Where there are any, they become `count`, the mesh's,
// with empty ones at the end. Differences that are not finite become zero; arrays that add nothing are left empty. May
// throw std::bad_alloc.
void readTargets(const Document& doc, const tinygltf::Primitive& from, size_t count, const std::string& place,
                 scene::Primitive& primitive, Notes& notes);

// Mesh::weights and Mesh::targetNames; says where the numbers of targets differ.
Result<void> readMeshWeights(Document& doc, size_t mesh);

// Weights for that many targets: fewer are kept, more cut off; either is noted. Errors: not finite.
Result<std::vector<float>> readWeights(Document& doc, const std::vector<double>& values, size_t targets,
                                       const std::string& place);

}  // namespace facet::io
