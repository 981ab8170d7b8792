#pragma once

// A draw list seen by a camera -> what is drawn, and in which order. Pure, no OpenGL.

#include <span>
#include <vector>

#include "frame/draw_list.hpp"
#include "scene/camera.hpp"

namespace facet::frame {

// Draws of instances[firstInstance] and on.
struct VisibleDraws {
  std::vector<uint32_t> instances;  // indices in DrawList::instances
  std::vector<Draw> opaque;         // by program, front to back by material
  std::vector<Draw> transmitting;   // likewise
  std::vector<Draw> blended;        // farthest first
  // The first of `blended` that are drawn before the transmitting ones, because they may shine through: those that are
  // not nearer than all boxes of transmitting draws.
  size_t blendedBehind = 0;
  size_t culled = 0;  // instances of draws that lie outside the picture
};

// The part of the picture that is drawn: clip coordinates of its lowest and highest row.
struct ClipRows {
  double low = -1, high = 1;
};

// Leaves out what lies wholly outside the rows' frustum, widened by `margin` (clip coordinates) on each side: room for
// offsets within a pixel and for the width of lines and points. Bounds that are not finite are always drawn. Never
// leaves out what would be seen; keeps up to what its box's corners reach.
VisibleDraws visibleDraws(const DrawList& list, const scene::View& view, const ClipRows& rows, double margin);

}  // namespace facet::frame
