#pragma once

// The node tree: who is drawn where. Double precision throughout, because a chain of transforms far from the origin
// loses metres in single precision.

#include <vector>

#include "scene/pose.hpp"

namespace facet::scene {

// translation * rotation * scale, or the node's own matrix.
glm::dmat4 localTransform(const Node& node);

// Takes the node's matrix, if it has one, apart into translation, rotation, scale: scales are the columns' lengths, the
// first of them negative for a left-handed matrix; shear is lost. A column of length 0 leaves its axis to the others.
void decompose(Node& node);

// One entry per node of the model in each vector but `order`.
struct NodeTransforms {
  std::vector<glm::dmat4> worldFromNode;  // identity where not reached
  std::vector<bool> reached;              // the scene's roots and all below them, hidden or not
  std::vector<bool> hidden;               // Node::visible is false for the node or for one above it
  std::vector<bool> wanted;               // its mesh is drawn if it is not hidden (Pose::only)
  std::vector<int> order;                 // those reached, depth first, each once
};

// Iterative, so a chain of any depth is fine. A scene index outside the model reaches nothing.
NodeTransforms worldTransforms(const Model& model, int scene, const Pose& pose = {});

// A mesh placed in the world. All primitives of a skinned one need influences (glTF 2.0, 3.7.3.3); where some have
// none, they stay where the identity leaves them.
struct Instance {
  int node = -1, mesh = -1;
  glm::dmat4 worldFromNode = glm::dmat4(1);  // of a skinned mesh: the identity, because its joints place it
  bool mirrored = false;                     // left-handed: front faces wind clockwise; skins: as most of the joints
  int skin = -1;                             // index in FlatScene::joints; only where the mesh has influences
};

struct PlacedLight {
  int node = -1, light = -1;
  glm::dvec3 position = glm::dvec3(0);          // world, metres
  glm::dvec3 direction = glm::dvec3(0, 0, -1);  // world, unit; the way that it shines
  glm::dvec3 side = glm::dvec3(1, 0, 0);        // world, unit; the node's +X, perpendicular to direction
  bool mirrored = false;                        // its +Y is not cross(side, direction), but the opposite
};

struct PlacedCamera {
  int node = -1, camera = -1;
  glm::dmat4 worldFromNode = glm::dmat4(1);
};

// What one scene draws, in depth-first order of its nodes. Meshes without primitives are left out.
struct FlatScene {
  std::vector<Instance> instances;
  std::vector<PlacedLight> lights;
  std::vector<PlacedCamera> cameras;
  // By skin of the model: world from mesh for each joint, empty where no instance uses the skin. Joints outside the
  // scene stand where their own parents put them; hidden ones move their vertices like others. One that is not finite
  // takes the place of the skin's first finite one.
  std::vector<std::vector<glm::dmat4>> joints;
  int overflowed = 0;  // instances, lights, cameras left out and joints replaced: their transform is not finite
};

// Leaves out meshes that are not among Pose::only, and the meshes and lights of hidden nodes and of all below them, but
// not their cameras, as KHR_node_visibility says. Draws a node's mesh once for each of Node::instances; a skinned one
// only once, because its joints place it (EXT_mesh_gpu_instancing leaves that open).
FlatScene flatten(const Model& model, int scene, const Pose& pose = {});

// Box around all instances' primitives as they are in the pose, as the union of their transformed boxes: never too
// small, up to sqrt(3) too large where a node turns its mesh by odd angles. Empty where nothing is drawn.
Bounds sceneBounds(const Model& model, const FlatScene& flat, const Pose& pose = {});
Bounds sceneBounds(const Model& model, int scene, const Pose& pose = {});

// The box around the transformed box (Arvo 1990, "Transforming axis-aligned bounding boxes").
Bounds transformed(const Bounds& bounds, const glm::dmat4& matrix);

// Left-handed? Independent of scale (1e-6 or 1e6 per axis); a singular matrix is not.
bool isMirrored(const glm::dmat4& matrix);

// Takes normals along: sign(det M) cofactor(M), a multiple of the inverse transpose that also exists for singular M,
// scaled so that its longest column is 1. Where M flattens to a plane, every normal becomes the plane's; where it
// flattens to a line or a point, nothing is left to be shaded and the result is the identity. Results need normalising.
glm::dmat3 normalTransform(const glm::dmat4& matrix);

}  // namespace facet::scene
