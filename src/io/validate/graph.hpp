#pragma once

// Who is below whom. Made from the well-formed references alone; told are loops, second parents and roots that are
// none.

#include <set>
#include <vector>

#include "io/validate/asset.hpp"

namespace facet::io::validate {

struct Graph {
  std::vector<int> parents;           // by node; -1: a root; the last that names it
  std::vector<bool> inLoop;           // by node
  std::vector<std::set<int>> scenes;  // by node: in which it is
};

// Tells of NODE_PARENT_OVERRIDE and SCENE_NON_ROOT_NODE once, for checkNodes.
Graph graphOf(Asset& asset);

// The topmost node above (or the node itself); where there is a loop, one of it.
int rootOf(const Graph& graph, int node);

// The well-formed joints of a skin.
std::vector<int> jointsOf(const Asset& asset, int skin);

// The parents alone, without a word.
std::vector<int> parentsOf(const Asset& asset);

}  // namespace facet::io::validate
