#pragma once

// What becomes of changes of the model (edit_panel.hpp): steps to undo, parts of the file that they need, a file.

#include <ctime>
#include <filesystem>
#include <string>

#include "view/loader.hpp"
#include "view/viewport.hpp"

namespace facet::view {

// Once a turn, after the panels. The model is read again where it shows what was not read of it.
void followEdits(const Viewport& viewport, ViewerState& state, Loader& loader, bool handOnIt);

// Likewise: the model is read again with the others that the settings put into its scene.
void followTogether(const Viewport& viewport, const ViewerState& state, Loader& loader);

// "helmet.glb" in a folder: "helmet-changed.glb", or with -2, -3, ... where there is such a file already.
std::filesystem::path exportName(const std::string& model, const std::filesystem::path& folder);

// The changed model as a file, beside the window.
void startExport(ViewerState& state, Loader& loader, const std::filesystem::path& file);
void takeExport(ViewerState& state, ModelExported exported);

}  // namespace facet::view
