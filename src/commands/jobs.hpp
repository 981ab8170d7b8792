#pragma once

// A job file names many pictures: {"jobs": [JOB, ...]} or just [JOB, ...], where a JOB is an object of "model",
// "output", optionally "stats", and the options of a picture: {"model": "a.glb", "output": "a.png", "size": "640x480"}.
// Relative paths are taken below the job file's folder.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "commands/picture_arguments.hpp"
#include "frame/settings.hpp"
#include "io/picture_file.hpp"

namespace facet::commands {

struct Job {
  std::string model;                 // a path or "builtin:NAME"
  std::filesystem::path output;      // "-": standard output
  std::filesystem::path stats = {};  // .json; empty: none
  frame::PictureSettings settings = {};
  io::PictureFormat format = io::PictureFormat::png;  // of the output
};

// What the command line gives (overrides) wins over the file. Everything is checked before anything is rendered: no
// two jobs write the same file.
Result<std::vector<Job>> readJobs(const std::filesystem::path& file, const PictureArguments& overrides = {});

// The same from text; `name` leads the errors, `folder` is where relative paths start.
Result<std::vector<Job>> parseJobs(std::string_view text, const std::string& name, const std::filesystem::path& folder,
                                   const PictureArguments& overrides = {});

// "frame_%04d.png", 7 -> "frame_0007.png". Errors: not exactly one %d or %0Nd (N from 1 to 9); %% is a percent sign.
Result<std::string> numberedName(const std::string& pattern, int number);

// By the name's ending.
Result<io::PictureFormat> formatOfName(const std::filesystem::path& output);

}  // namespace facet::commands
