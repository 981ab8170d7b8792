#pragma once

// Many pictures of one wish: files with numbers, or one that moves.

#include <CLI/CLI.hpp>
#include <string>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "commands/jobs.hpp"
#include "commands/picture_output.hpp"
#include "io/film_ffmpeg.hpp"
#include "io/film_webp.hpp"

namespace facet::commands {

struct FilmOptions {
  int frames = 0;  // 0: one picture
  double fps = 30;
  bool turntable = false;
  std::string cameraPath;  // a file; empty: none
};
void addFilmOptions(CLI::App& app, FilmOptions& options);

// One that moves: several pictures and no place for a number in its name.
bool isFilm(const std::filesystem::path& output, const FilmOptions& options);
// .gif, .mp4, .webm: no single picture is one.
bool isFilmName(const std::filesystem::path& output);

// Frame by frame from --time on, each with its own output but where it is a film; statistics are the last one's, with
// all frames' times. Errors: nothing would move; what excludes each other.
Result<std::vector<Job>> listFrames(const Job& first, const FilmOptions& options);

// One file that is there once it is whole.
class Film {
 public:
  // Before the process is confined: another program may make it.
  static Result<Film> begin(const Job& first, const FilmOptions& options, const OutputOptions& output);
  Result<void> add(const io::Pixels& pixels);
  Result<void> end();

 private:
  using Maker = std::variant<io::WebpFilm, io::FfmpegFilm>;
  Film(std::filesystem::path file, Maker maker, double fps)
      : file_(std::move(file)), maker_(std::move(maker)), fps_(fps) {}
  int milliseconds() const;  // when the next picture begins

  std::filesystem::path file_;
  Maker maker_;
  double fps_;
  int pictures_ = 0;
};

}  // namespace facet::commands
