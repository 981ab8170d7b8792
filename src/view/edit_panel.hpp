#pragma once

// Controls of what the scene panel has chosen: the file's values, and others in their places (scene/edit.hpp). A right
// click on one returns to the file's.

#include "view/panel.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

// Undo, redo, how much is changed, all of it back, and into a file.
void editBar(ViewerState& state, PanelResult& result);

void editNode(ViewerState& state, int node);
void editLight(ViewerState& state, int light);
void editMaterial(ViewerState& state, int material);

bool isHidden(const ViewerState& state, int node);
void setHidden(ViewerState& state, int node, bool hidden);

// The model in the world; in the settings.
void modelSection(ViewerState& state);
// Of the one material that everything has: what extensions add.
void materialLayers(frame::PictureSettings& settings);

}  // namespace facet::view
