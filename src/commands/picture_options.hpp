#pragma once

// The one table of a picture's options. Command line, job files, help and the panel's "copy command" are derived from
// it.

#include <map>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "frame/settings.hpp"

namespace CLI {
class App;
}

namespace facet::commands {

struct PictureOption {
  std::string_view name;   // --NAME on the command line, "NAME" in a job
  std::string_view value;  // what help calls the value
  std::string_view help;
  // Text to settings. The error holds problem and remedy; who calls knows file and place.
  Result<void> (*parse)(std::string_view text, frame::PictureSettings& settings);
  // The text that parse makes the same setting of; empty where nothing is set.
  std::string (*write)(const frame::PictureSettings& settings);
  char separator = ',';                // between the numbers where a job gives an array
  bool isPath = false;                 // in a job relative to the job file's folder
  bool mayBeName = false;              // a path, but a plain word that is no file there is a name
  std::string (*choices)() = nullptr;  // the words that it takes, for its help
};

// In the order in which they are applied, whatever order they are given in: a substance comes before what differs from
// it.
std::span<const PictureOption> pictureOptions();

// An option's text in a job: paths are taken below `folder`. "builtin:..." and "none" are names; so is a plain word of
// an option that takes names, unless such a file exists there or its ending is that of a database.
std::string placedBelow(const std::string& folder, const PictureOption& option, const std::string& text);

// Names and texts of the options that were given.
using PictureArguments = std::map<std::string_view, std::string>;

// Registers the table's options, or only those of these names; parsing fills `arguments`, which must live as long as
// app.
void addPictureOptions(CLI::App& app, PictureArguments& arguments, std::span<const std::string_view> only = {});

// Sets what was given, leaves the rest. Errors name the option: "--samples: 0 is out of range; give ...".
Result<void> apply(const PictureArguments& arguments, frame::PictureSettings& settings);

// Sets what the object holds except the keys in `others`, which are the caller's. An option's value is its text, a
// number, or an array of numbers: "orbit": [25, 75, 0.4], "size": "640x480", "exposure": -1. Relative paths are taken
// below `folder`. `file` and `pointer` (of the object) lead the errors.
Result<void> apply(const nlohmann::json& object, std::span<const std::string_view> others, const std::string& folder,
                   const std::string& file, const std::string& pointer, frame::PictureSettings& settings);

// Options that exclude each other: camera against orbit and target.
Result<void> checkTogether(const frame::PictureSettings& settings);

// The shortest command that shows (`facet MODEL ...`) or, with an output, renders (`facet render MODEL -o OUTPUT ...`)
// the same picture, to the last bit; quoted for a POSIX shell.
std::string commandLine(const frame::PictureSettings& settings, const std::string& model,
                        const std::string& output = {});

}  // namespace facet::commands
