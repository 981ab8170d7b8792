#pragma once

// What the file says beside its picture: asset, extras, XMP. Read beside the window, and only once it is looked at.

#include <memory>
#include <optional>
#include <vector>

#include "io/metadata.hpp"
#include "scene/model.hpp"

namespace facet::view {

struct Loader;
struct ViewerState;

struct MetadataRead {
  std::shared_ptr<const scene::Model> of;
  Result<std::vector<io::MetadataEntry>> entries;
};

struct ShownMetadata {
  bool wanted = false;                                                 // its section is open
  std::shared_ptr<const scene::Model> of = {};                         // which model's is there or being read
  std::optional<Result<std::vector<io::MetadataEntry>>> entries = {};  // nothing: not yet
};

// Starts what is wanted and not there: after another model or a change of the file, too.
void followMetadata(ViewerState& state, Loader& loader);
void takeMetadata(ViewerState& state, MetadataRead read);

// Of what is chosen: node, its mesh, material; and of the file.
std::vector<io::MetadataEntry> metadataOf(const ViewerState& state);

// The section of the scene's panel.
void metadataSection(ViewerState& state);

}  // namespace facet::view
