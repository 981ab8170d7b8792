#pragma once

// What `facet render` writes a picture into: the format, its quality, further layers.

#include <CLI/CLI.hpp>
#include <string>

#include "base/error.hpp"
#include "commands/jobs.hpp"
#include "frame/session.hpp"
#include "io/picture_file.hpp"

namespace facet::commands {

struct OutputOptions {
  std::string format;  // a word for -o -; empty: by the name's ending
  int quality = 90;    // io::encodePicture
  int bits = 8;        // a channel of what is shown: 8, 16
  bool errorLayer = false;
  std::string layers;  // channels, by commas
};
void addFileOptions(CLI::App& app, OutputOptions& options);  // format and quality alone
void addOutputOptions(CLI::App& app, OutputOptions& options);

// "-" is standard output: PNG, unless it is said.
Result<io::PictureFormat> outputFormat(const std::filesystem::path& output, const OutputOptions& options);
// Whether the job's format holds what the options ask for, at its size.
Result<void> checkOutput(const Job& job, const OutputOptions& options);

frame::PictureRequest pictureRequest(const Job& job, const OutputOptions& options, int repeat, bool last);

// The same for the same picture: without a date, and wherever it is written to.
Origin pictureOrigin(const Job& job, const frame::Session& session, const OutputOptions& options = {});

// The picture, with the layers that are asked for: those are drawn for it. Errors: it cannot be written; the driver's.
Result<void> writeOutput(const Job& job, const OutputOptions& options, frame::Session& session,
                         const frame::Picture& picture);

}  // namespace facet::commands
