#include "view/scene_tree.hpp"

#include <algorithm>

namespace facet::view {

namespace {

std::string nameOr(const std::string& name, const char* kind, int index) {
  return name.empty() ? std::string(kind) + " " + std::to_string(index) : name;
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; }

bool holds(const std::string& text, const std::string& part) {
  const auto same = [](char a, char b) { return lower(a) == lower(b); };
  return part.empty() || std::search(text.begin(), text.end(), part.begin(), part.end(), same) != text.end();
}

template <class Name>
std::vector<TreeRow> listed(size_t count, const std::string& filter, const Name& name) {
  std::vector<TreeRow> rows;
  for (int i = 0; i < static_cast<int>(count); ++i)
    if (filter.empty() || holds(name(i), filter)) rows.push_back({i, 0, false});
  return rows;
}

}  // namespace

std::string nodeName(const scene::Model& model, int node) {
  return nameOr(model.nodes[static_cast<size_t>(node)].name, "node", node);
}

std::string meshName(const scene::Model& model, int mesh) {
  return nameOr(model.meshes[static_cast<size_t>(mesh)].name, "mesh", mesh);
}

std::string materialName(const scene::Model& model, int material) {
  return nameOr(model.materials[static_cast<size_t>(material)].name, "material", material);
}

std::string nodeKinds(const scene::Node& node) {
  std::string kinds;
  const auto add = [&](bool has, const std::string& kind) {
    if (has) kinds += (kinds.empty() ? "" : ", ") + kind;
  };
  add(node.mesh >= 0, "mesh");
  add(!node.instances.empty(), std::to_string(node.instances.size()) + " instances");
  add(node.skin >= 0, "skin");
  add(node.camera >= 0, "camera");
  add(node.light >= 0 || node.profiledLight >= 0, "light");
  add(!node.visible, "hidden");
  return kinds;
}

std::vector<TreeRow> treeRows(const scene::Model& model, int scene, const SceneTree& tree) {
  if (tree.kind == TreeKind::meshes)
    return listed(model.meshes.size(), tree.filter, [&](int i) { return meshName(model, i); });
  if (tree.kind == TreeKind::materials)
    return listed(model.materials.size(), tree.filter, [&](int i) { return materialName(model, i); });
  std::vector<TreeRow> rows;
  if (scene < 0 || scene >= static_cast<int>(model.scenes.size())) return rows;
  std::vector<TreeRow> stack;
  const auto push = [&](const std::vector<int>& nodes, int depth) {
    for (auto it = nodes.rbegin(); it != nodes.rend(); ++it)
      stack.push_back({*it, depth, !model.nodes[static_cast<size_t>(*it)].children.empty()});
  };
  push(model.scenes[static_cast<size_t>(scene)].nodes, 0);
  const bool filtered = !tree.filter.empty();
  while (!stack.empty()) {
    const TreeRow row = stack.back();
    stack.pop_back();
    const auto index = static_cast<size_t>(row.index);
    if (!filtered || holds(nodeName(model, row.index), tree.filter))
      rows.push_back({row.index, filtered ? 0 : row.depth, row.parent});
    if (filtered || (index < tree.open.size() && tree.open[index])) push(model.nodes[index].children, row.depth + 1);
  }
  return rows;
}

void updateTree(SceneTree& tree, const scene::Model& model, int scene) {
  constexpr size_t fewRoots = 8;
  if (tree.model != &model || tree.scene != scene) {
    tree.model = &model;
    tree.scene = scene;
    tree.stale = true;
    tree.open.assign(model.nodes.size(), false);
    const bool known = scene >= 0 && scene < static_cast<int>(model.scenes.size());
    if (known && model.scenes[static_cast<size_t>(scene)].nodes.size() <= fewRoots)
      for (const int root : model.scenes[static_cast<size_t>(scene)].nodes) tree.open[static_cast<size_t>(root)] = true;
  }
  if (tree.stale) tree.rows = treeRows(model, scene, tree);
  tree.stale = false;
}

int reveal(SceneTree& tree, const scene::Model& model, int scene, int node) {
  updateTree(tree, model, scene);
  if (tree.kind != TreeKind::nodes || !tree.filter.empty()) tree.stale = true;
  tree.kind = TreeKind::nodes;
  tree.filter.clear();
  for (int above = model.nodes[static_cast<size_t>(node)].parent; above >= 0;
       above = model.nodes[static_cast<size_t>(above)].parent)
    if (!tree.open[static_cast<size_t>(above)]) tree.open[static_cast<size_t>(above)] = tree.stale = true;
  updateTree(tree, model, scene);
  const auto found = std::ranges::find(tree.rows, node, &TreeRow::index);
  return found == tree.rows.end() ? -1 : static_cast<int>(found - tree.rows.begin());
}

}  // namespace facet::view
