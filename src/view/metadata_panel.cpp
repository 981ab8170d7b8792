#include "view/metadata_panel.hpp"

#include <algorithm>
#include <new>

#include "base/log.hpp"
#include "view/loader.hpp"
#include "view/text_fit.hpp"
#include "view/viewer_state.hpp"
#include "view/widgets.hpp"

namespace facet::view {

void followMetadata(ViewerState& state, Loader& loader) {
  ShownMetadata& shown = state.metadata;
  if (shown.of != state.shown.content) shown = {.wanted = shown.wanted};
  if (!shown.wanted || shown.of || !state.shown.content) return;
  shown.of = state.shown.content;
  loader.metadata.start([of = shown.of, source = state.shown.model, outside = loader.allowOutside]() -> MetadataRead {
    try {
      return {of, io::readMetadata(source, {.allowOutside = outside})};
    } catch (const std::bad_alloc&) {
      return {of, fail(source, "", "there is not enough memory to read what it says", "use a smaller model")};
    }
  });
}

void takeMetadata(ViewerState& state, MetadataRead read) {
  if (read.of != state.metadata.of) return;
  if (read.entries) log::debug("metadata: " + std::to_string(read.entries->size()) + " of " + state.shown.model);
  state.metadata.entries = std::move(read.entries);
}

std::vector<io::MetadataEntry> metadataOf(const ViewerState& state) {
  std::vector<std::string> places;
  const scene::Model& model = *state.shown.content;
  const auto add = [&](const char* section, int index) {
    if (index >= 0) places.push_back("/" + std::string(section) + "/" + std::to_string(index));
  };
  if (const int node = state.selection.node; node >= 0) {
    add("nodes", node);
    const scene::Node& its = model.nodes[static_cast<size_t>(node)];
    add("meshes", its.mesh), add("skins", its.skin), add("cameras", its.camera);
  }
  add("materials", state.inspection.on ? state.inspection.material : state.selection.material);
  places.insert(places.end(), {"/scenes/" + std::to_string(state.shown.scene), "/asset", ""});
  std::vector<io::MetadataEntry> out;
  for (const std::string& place : places) {
    if (state.metadata.entries && *state.metadata.entries)
      std::ranges::copy_if(**state.metadata.entries, std::back_inserter(out),
                           [&](const io::MetadataEntry& entry) { return entry.place == place; });
    for (const scene::Metadata::Reference& reference : model.xmp.references)
      if (reference.object == place)
        out.push_back({place, "XMP", model.xmp.packets[static_cast<size_t>(reference.packet)]});
  }
  return out;
}

void metadataSection(ViewerState& state) {
  ShownMetadata& shown = state.metadata;
  shown.wanted = section(state.layout, "Metadata", false);
  if (!shown.wanted || !state.shown.content) return;
  if (!shown.entries) return ImGui::TextDisabled("the file is being read");
  if (!*shown.entries) return wrappedText(describe(shown.entries->error()));
  const std::vector<io::MetadataEntry> entries = metadataOf(state);
  if (entries.empty()) ImGui::TextDisabled("the file says nothing of it");
  for (size_t i = 0; i < entries.size(); ++i) {
    ImGui::PushID(static_cast<int>(i));
    const std::string title = (entries[i].place.empty() ? "the file" : entries[i].place) + ": " + entries[i].kind;
    if (ImGui::Selectable(middleCut(title, ImGui::GetContentRegionAvail().x, textWidth).c_str()))
      ImGui::SetClipboardText(entries[i].text.c_str());
    hint(title + "\na click copies the text");
    ImGui::TextWrapped("%s", entries[i].text.c_str());
    ImGui::PopID();
  }
}

}  // namespace facet::view
