#include "view/trees.hpp"

#include <exception>
#include <utility>

namespace facet::view {

namespace {

// The inputs hold the model that the list points to.
TreesMade make(const frame::ListInputs& inputs, const frame::DrawList& list) {
  try {
    return {inputs, list.features, frame::pathTrees(list)};
  } catch (const std::exception&) {  // of memory or of threads
    return {inputs, list.features,
            fail(inputs.model->model.name, "", "memory or threads do not suffice for trees of its triangles",
                 "give a smaller input, or choose no visibility")};
  }
}

}  // namespace

Result<std::optional<frame::PathTrees>> findOrMakeTrees(Trees& trees, const frame::ListInputs& inputs,
                                                        const frame::DrawList& list) {
  const auto ofThis = [&](const auto& of) { return of.inputs == inputs && of.features == list.features; };
  if (std::optional<TreesMade> made = trees.making.take()) trees.made = std::move(made);
  if (trees.made && ofThis(*trees.made)) {
    Result<frame::PathTrees> found = std::move(std::exchange(trees.made, std::nullopt)->trees);
    trees.inputs = {};
    if (!found) return tl::unexpected(found.error());
    return std::optional(std::move(*found));
  }
  if (!trees.making.running() || !ofThis(trees)) {
    trees.made.reset();
    trees.inputs = inputs, trees.features = list.features;
    trees.making.start([inputs, list] { return make(inputs, list); });
  }
  return std::optional<frame::PathTrees>();
}

void forgetTrees(Trees& trees) {
  trees.making.forget();
  trees.made.reset();
  trees.inputs = {};
}

}  // namespace facet::view
