#include "view/scene_tree.hpp"

#include <catch2/catch.hpp>

using namespace facet;

namespace {

// root (0) > arm (1) > Hand (2); lamp (3).
scene::Model exampleModel() {
  scene::Model model;
  model.nodes.resize(4);
  model.nodes[0].name = "root";
  model.nodes[0].children = {1};
  model.nodes[1].children = {2};
  model.nodes[1].parent = 0;
  model.nodes[1].mesh = model.nodes[1].skin = 0;
  model.nodes[2].name = "Left Hand";
  model.nodes[2].parent = 1;
  model.nodes[3].name = "lamp";
  model.nodes[3].light = 0;
  model.scenes = {{"", {0, 3}}};
  model.meshes = {{"cube", {}}, {"", {}}};
  model.materials.resize(2);
  model.materials[1].name = "Brass";
  return model;
}

std::vector<int> indices(const view::SceneTree& tree) {
  std::vector<int> all;
  for (const view::TreeRow& row : tree.rows) all.push_back(row.index);
  return all;
}

}  // namespace

TEST_CASE("scene tree: open nodes show what is below them, a few roots are open at first") {
  const scene::Model model = exampleModel();
  view::SceneTree tree;
  view::updateTree(tree, model, 0);
  CHECK(indices(tree) == std::vector<int>{0, 1, 3});
  CHECK(tree.rows[1].depth == 1);
  CHECK(tree.rows[1].parent);
  CHECK_FALSE(tree.rows[2].parent);
  tree.open[0] = false;
  view::updateTree(tree, model, 0);
  CHECK(tree.rows.size() == 3);  // not before it is called stale
  tree.stale = true;
  view::updateTree(tree, model, 0);
  CHECK(indices(tree) == std::vector<int>{0, 3});
}

TEST_CASE("scene tree: a search finds what is closed, a selection opens what is above it") {
  const scene::Model model = exampleModel();
  view::SceneTree tree;
  tree.filter = "left h";
  view::updateTree(tree, model, 0);
  CHECK(indices(tree) == std::vector<int>{2});
  tree.filter = "zzz";
  tree.stale = true;
  view::updateTree(tree, model, 0);
  CHECK(tree.rows.empty());
  tree.kind = view::TreeKind::materials;
  CHECK(view::reveal(tree, model, 0, 2) == 2);
  CHECK(indices(tree) == std::vector<int>{0, 1, 2, 3});
  CHECK(tree.filter.empty());
  tree.kind = view::TreeKind::materials;
  tree.filter = "BRASS";
  tree.stale = true;
  view::updateTree(tree, model, 0);
  CHECK(indices(tree) == std::vector<int>{1});
}

TEST_CASE("scene tree: names and kinds") {
  const scene::Model model = exampleModel();
  CHECK(view::nodeName(model, 0) == "root");
  CHECK(view::nodeName(model, 1) == "node 1");
  CHECK(view::meshName(model, 1) == "mesh 1");
  CHECK(view::materialName(model, 0) == "material 0");
  CHECK(view::nodeKinds(model.nodes[1]) == "mesh, skin");
  CHECK(view::nodeKinds(model.nodes[3]) == "light");
  CHECK(view::nodeKinds(model.nodes[0]).empty());
}

TEST_CASE("scene tree: a hundred thousand nodes in a chain and in a row") {
  constexpr int count = 100'000;
  scene::Model model;
  model.nodes.resize(count);
  model.scenes.resize(1);
  for (int i = 0; i < count; ++i) model.scenes[0].nodes.push_back(i);
  view::SceneTree tree;
  view::updateTree(tree, model, 0);
  CHECK(tree.rows.size() == count);
  CHECK(view::reveal(tree, model, 0, count - 1) == count - 1);

  model.scenes[0].nodes = {0};
  for (int i = 0; i + 1 < count; ++i) {
    model.nodes[static_cast<size_t>(i)].children = {i + 1};
    model.nodes[static_cast<size_t>(i + 1)].parent = i;
  }
  view::SceneTree chain;
  CHECK(view::reveal(chain, model, 0, count - 1) == count - 1);
  CHECK(chain.rows.back().depth == count - 1);
}
