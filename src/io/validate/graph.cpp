#include "io/validate/graph.hpp"

#include <algorithm>

namespace facet::io::validate {

namespace {

// Calls with position and node for each well-formed index of a list.
template <class Function>
void forEachIndex(const Json& list, size_t count, Function&& function) {
  if (!list.is_array()) return;
  for (size_t i = 0; i < list.size(); ++i)
    if (const auto index = whole(list[i]); index && *index >= 0 && static_cast<uint64_t>(*index) < count)
      function(i, static_cast<int>(*index));
}

void spreadScene(const Json& nodes, Graph& graph, int scene, int root) {
  std::vector<int> open = {root};
  while (!open.empty()) {
    const auto node = static_cast<size_t>(open.back());
    open.pop_back();
    if (!graph.scenes[node].insert(scene).second) continue;
    forEachIndex(member(nodes[node], "children"), nodes.size(), [&](size_t, int child) { open.push_back(child); });
  }
}

std::vector<bool> loopsOf(const std::vector<int>& parents) {
  enum : uint8_t { fresh, open, done };
  std::vector<uint8_t> state(parents.size(), fresh);
  std::vector<bool> inLoop(parents.size());
  for (size_t i = 0; i < parents.size(); ++i) {
    int node = static_cast<int>(i);
    while (node >= 0 && state[static_cast<size_t>(node)] == fresh) {
      state[static_cast<size_t>(node)] = open;
      node = parents[static_cast<size_t>(node)];
    }
    if (node >= 0 && state[static_cast<size_t>(node)] == open) {
      for (int n = node; !inLoop[static_cast<size_t>(n)]; n = parents[static_cast<size_t>(n)])
        inLoop[static_cast<size_t>(n)] = true;
    }
    for (int n = static_cast<int>(i); n >= 0 && state[static_cast<size_t>(n)] == open;
         n = parents[static_cast<size_t>(n)])
      state[static_cast<size_t>(n)] = done;
  }
  return inLoop;
}

}  // namespace

std::vector<int> parentsOf(const Asset& asset) {
  const Json& nodes = collection(asset, "nodes");
  std::vector<int> parents(nodes.size(), -1);
  for (size_t i = 0; i < nodes.size(); ++i)
    forEachIndex(member(nodes[i], "children"), nodes.size(),
                 [&](size_t, int child) { parents[static_cast<size_t>(child)] = static_cast<int>(i); });
  return parents;
}

Graph graphOf(Asset& asset) {
  const Json &nodes = collection(asset, "nodes"), &scenes = collection(asset, "scenes");
  Graph graph;
  graph.parents.assign(nodes.size(), -1);
  graph.scenes.resize(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i)
    forEachIndex(member(nodes[i], "children"), nodes.size(), [&](size_t k, int child) {
      int& parent = graph.parents[static_cast<size_t>(child)];
      if (parent >= 0)
        asset.add(Code::NODE_PARENT_OVERRIDE, at(at("/nodes", i) + "/children", k),
                  "node " + std::to_string(child) + " has node " + std::to_string(parent) + " as its parent, too");
      parent = static_cast<int>(i);
    });
  graph.inLoop = loopsOf(graph.parents);
  for (size_t i = 0; i < scenes.size(); ++i)
    forEachIndex(member(scenes[i], "nodes"), nodes.size(), [&](size_t k, int root) {
      if (graph.parents[static_cast<size_t>(root)] >= 0)
        asset.add(Code::SCENE_NON_ROOT_NODE, at(at("/scenes", i) + "/nodes", k),
                  "node " + std::to_string(root) + " is below node " +
                      std::to_string(graph.parents[static_cast<size_t>(root)]));
      spreadScene(nodes, graph, static_cast<int>(i), root);
    });
  return graph;
}

int rootOf(const Graph& graph, int node) {
  for (size_t steps = 0; steps < graph.parents.size() && graph.parents[static_cast<size_t>(node)] >= 0; ++steps)
    node = graph.parents[static_cast<size_t>(node)];
  return node;
}

std::vector<int> jointsOf(const Asset& asset, int skin) {
  std::vector<int> joints;
  forEachIndex(member(element(asset, "skins", skin), "joints"), collection(asset, "nodes").size(),
               [&](size_t, int joint) { joints.push_back(joint); });
  return joints;
}

}  // namespace facet::io::validate
