#include "frame/export.hpp"

#include "frame/choose.hpp"
#include "frame/settings.hpp"
#include "io/gltf_edited.hpp"

namespace facet::frame {

Result<std::vector<uint8_t>> exportGlb(const std::string& source, const Arrangement& arrangement, Notes& notes,
                                       const io::Limits& limits) {
  const auto changesIn = [&](const scene::Model& model) -> Result<io::Changes> {
    io::Changes changes{arrangement.edits, {}, {}};
    Result<std::vector<int>> only = chooseNodes(arrangement.only, model);
    if (!only) return tl::unexpected(only.error());
    changes.only = std::move(*only);
    if (const glm::dmat4 world = worldFromModel(arrangement); world != glm::dmat4(1)) changes.worldFromModel = world;
    return changes;
  };
  return io::editedGlb(source, changesIn, notes, limits);
}

}  // namespace facet::frame
