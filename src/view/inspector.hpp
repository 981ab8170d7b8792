#pragma once

// A click into the picture: which node is there, and what the shaders make of it at that pixel. The values are the
// debug channels' own, drawn for the one pixel in single precision, so that they are what the picture is made of.

#include "view/viewport.hpp"

namespace facet::view {

// Selects what is drawn at the point, in pixels of a window of that size, from its top left; nothing there: deselects.
// One-sided triangles are seen from the front only; where a material is masked, the texels that are left out are
// clicked through. A line or a point is met from four pixels of the window on, unless a surface hides it or is clicked
// in front of it; its values are those where it is nearest.
void clickAt(Viewport& viewport, ViewerState& state, const glm::dvec2& at, const glm::dvec2& windowSize);

// Looks up the next of the values, one a turn, because each may have to compile a program. True while there is more.
bool inspectNext(Viewport& viewport, ViewerState& state);

// The radiance of the picture on the screen at the inspected pixel; unchanged where the camera has left it. Waits for
// the GPU.
void readRadianceThere(const Viewport& viewport, ViewerState& state);

// Selects a node of the tree; nothing is inspected then. -1: none.
void selectNode(ViewerState& state, int node);
// What is to be told of a material of the model (-1: the default one): factors that are not the usual ones, textures
// with their sizes and formats.
std::vector<Detail> materialDetails(const Viewport& viewport, int material);

// Is the node the other one or below it?
bool isWithin(const scene::Model& model, int node, int ancestor);
// World; empty where nothing is selected or what is selected is not drawn.
scene::Bounds selectionBounds(const Viewport& viewport, const ViewerState& state);

}  // namespace facet::view
