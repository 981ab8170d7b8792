#pragma once

// Options of a picture in a text file: "option = value" line by line, "#" before remarks. Lines below "[PATTERN]" are
// for models whose file name that fits ("*" anything, "?" any letter; capitals or not).

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "commands/picture_arguments.hpp"

namespace facet::commands {

// What the lines say for this model joins what was given, which goes before: it stays, and what excludes it is left
// out. A later line takes the place of an earlier one. Relative paths are taken below the file's folder. Errors name
// file and line.
Result<void> applyConfig(const std::filesystem::path& file, const std::string& model, PictureArguments& given);
// The same from text; folder: where relative paths start.
Result<void> applyConfigText(std::string_view text, const std::string& name, const std::string& folder,
                             const std::string& model, PictureArguments& given);

// --config FILE; usual: what is read where it is not given, for the help.
void addConfig(CLI::App& app, std::string& file, const std::string& usual);

// $XDG_CONFIG_HOME/facet/config, else below ~/.config; empty: neither is known, or there is no such file.
std::filesystem::path usualConfig();

}  // namespace facet::commands
