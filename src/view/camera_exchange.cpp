#include "view/camera_exchange.hpp"

#include <imgui.h>

#include "base/log.hpp"
#include "options/camera_text.hpp"
#include "view/layout.hpp"

namespace facet::view {

namespace {

std::filesystem::path bookmarksFile() {
  const std::filesystem::path folder = userConfigFolder();
  return folder.empty() ? folder : folder / "bookmarks.json";
}

}  // namespace

void copyCamera(ViewerState& state) {
  const std::string text = options::cameraText(commandSettings(state).viewpoint);
  ImGui::SetClipboardText(text.c_str());
  say(state, "copied: " + text);
}

void pasteCamera(ViewerState& state) {
  const char* text = ImGui::GetClipboardText();
  const Result<void> went = goToCamera(state, text ? text : "");
  if (!went) return complain(state, went.error());
  say(state, "pasted: " + options::cameraText(commandSettings(state).viewpoint));
}

Bookmarks loadBookmarks(ViewerState& state) {
  if (Result<Bookmarks> bookmarks = readBookmarks(bookmarksFile()))
    state.bookmarks = std::move(*bookmarks);
  else
    complain(state, bookmarks.error());
  return state.bookmarks;
}

void keepBookmarks(const ViewerState& state, Bookmarks& held) {
  if (state.bookmarks == held) return;
  held = state.bookmarks;
  const std::filesystem::path file = bookmarksFile();
  if (file.empty()) return;
  if (const Result<void> written = writeBookmarks(file, held); !written) log::warning(describe(written.error()));
}

}  // namespace facet::view
