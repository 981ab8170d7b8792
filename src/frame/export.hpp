#pragma once

// A model as an arrangement has it, as a file.

#include <cstdint>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"
#include "io/gltf.hpp"

namespace facet::frame {

// Binary glTF (io::editedGlb). Errors: also a node that is not there.
Result<std::vector<uint8_t>> exportGlb(const std::string& source, const Arrangement& arrangement, Notes& notes,
                                       const io::Limits& limits = {});

}  // namespace facet::frame
