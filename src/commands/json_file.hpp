#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

#include "base/error.hpp"

namespace facet::commands {

// Errors: no such file, no regular one, more than 64 MiB.
Result<std::string> readJsonText(const std::filesystem::path& file);

// Errors tell line and column; `name` leads them.
Result<nlohmann::json> parseJson(std::string_view text, const std::string& name);

}  // namespace facet::commands
