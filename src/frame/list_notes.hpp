#pragma once

// What is to be told of a picture before it is drawn: what of the wish shows nowhere in it.

#include "base/error.hpp"
#include "frame/draw_list.hpp"

namespace facet::frame {

// needs: what the list and its background read of the environment.
Notes listNotes(const DrawList& list, const ibl::Needs& needs);

}  // namespace facet::frame
