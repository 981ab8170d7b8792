#pragma once

// The rows of the scene tree: pure. Only what is open becomes rows, and only what is seen of those is drawn, so that a
// hundred thousand nodes cost nothing while nothing changes.

#include <string>
#include <vector>

#include "scene/model.hpp"

namespace facet::view {

enum class TreeKind { nodes, meshes, materials, textures };

struct TreeRow {
  int index = 0;  // of the node, mesh or material
  int depth = 0;
  bool parent = false;  // has children
};

// What the tree remembers between frames.
struct SceneTree {
  TreeKind kind = TreeKind::nodes;
  std::string filter;
  std::vector<bool> open;  // by node

  // Of which the rows were made.
  const scene::Model* model = nullptr;
  int scene = 0;
  bool stale = true;
  std::vector<TreeRow> rows;
};

// Nodes depth first, those below closed ones left out; with a filter, all whose names hold it (case of letters does not
// count), without indentation.
std::vector<TreeRow> treeRows(const scene::Model& model, int scene, const SceneTree& tree);

// Makes the rows anew where the model, the scene or anything else has changed; another model starts closed, but for the
// roots where there are few.
void updateTree(SceneTree& tree, const scene::Model& model, int scene);

// Opens what is above the node; its row, -1 where it has none.
int reveal(SceneTree& tree, const scene::Model& model, int scene, int node);

// "chair", or "node 3" where it has no name.
std::string nodeName(const scene::Model& model, int node);
std::string meshName(const scene::Model& model, int mesh);
std::string materialName(const scene::Model& model, int material);
// "mesh, skin", "camera".
std::string nodeKinds(const scene::Node& node);

}  // namespace facet::view
