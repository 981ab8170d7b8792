#pragma once

// Cameras that go out of the window and come in: by the clipboard, and by the file of bookmarks.

#include "view/viewer_state.hpp"

namespace facet::view {

void copyCamera(ViewerState& state);
// Of the clipboard's text; where it has none, the status line says so.
void pasteCamera(ViewerState& state);

// Into the state; what the file holds.
Bookmarks loadBookmarks(ViewerState& state);
// As soon as they differ from what the file holds: another window may be opened next.
void keepBookmarks(const ViewerState& state, Bookmarks& held);

}  // namespace facet::view
