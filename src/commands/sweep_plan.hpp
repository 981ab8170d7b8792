#pragma once

// What `facet sweep` draws: {"models": [...], "environments": [...], "sizes": ["128x128"], "samples": [4, 16],
// "methods": [{"name": "tables", "visibility": "none"}, ...], "common": {...}, "reference": {"samples": 1024, ...},
// "seeds": 2, "repeat": 3}; a method, "common" and "reference" hold options of a picture by name. Whatever is left out
// is as sweepDefaults has it.

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "report/sweep.hpp"

namespace facet::commands {

// builtin:spheres under builtin:studio, 128 x 128, by tables, screen, rays and paths at 4, 16 and 64 samples, against
// 1024 samples of paths.
nlohmann::ordered_json sweepDefaults();

// "NAME:option=value,option=value" as an object of a plan's "methods".
Result<nlohmann::ordered_json> sweepMethod(const std::string& text);

// name leads the errors; relative paths are taken below `folder`.
Result<report::SweepPlan> parseSweepPlan(const nlohmann::ordered_json& document, const std::string& name,
                                         const std::string& folder);

}  // namespace facet::commands
