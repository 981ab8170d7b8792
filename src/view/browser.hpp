#pragma once

// The browser at the window's left: what there is to look at, searchable, with previews.

#include <array>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/texture.hpp"
#include "view/listing.hpp"
#include "view/panel.hpp"
#include "view/thumbnails.hpp"
#include "view/viewer_state.hpp"

namespace facet::view {

struct Thumbnail {
  gl::Texture texture;  // none: it is waited for, or could not be made
  std::string problem;
};

struct Browser {
  Browser() = default;
  ~Browser() { stopScans.request_stop(); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  std::vector<Entry> opened, recent, builtin;
  std::vector<FolderListing> listings;
  std::vector<Entry> entries;  // all of them, as they are listed
  // Indices of those that match, by kind; made anew where the query or the entries are new.
  std::array<std::vector<int>, 3> rows;
  std::optional<std::string> filteredBy;
  std::array<bool, 3> open = {true, true, true};  // sections, last frame
  std::vector<std::future<FolderListing>> scans;
  std::vector<std::filesystem::path> dropped;  // folders whose scan is waited for
  std::optional<FolderListing> found;          // of one of them
  std::stop_source stopScans;
  std::function<void()> wake;

  char query[256] = "";
  int focusing = 0;         // frames until the search has the keyboard
  std::string cursor;       // source of the row that the keyboard has chosen
  bool showCursor = false;  // scroll there

  std::unique_ptr<ThumbnailMaker> maker;
  std::map<std::string, Thumbnail> thumbnails;  // by source
};

// Built-ins, recent files, and these folders. cache: of previews. wake: called from another thread when there is
// something to collect.
void openBrowser(Browser& browser, const std::vector<std::string>& folders, DiskCache cache,
                 const std::function<void()>& wake);

// Lists all that is in the folder; a folder that is listed already is read anew.
void browseFolder(Browser& browser, const std::string& folder, const ScanLimits& limits = {});
// The same of one that was dropped, beside which no search hides anything.
void dropFolder(Browser& browser, const std::string& folder);
// Tells what such a folder holds, once it is known; its model where it is the only one, which is to be opened then.
std::string takeDropped(Browser& browser, ViewerState& state);
// A file that is shown: listed with those beside it, scrolled into sight where it is a
// model, and remembered for the next time.
void noteOpened(Browser& browser, FileKind kind, const std::string& source);
// The file has changed: its preview is made anew.
void forgetThumbnail(Browser& browser, const std::string& source);

// All measured BRDFs that are listed.
std::vector<Entry> databases(const Browser& browser);

// What scans and previews have brought. True where there is something new to draw.
bool collect(Browser& browser);

// Between ImGui::NewFrame and ImGui::Render.
void drawBrowser(Browser& browser, ViewerState& state, PanelResult& result);

}  // namespace facet::view
