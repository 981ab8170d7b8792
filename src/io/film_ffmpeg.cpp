#include "io/film_ffmpeg.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <utility>

#include "base/child_program.hpp"
#include "base/text.hpp"

namespace facet::io {

namespace {

namespace fs = std::filesystem;

// Rec. 709 from the picture to the film's luma, and said so: players otherwise guess by the size.
constexpr const char* rec709 =
    "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p,setparams=colorspace=bt709:color_primaries=bt709:"
    "color_trc=bt709";
// The colours that all pictures need most, and no dither that crawls.
constexpr const char* ownPalette = "split[a][b];[a]palettegen[p];[b][p]paletteuse=dither=bayer:bayer_scale=4";

std::vector<std::string> codecWords(FilmCodec codec, int quality) {
  // Constant rate factors: 51 (H.264) and 63 (VP9) are the worst, and 10 is beyond what one sees.
  const auto factor = [&](int worst) { return std::to_string(10 + (worst - 10) * (100 - quality) / 100); };
  switch (codec) {
    case FilmCodec::gif:
      return {"-filter_complex", ownPalette, "-f", "gif"};
    case FilmCodec::h264:
      return {"-vf", rec709, "-c:v", "libx264", "-crf", factor(51), "-movflags", "+faststart", "-f", "mp4"};
    case FilmCodec::vp9:
      return {"-vf", rec709, "-c:v", "libvpx-vp9", "-crf", factor(63), "-b:v", "0", "-row-mt", "1", "-f", "webm"};
  }
  return {};
}

std::vector<std::string> ffmpegWords(FilmCodec codec, const FilmShape& shape, const std::string& into) {
  std::vector<std::string> words = {
      "ffmpeg",     "-nostdin",        "-hide_banner",
      "-loglevel",  "error",           "-y",
      "-f",         "rawvideo",        "-pix_fmt",
      "rgb24",      "-video_size",     std::to_string(shape.width) + "x" + std::to_string(shape.height),
      "-framerate", number(shape.fps), "-i",
      "pipe:0"};
  for (std::string& word : codecWords(codec, shape.quality)) words.push_back(std::move(word));
  words.push_back("file:" + into);
  return words;
}

// A program that has gone must not end this one.
class NoBrokenPipe {
 public:
  NoBrokenPipe() : before_(::signal(SIGPIPE, SIG_IGN)) {}
  ~NoBrokenPipe() { ::signal(SIGPIPE, before_); }
  NoBrokenPipe(const NoBrokenPipe&) = delete;
  NoBrokenPipe& operator=(const NoBrokenPipe&) = delete;

 private:
  sighandler_t before_;
};

bool writeAllTo(int fd, std::span<const uint8_t> bytes) {
  const NoBrokenPipe held;
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return false;
    bytes = bytes.subspan(static_cast<size_t>(n));
  }
  return true;
}

}  // namespace

Result<FfmpegFilm> FfmpegFilm::begin(const fs::path& file, FilmCodec codec, const FilmShape& shape) {
  if (codec != FilmCodec::gif && (shape.width % 2 != 0 || shape.height % 2 != 0))
    return fail(file.string(), "",
                "a film has even numbers of pixels along its sides, not " + std::to_string(shape.width) + " x " +
                    std::to_string(shape.height),
                "choose another size");
  FfmpegFilm film;
  const std::string name = ".facet." + std::to_string(::getpid()) + ".film";
  film.file_ = file;
  film.beside_ = file.parent_path() / (name + ".part"), film.said_ = file.parent_path() / (name + ".said.part");
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC) != 0)
    return fail(file.string(), "", std::string("no pipe: ") + std::strerror(errno), "try again");
  film.pictures_ = ends[1];
  const int process =
      startProgram(ffmpegWords(codec, shape, film.beside_.string()), {.input = ends[0], .errors = film.said_.string()});
  ::close(ends[0]);
  if (process < 0)
    return fail(file.string(), "",
                process == -ENOENT ? "films are made by ffmpeg, which is not installed, or its folder is not there"
                                   : std::string("ffmpeg cannot be started: ") + std::strerror(-process),
                "install ffmpeg, or name the film .webp");
  film.process_ = process;
  return film;
}

FfmpegFilm::FfmpegFilm(FfmpegFilm&& other) noexcept
    : file_(std::move(other.file_)),
      beside_(std::move(other.beside_)),
      said_(std::move(other.said_)),
      process_(std::exchange(other.process_, -1)),
      pictures_(std::exchange(other.pictures_, -1)) {}

FfmpegFilm::~FfmpegFilm() {
  if (pictures_ >= 0) ::close(pictures_);
  if (process_ > 0) waitForProgram(process_);
  std::error_code ignored;
  for (const fs::path& left : {beside_, said_})
    if (!left.empty()) fs::remove(left, ignored);
}

Error FfmpegFilm::broken() const {
  std::ifstream stream(said_);
  std::string line;
  std::getline(stream, line);
  return {file_.string(), "",
          "ffmpeg gave up: " + (line.empty() ? std::string("it said nothing") : printable(line, 200)),
          "see whether it has the codec (ffmpeg -codecs), and the space left"};
}

Result<void> FfmpegFilm::add(const Pixels& pixels) {
  if (writeAllTo(pictures_, pixels.data)) return {};
  ::close(std::exchange(pictures_, -1));
  waitForProgram(std::exchange(process_, -1));
  return tl::unexpected(broken());
}

Result<void> FfmpegFilm::end() {
  ::close(std::exchange(pictures_, -1));
  if (waitForProgram(std::exchange(process_, -1)) != 0) return tl::unexpected(broken());
  const int fd = ::open(beside_.c_str(), O_RDONLY | O_CLOEXEC);
  int problem = fd < 0 ? errno : 0;
  if (fd >= 0 && ::fsync(fd) != 0 && errno != EINVAL) problem = errno;
  if (fd >= 0) ::close(fd);
  if (problem == 0 && ::rename(beside_.c_str(), file_.c_str()) != 0) problem = errno;
  if (problem == 0) return {};
  return fail(file_.string(), "", std::string("cannot be written: ") + std::strerror(problem),
              "check the folder, its permissions and the space left");
}

}  // namespace facet::io
