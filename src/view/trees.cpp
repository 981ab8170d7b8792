#include "view/trees.hpp"

#include <exception>
#include <utility>

namespace facet::view {

namespace {

TreesMade make(const TreesOf& of, const frame::DrawList& list) {
  try {
    return {of, frame::pathTrees(list)};
  } catch (const std::exception&) {  // of memory or of threads
    return {of, fail(of.inputs.model->model.name, "", "memory or threads do not suffice for trees of its triangles",
                     "give a smaller input, or choose no visibility")};
  }
}

}  // namespace

Result<std::optional<frame::PathTrees>> findOrMakeTrees(Trees& trees, const frame::ListInputs& inputs,
                                                        const frame::DrawList& list) {
  const TreesOf wanted{inputs, list.features};
  if (std::optional<TreesMade> made = trees.making.take()) trees.made = std::move(made);
  if (trees.made && trees.made->of == wanted) {
    Result<frame::PathTrees> found = std::move(std::exchange(trees.made, std::nullopt)->trees);
    trees.asked = {};
    if (!found) return tl::unexpected(found.error());
    return std::optional(std::move(*found));
  }
  if (!trees.making.running() || trees.asked != wanted) {
    trees.made.reset();
    trees.asked = wanted;
    trees.making.start([wanted, list] { return make(wanted, list); });
  }
  return std::optional<frame::PathTrees>();
}

void forgetTrees(Trees& trees) {
  trees.making.forget();
  trees.made.reset();
  trees.asked = {};
}

}  // namespace facet::view
