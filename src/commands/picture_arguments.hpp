#pragma once

// A picture's options (options/picture_options.hpp) on the command line and in a job.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "options/picture_options.hpp"

namespace CLI {
class App;
}

namespace facet::commands {

using options::PictureArguments;

// Registers the table's options, or only those of these names; parsing fills `arguments`, which must live as long as
// app.
void addPictureOptions(CLI::App& app, PictureArguments& arguments, std::span<const std::string_view> only = {});

// Sets what the object holds except the keys in `others`, which are the caller's. An option's value is its text, a
// number, or an array of numbers: "orbit": [25, 75, 0.4], "size": "640x480", "exposure": -1. Relative paths are taken
// below `folder`. `file` and `pointer` (of the object) lead the errors.
Result<void> applyObject(const nlohmann::json& object, std::span<const std::string_view> others,
                         const std::string& folder, const std::string& file, const std::string& pointer,
                         frame::PictureSettings& settings);

}  // namespace facet::commands
