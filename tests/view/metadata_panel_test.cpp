#include "view/metadata_panel.hpp"

#include <catch2/catch.hpp>

#include "view/viewer_state.hpp"

using namespace facet;

TEST_CASE("Metadata shown: of the chosen node, its mesh and material, and of the file") {
  scene::Model model;
  model.nodes.resize(2);
  model.nodes[1].mesh = 0;
  model.meshes.resize(1);
  model.materials.resize(1);
  model.xmp = {.packets = {"{}", "{\"a\":1}"}, .references = {{"/nodes/1", 1}, {"/nodes/0", 0}}};
  view::ViewerState state;
  state.shown.content = std::make_shared<const scene::Model>(std::move(model));
  const auto placesShown = [&] {
    std::vector<std::string> places;
    for (const io::MetadataEntry& entry : view::metadataOf(state)) places.push_back(entry.place + " " + entry.kind);
    return places;
  };
  state.metadata.entries = std::vector<io::MetadataEntry>{{"/asset", "asset", "1"},        {"/nodes/0", "extras", "2"},
                                                          {"/nodes/1", "extras", "3"},     {"/meshes/0", "extras", "4"},
                                                          {"/materials/0", "extras", "5"}, {"", "extras", "6"}};
  using Places = std::vector<std::string>;
  CHECK(placesShown() == Places{"/asset asset", " extras"});
  state.selection = {.node = 1, .material = 0};
  CHECK(placesShown() == Places{"/nodes/1 extras", "/nodes/1 XMP", "/meshes/0 extras", "/materials/0 extras",
                                "/asset asset", " extras"});
  state.selection.node = 0;
  CHECK(placesShown().front() == "/nodes/0 extras");
}
