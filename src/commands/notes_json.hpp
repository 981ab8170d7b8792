#pragma once

#include <nlohmann/json_fwd.hpp>

#include "base/error.hpp"

namespace facet::commands {

// Notes as every command's machine-readable output has them.
nlohmann::ordered_json notesJson(const Notes& notes);

}  // namespace facet::commands
