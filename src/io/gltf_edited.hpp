#pragma once

// A glTF file written anew, in one piece, with what was changed of it. All that is not changed stays as the file has
// it, extensions that nobody knows here among it.

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/gltf.hpp"
#include "scene/edit.hpp"

namespace facet::io {

struct Changes {
  scene::Edits edits;
  std::optional<glm::dmat4> worldFromModel;  // becomes a root above all others
  std::vector<int> only;                     // nodes: meshes of others, but for what is below them, are taken off
};

// Binary glTF, buffers and images within. source: a file or "builtin:NAME"; changesIn: of the model that it holds.
// notes: images that are not there keep their names. Errors: those of loadModel; an edit means nothing in the model;
// more than 4 GiB.
Result<std::vector<uint8_t>> editedGlb(const std::string& source,
                                       const std::function<Result<Changes>(const scene::Model&)>& changesIn,
                                       Notes& notes, const Limits& limits = {});

}  // namespace facet::io
