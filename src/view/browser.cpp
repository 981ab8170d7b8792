#include "view/browser.hpp"

#include <imgui.h>
#include <imgui/imgui_internal.h>

#include <algorithm>
#include <utility>

#include "base/log.hpp"
#include "view/layout.hpp"
#include "view/recent.hpp"
#include "view/style.hpp"
#include "view/text_fit.hpp"
#include "view/widgets.hpp"

namespace facet::view {

namespace fs = std::filesystem;

namespace {

constexpr size_t keptThumbnails = 512, keptListings = 16;

void gatherEntries(Browser& browser) {
  browser.entries.clear();
  const auto add = [&](const std::vector<Entry>& entries) {
    browser.entries.insert(browser.entries.end(), entries.begin(), entries.end());
  };
  add(browser.opened);
  for (const FolderListing& listing : browser.listings) add(listing.entries);
  add(browser.recent);
  add(browser.builtin);
  browser.filteredBy.reset();
}

void filter(Browser& browser) {
  if (browser.filteredBy == browser.query) return;
  if (browser.filteredBy) browser.cursor.clear();  // Enter takes the first that matches
  browser.filteredBy = browser.query;
  for (const FileKind kind : {FileKind::model, FileKind::environment, FileKind::brdf})
    browser.rows[static_cast<size_t>(kind)] = filtered(browser.entries, kind, browser.query);
}

gl::Texture uploadThumbnail(const io::Pixels& pixels) {
  gl::Texture texture({.format = GL_RGBA8, .width = pixels.width, .height = pixels.height}, "thumbnail");
  const GLenum formats[] = {GL_RED, GL_RG, GL_RGB, GL_RGBA};
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTextureSubImage2D(texture.id(), 0, 0, 0, pixels.width, pixels.height, formats[pixels.channels - 1],
                      GL_UNSIGNED_BYTE, pixels.data.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  texture.filterLinear();
  return texture;
}

bool takeScans(Browser& browser) {
  bool any = false;
  for (auto scan = browser.scans.begin(); scan != browser.scans.end();) {
    if (scan->wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
      ++scan;
      continue;
    }
    FolderListing listing = scan->get();
    if (const auto asked = std::ranges::find(browser.dropped, listing.folder); asked != browser.dropped.end()) {
      browser.dropped.erase(asked);
      browser.found = listing;
    }
    log::debug("listed: " + listing.folder.filename().string() + ", " + std::to_string(listing.entries.size()));
    scan = browser.scans.erase(scan);
    const auto old = std::ranges::find(browser.listings, listing.folder, &FolderListing::folder);
    if (old != browser.listings.end())
      *old = std::move(listing);
    else
      browser.listings.push_back(std::move(listing));
    any = true;
  }
  return any;
}

// What the list needs to know while it is drawn.
struct Drawing {
  Browser& browser;
  ViewerState& state;
  PanelResult& result;
  std::vector<const Entry*> rows;             // all that the keyboard goes through
  std::vector<ThumbnailRequest> wanted = {};  // previews of rows in sight
};

float rowHeight() { return 2.9f * ImGui::GetFontSize(); }

bool sameFile(const std::string& a, const std::string& b) {
  if (a == b) return true;
  if (a.empty() || b.empty() || a.starts_with("builtin:") || b.starts_with("builtin:")) return false;
  std::error_code ignored;
  return fs::absolute(a, ignored).lexically_normal() == fs::absolute(b, ignored).lexically_normal();
}

bool isShown(const ViewerState& state, const Entry& entry) {
  if (entry.kind == FileKind::brdf) return state.shown.measured && sameFile(state.shown.measured->path, entry.source);
  return sameFile(entry.kind == FileKind::model ? state.shown.model : state.shown.environment, entry.source);
}

void open(Drawing& drawing, const Entry& entry) {
  drawing.state.status = {};  // of another file
  drawing.browser.cursor = entry.source;
  if (entry.kind == FileKind::model) {
    (ImGui::GetIO().KeyShift  ? drawing.result.secondModel
     : ImGui::GetIO().KeyCtrl ? drawing.result.addedModel
                              : drawing.result.model) = entry.source;
  } else if (entry.kind == FileKind::environment) {
    offerEnvironment(drawing.state, entry.source);
    drawing.state.settings.sources.environment = entry.source;
  } else {
    chooseBrdf(drawing.state, entry.source);
  }
}

void drawPreview(Drawing& drawing, const Entry& entry, ImVec2 min, float side) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + side, min.y + side);
  const auto found = drawing.browser.thumbnails.find(entry.source);
  if (found != drawing.browser.thumbnails.end() && found->second.texture) {
    const auto name = static_cast<uintptr_t>(found->second.texture.id());
    draw.AddImageRounded(reinterpret_cast<ImTextureID>(name), min, max, {0, 0}, {1, 1}, IM_COL32_WHITE, 3);
    return;
  }
  draw.AddRectFilled(min, max, ImGui::GetColorU32(ImGuiCol_FrameBg), 3);
  if (entry.source == "none") return;
  const bool failed = found != drawing.browser.thumbnails.end();
  const char* sign = failed ? "!" : "\xc2\xb7\xc2\xb7\xc2\xb7";
  const ImVec2 size = ImGui::CalcTextSize(sign);
  const ImU32 color = failed ? warningColor : ImGui::GetColorU32(ImGuiCol_TextDisabled);
  draw.AddText({min.x + (side - size.x) / 2, min.y + (side - size.y) / 2}, color, sign);
  drawing.wanted.push_back({entry.kind, entry.source});  // what has failed: after a while
}

void drawTooltip(const Drawing& drawing, const Entry& entry) {
  const auto found = drawing.browser.thumbnails.find(entry.source);
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(30 * ImGui::GetFontSize());
  ImGui::TextUnformatted(entry.source.c_str());
  if (found != drawing.browser.thumbnails.end() && !found->second.problem.empty()) {
    ImGui::PushStyleColor(ImGuiCol_Text, warningColor);
    ImGui::Text("no preview: %s", found->second.problem.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
}

void drawRow(Drawing& drawing, const Entry& entry) {
  const bool shown = isShown(drawing.state, entry);
  const ImVec2 min = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x, height = rowHeight(), margin = 0.18f * ImGui::GetFontSize();
  ImGui::PushID(entry.source.c_str());
  if (ImGui::Selectable("##row", shown, ImGuiSelectableFlags_None, {0, height})) open(drawing, entry);
  const bool hovered = ImGui::IsItemHovered();
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImVec2 max(min.x + width, min.y + height);
  if (shown) draw.AddRectFilled(min, {min.x + 3, max.y}, ImGui::GetColorU32(ImGuiCol_CheckMark), 1);
  if (entry.source == drawing.browser.cursor) draw.AddRect(min, max, ImGui::GetColorU32(ImGuiCol_SliderGrab), 3);
  const float side = height - 2 * margin, left = min.x + 3 + 2 * margin;
  drawPreview(drawing, entry, {left, min.y + margin}, side);
  const float textLeft = left + side + 3 * margin, line = ImGui::GetTextLineHeight();
  const auto text = [&](float y, const std::string& words, ImGuiCol color) {
    draw.AddText({textLeft, y}, ImGui::GetColorU32(color),
                 middleCut(words, max.x - margin - textLeft, textWidth).c_str());
  };
  const float top = min.y + (height - 2 * line - margin) / 2;
  text(top, entry.name, ImGuiCol_Text);
  const bool loads = !drawing.state.loading.empty() && sameFile(drawing.state.loading, entry.source);
  text(top + line + margin, loads ? "loading" : entry.place, ImGuiCol_TextDisabled);
  if (hovered) drawTooltip(drawing, entry);
  ImGui::PopID();
}

constexpr float rowGap = 2;

float neededHeight(const std::vector<int>& rows) {
  return rows.empty() ? ImGui::GetTextLineHeightWithSpacing()
                      : static_cast<float>(rows.size()) * (rowHeight() + rowGap) + rowGap;
}

// Heights of the sections' lists: what they need where there is room, else even shares of it.
std::array<float, 3> shareHeight(const Browser& browser, float room) {
  std::array<float, 3> heights{};
  std::vector<size_t> order;
  for (size_t kind = 0; kind < heights.size(); ++kind)
    if (browser.open[kind]) order.push_back(kind);
  std::ranges::sort(order, {}, [&](size_t kind) { return browser.rows[kind].size(); });
  for (size_t i = 0; i < order.size(); ++i) {
    const float share = room / static_cast<float>(order.size() - i);
    heights[order[i]] = std::max(1.0f, std::min(neededHeight(browser.rows[order[i]]), share));
    room -= heights[order[i]];
  }
  return heights;
}

void drawRows(Drawing& drawing, size_t first) {
  const Browser& browser = drawing.browser;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, rowGap});
  const float step = rowHeight() + rowGap;
  if (browser.showCursor)
    for (size_t i = first; i < drawing.rows.size(); ++i)
      if (drawing.rows[i]->source == browser.cursor)
        ImGui::SetScrollFromPosY(static_cast<float>(i - first) * step + step / 2 - ImGui::GetScrollY(), 0.5f);
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(drawing.rows.size() - first), step);
  while (clipper.Step())
    for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
      drawRow(drawing, *drawing.rows[first + static_cast<size_t>(i)]);
  ImGui::PopStyleVar();
}

void drawSection(Drawing& drawing, FileKind kind, const char* title, float height) {
  Browser& browser = drawing.browser;
  const std::vector<int>& found = browser.rows[static_cast<size_t>(kind)];
  bool& open = browser.open[static_cast<size_t>(kind)];
  const std::string label = std::string(title) + " (" + std::to_string(found.size()) + ")###" + title;
  open = section(drawing.state.layout, label.c_str());
  if (!open) return;
  if (ImGui::BeginChild(title, {0, height})) {
    if (found.empty()) ImGui::TextDisabled("none matches");
    const size_t first = drawing.rows.size();
    for (const int index : found) drawing.rows.push_back(&browser.entries[static_cast<size_t>(index)]);
    drawRows(drawing, first);
  }
  ImGui::EndChild();
}

void drawFoot(const Browser& browser) {
  if (!browser.scans.empty()) ImGui::TextDisabled("looking through folders");
  for (const FolderListing& listing : browser.listings)
    if (!listing.problem.empty()) {
      ImGui::PushStyleColor(ImGuiCol_Text, quietColor);
      ImGui::TextWrapped("%s: %s", listing.folder.filename().c_str(), listing.problem.c_str());
      ImGui::PopStyleColor();
    }
}

void drawSections(Drawing& drawing) {
  const Browser& browser = drawing.browser;
  constexpr int headers = 3;
  const auto problems = std::ranges::count_if(browser.listings, [](const auto& l) { return !l.problem.empty(); });
  const float foot =
      ImGui::GetTextLineHeightWithSpacing() * static_cast<float>(2 * problems + (browser.scans.empty() ? 0 : 1));
  const float spacing = ImGui::GetStyle().ItemSpacing.y;
  const float room =
      ImGui::GetContentRegionAvail().y - foot - static_cast<float>(headers) * (ImGui::GetFrameHeight() + 2 * spacing);
  const std::array<float, 3> heights = shareHeight(browser, room);
  drawSection(drawing, FileKind::model, "Models", heights[0]);
  drawSection(drawing, FileKind::environment, "Environments", heights[1]);
  drawSection(drawing, FileKind::brdf, "Measured BRDFs", heights[2]);
  drawFoot(browser);
}

bool pressed(ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); }

// Arrows and Enter, while the search or the list has the keyboard.
void takeKeys(Drawing& drawing) {
  Browser& browser = drawing.browser;
  browser.showCursor = false;
  if (drawing.rows.empty() || !ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) return;
  const auto at = std::ranges::find(drawing.rows, browser.cursor, [](const Entry* entry) { return entry->source; });
  const bool onRow = at != drawing.rows.end();
  const auto row = static_cast<int>(at - drawing.rows.begin()), last = static_cast<int>(drawing.rows.size()) - 1;
  const int step = pressed(ImGuiKey_DownArrow) - pressed(ImGuiKey_UpArrow);
  if (step != 0) {
    browser.cursor = drawing.rows[static_cast<size_t>(onRow ? std::clamp(row + step, 0, last) : 0)]->source;
    browser.showCursor = true;
  }
  if (pressed(ImGuiKey_Enter)) open(drawing, **(onRow ? at : drawing.rows.begin()));
}

void drawSearch(Browser& browser, ViewerState& state) {
  browser.focusing = std::max(0, browser.focusing - 1);
  if (state.searchAsked) ImGui::SetWindowFocus(), browser.focusing = 3;
  // ImGui finds a field only in a window that was there the frame before.
  if (state.searchAsked && !ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere(), state.searchAsked = false;
  ImGui::SetNextItemWidth(-1);
  ImGui::InputTextWithHint("##search", withKeys("search", state.keys, Command::search).c_str(), browser.query,
                           sizeof browser.query);
}

}  // namespace

void openBrowser(Browser& browser, const std::vector<std::string>& folders, DiskCache cache,
                 const std::function<void()>& wake) {
  browser.wake = wake;
  browser.builtin = builtinEntries();
  for (const std::string& path : readRecent(recentFile()))
    if (const Result<FileKind> kind = fileKind(path)) {
      Entry entry = fileEntry(*kind, path);
      entry.place = "recent, in " + entry.place;
      browser.recent.push_back(std::move(entry));
    }
  std::error_code problem;
  fs::path program = fs::read_symlink("/proc/self/exe", problem);
  browser.maker = std::make_unique<ThumbnailMaker>(std::move(program), std::move(cache), wake);
  for (const std::string& folder : folders) browseFolder(browser, folder);
  gatherEntries(browser);
}

void browseFolder(Browser& browser, const std::string& folder, const ScanLimits& limits) {
  if (browser.listings.size() + browser.scans.size() >= keptListings && !browser.listings.empty())
    browser.listings.erase(browser.listings.begin());
  browser.scans.push_back(
      std::async(std::launch::async, [folder, limits, stop = browser.stopScans.get_token(), wake = browser.wake] {
        FolderListing listing = scanFolder(folder, limits, stop);
        if (wake) wake();
        return listing;
      }));
}

void dropFolder(Browser& browser, const std::string& folder) {
  std::error_code ignored;
  fs::path path = fs::absolute(folder, ignored).lexically_normal();
  browser.dropped.push_back(path.has_filename() ? path : path.parent_path());  // as scanFolder has it
  browser.query[0] = '\0';
  browseFolder(browser, folder);
}

std::string takeDropped(Browser& browser, ViewerState& state) {
  if (!browser.found) return {};
  const FolderListing listing = *std::exchange(browser.found, {});
  const auto count = [&](FileKind kind) { return std::ranges::count(listing.entries, kind, &Entry::kind); };
  const auto words = [](ptrdiff_t n, const char* what) { return std::to_string(n) + " " + what + (n == 1 ? "" : "s"); };
  const ptrdiff_t models = count(FileKind::model), maps = count(FileKind::environment), brdfs = count(FileKind::brdf);
  if (listing.entries.empty()) {
    complain(state, {listing.folder.string(), "",
                     listing.problem.empty() ? "holds nothing that can be shown" : listing.problem,
                     "drop one with .gltf, .glb, .hdr, .exr, .binary or .bin files in it"});
    return {};
  }
  say(state, listing.folder.string() + ": " + words(models, "model") + ", " + words(maps, "environment") + ", " +
                 words(brdfs, "measured BRDF"));
  browser.cursor = listing.entries.front().source;
  browser.showCursor = true;
  const auto only = std::ranges::find(listing.entries, FileKind::model, &Entry::kind);
  return models == 1 ? only->source : std::string();
}

void noteOpened(Browser& browser, FileKind kind, const std::string& source) {
  std::error_code problem;
  const bool file = !source.starts_with("builtin:") && source != "none";
  const fs::path path = file ? fs::absolute(source, problem).lexically_normal() : fs::path(source);
  if (problem) return;
  if (kind == FileKind::model) browser.cursor = path.string(), browser.showCursor = true;
  if (!file) return;
  noteRecent(recentFile(), path.string());
  const auto listed = [&](const Entry& entry) { return entry.source == path; };
  if (std::ranges::any_of(browser.entries, listed)) return;
  browser.opened.insert(browser.opened.begin(), fileEntry(kind, path));
  browseFolder(browser, path.parent_path().string(), {.depth = 0});
  gatherEntries(browser);
}

void forgetThumbnail(Browser& browser, const std::string& source) {
  std::error_code ignored;
  browser.thumbnails.erase(fs::absolute(source, ignored).lexically_normal().string());
}

std::vector<Entry> databases(const Browser& browser) {
  std::vector<Entry> found;
  for (const int index : filtered(browser.entries, FileKind::brdf, ""))
    found.push_back(browser.entries[static_cast<size_t>(index)]);
  return found;
}

bool collect(Browser& browser) {
  const bool scanned = takeScans(browser);
  if (scanned) gatherEntries(browser);
  bool made = false;
  for (ThumbnailMade& thumbnail : browser.maker->take()) {
    if (browser.thumbnails.size() >= keptThumbnails) {
      browser.thumbnails.clear();
      browser.maker->forget();
    }
    Thumbnail& kept = browser.thumbnails[thumbnail.source];
    kept = {};
    if (thumbnail.pixels)
      kept.texture = uploadThumbnail(*thumbnail.pixels);
    else
      kept.problem = describe(thumbnail.pixels.error());
    made = true;
  }
  return scanned || made;
}

void drawBrowser(Browser& browser, ViewerState& state, PanelResult& result) {
  if (!state.panelVisible || !state.browserVisible) return browser.maker->want({});
  Drawing drawing{browser, state, result, {}};
  if (beginSide("browser", Side::left, state, result)) {
    drawSearch(browser, state);
    filter(browser);
    drawSections(drawing);
    takeKeys(drawing);
  }
  ImGui::End();
  browser.maker->want(state.loading.empty() ? drawing.wanted : std::vector<ThumbnailRequest>());  // one thing at a time
}

}  // namespace facet::view
