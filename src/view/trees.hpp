#pragma once

// Trees of what is shown, for the rays of a picture at rest: made beside the window, which goes on meanwhile.

#include "frame/plan.hpp"
#include "view/latest.hpp"

namespace facet::view {

struct TreesMade {
  frame::ListInputs inputs;  // of the list that they are of
  shading::FrameFeatures features;
  Result<frame::PathTrees> trees;
};

// The newest that were asked for.
struct Trees {
  Latest<TreesMade> making;
  std::optional<TreesMade> made;  // not taken yet
  frame::ListInputs inputs;       // of those that are being made
  shading::FrameFeatures features;
};

// Of that list, once; nothing while they are being made. Errors: the memory does not suffice.
Result<std::optional<frame::PathTrees>> findOrMakeTrees(Trees& trees, const frame::ListInputs& inputs,
                                                        const frame::DrawList& list);

// They are not wanted any more.
void forgetTrees(Trees& trees);

}  // namespace facet::view
