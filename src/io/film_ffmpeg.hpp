#pragma once

// Films that ffmpeg makes of pictures, a process of its own.

#include <filesystem>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "io/image.hpp"

namespace facet::io {

enum class FilmCodec { gif, h264, vp9 };

struct FilmShape {
  int width = 0, height = 0;  // pixels; even but for GIF
  double fps = 30;
  int quality = 90;  // 1 to 100
};

// It is started by begin(), so that a process may give up to start others afterwards, and writes beside the file, which
// has its name once it is whole: end(). Without end() there is no file.
class FfmpegFilm {
 public:
  // Errors: ffmpeg is not installed, or cannot be started; odd numbers of pixels.
  static Result<FfmpegFilm> begin(const std::filesystem::path& file, FilmCodec codec, const FilmShape& shape);
  FfmpegFilm(FfmpegFilm&& other) noexcept;
  FfmpegFilm& operator=(FfmpegFilm&&) = delete;
  ~FfmpegFilm();

  // 8-bit RGB of that size. Errors: what ffmpeg says.
  Result<void> add(const Pixels& pixels);
  // Waits for it. Errors: what ffmpeg says; the file cannot be written.
  Result<void> end();

 private:
  FfmpegFilm() = default;
  Error broken() const;

  std::filesystem::path file_, beside_, said_;
  int process_ = -1, pictures_ = -1;  // -1: none; the pipe's end that is written to
};

}  // namespace facet::io
