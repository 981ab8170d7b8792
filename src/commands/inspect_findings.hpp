#pragma once

// What validation finds, as inspect tells it.

#include <iosfwd>
#include <nlohmann/json_fwd.hpp>

#include "io/validate/findings.hpp"

namespace facet::commands {

// src/io/README.md and resources/schema/inspect.schema.json describe it.
nlohmann::ordered_json describeValidation(const io::validate::Report& report);

// Of each code the first few; all: every one.
void printValidation(const io::validate::Report& report, bool all, std::ostream& out);

}  // namespace facet::commands
