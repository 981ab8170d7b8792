#pragma once

#include "scene/model.hpp"

namespace facet::scene {

// Every point lies behind the front of every triangle, or as good as in it (1e-5 of the extent): from its front such a
// shape is seen by no other part of it. False also where it would take more than some milliseconds to know.
bool isConvex(const Primitive& primitive);

}  // namespace facet::scene
