#pragma once

// Trees of what is shown, for the rays of a picture at rest: made beside the window, which goes on meanwhile.

#include "frame/plan.hpp"
#include "view/latest.hpp"

namespace facet::view {

// Which list they are of. The inputs hold the model that it points to.
struct TreesOf {
  frame::ListInputs inputs;
  shading::FrameFeatures features;

  bool operator==(const TreesOf&) const = default;
};

struct TreesMade {
  TreesOf of;
  Result<frame::PathTrees> trees;
};

// The newest that were asked for.
struct Trees {
  Latest<TreesMade> making;
  std::optional<TreesMade> made;  // not taken yet
  TreesOf asked;                  // of those that are being made
};

// Of that list, once; nothing while they are being made. Errors: the memory does not suffice.
Result<std::optional<frame::PathTrees>> findOrMakeTrees(Trees& trees, const frame::ListInputs& inputs,
                                                        const frame::DrawList& list);

// They are not wanted any more.
void forgetTrees(Trees& trees);

}  // namespace facet::view
