#pragma once

// The one table of a picture's options. Command line, job files, help, the names of options in messages and the panel's
// "copy command" are derived from it.

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::options {

struct PictureOption {
  std::string_view name;   // --NAME on the command line, "NAME" in a job
  std::string_view value;  // what help calls the value
  std::string_view help;
  // Text to settings. The error holds problem and remedy; who calls knows file and place.
  Result<void> (*parse)(std::string_view text, frame::PictureSettings& settings);
  // The text that parse makes the same setting of; empty where nothing is set.
  std::string (*write)(const frame::PictureSettings& settings);
  char separator = ',';                           // between the numbers where a job gives an array
  bool isPath = false;                            // in a job relative to the job file's folder
  bool mayBeName = false;                         // a path, but a plain word that is no file there is a name
  std::string (*choices)() = nullptr;             // the words that it takes, for its help
  bool repeated = false;                          // may be given several times: `separator` between
  bool flag = false;                              // on where it is named; in a job true or false
  std::vector<std::string> (*names)() = nullptr;  // the names that it takes, where its help does not list them
};

// In the order in which they are applied, whatever order they are given in: a substance comes before what differs from
// it.
std::span<const PictureOption> pictureOptions();
// Null where there is none of that name.
const PictureOption* findOption(std::string_view name);
std::vector<std::string_view> optionNames();

// Its help, with the words that it takes and in brackets what is chosen where it is not given.
std::string helpOf(const PictureOption& option);

// The words that it takes besides what `value` spells out; for whoever completes what is typed.
std::vector<std::string> wordsFor(const PictureOption& option);

// An option's text in a job: paths are taken below `folder`. "builtin:..." and "none" are names; so is a plain word of
// an option that takes names, unless such a file exists there or its ending is that of a database.
std::string placedBelow(const std::string& folder, const PictureOption& option, const std::string& text);

// Names and texts of the options that were given.
using PictureArguments = std::map<std::string_view, std::string>;

// Sets what was given, leaves the rest. Errors name the option: "--samples: 0 is out of range; give ...".
Result<void> apply(const PictureArguments& arguments, frame::PictureSettings& settings);

// facet::describe with the options that set what it is about: "...; choose none (--variant)."
std::string describe(const Error& error);
std::string describe(const std::string& source, const Note& note);

// Options that exclude each other, such as camera and orbit, and those that need another.
Result<void> checkTogether(const frame::PictureSettings& settings);

// The shortest command that shows (`facet MODEL ...`) or, with an output, renders (`facet render MODEL -o OUTPUT ...`)
// the same picture, to the last bit: its words, without the program's name, and the line, quoted for a POSIX shell.
std::vector<std::string> commandWords(const frame::PictureSettings& settings, const std::string& model,
                                      const std::string& output = {});
std::string commandLine(const frame::PictureSettings& settings, const std::string& model,
                        const std::string& output = {});

}  // namespace facet::options
