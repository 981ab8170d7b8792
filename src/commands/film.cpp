#include "commands/film.hpp"

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "base/file_ending.hpp"
#include "base/text.hpp"
#include "base/whole_file.hpp"
#include "commands/json_file.hpp"
#include "commands/number_check.hpp"
#include "frame/choose.hpp"
#include "options/camera_path.hpp"

namespace facet::commands {

namespace {

// Far beyond what anybody renders; a typing error otherwise fills the disk.
constexpr int maxFrames = 100'000;
constexpr double fastestFilm = 240;  // pictures a second that players show

struct FilmFormat {
  std::string_view ending;
  std::optional<io::FilmCodec> codec;  // none: facet makes it itself
};
constexpr std::array<FilmFormat, 4> filmFormats = {{{".webp", std::nullopt},
                                                    {".gif", io::FilmCodec::gif},
                                                    {".mp4", io::FilmCodec::h264},
                                                    {".webm", io::FilmCodec::vp9}}};

const FilmFormat* formatOf(const std::filesystem::path& output) {
  const std::string ending = fileEnding(output);
  for (const FilmFormat& format : filmFormats)
    if (format.ending == ending) return &format;
  return nullptr;
}

Result<std::vector<frame::Viewpoint>> cameraPath(const std::string& file) {
  const Result<std::string> text = readJsonText(file);
  return text ? options::parseCameraPath(*text, file) : tl::unexpected(text.error());
}

Result<void> checkMoves(const Job& first, const FilmOptions& options) {
  if (options.turntable && !options.cameraPath.empty())
    return fail({}, "--turntable", "does not go with --camera-path", "give one of them");
  const char* turning = options.turntable ? "--turntable" : options.cameraPath.empty() ? nullptr : "--camera-path";
  if (turning && !first.settings.viewpoint.camera.empty())
    return fail({}, turning, "moves the camera, and --camera is the file's", "leave one of them out");
  if (!turning && first.settings.placement.animation.empty())
    return fail({}, "--frames", "nothing moves without an animation",
                "give --animation NAME or all, --turntable or --camera-path FILE");
  return {};
}

// A full turn, whose end is its beginning.
void turn(Job& job, double share) {
  frame::Viewpoint& viewpoint = job.settings.viewpoint;
  if (!viewpoint.orbit) {
    const scene::OrbitCamera usual = frame::chooseOrbit(viewpoint, 1, job.model, {});
    viewpoint.orbit = {.thetaDeg = usual.theta, .phiDeg = usual.phi, .radius = {}};
  }
  viewpoint.orbit->thetaDeg += 360 * share;
}

}  // namespace

void addFilmOptions(CLI::App& app, FilmOptions& options) {
  app.add_option("--frames", options.frames,
                 "as many pictures of what moves, from --time on: -o frame_%04d.png, or one film: .webp, and by ffmpeg "
                 ".gif, .mp4, .webm")
      ->type_name("N")
      ->check(CLI::Range(1, maxFrames));
  app.add_option("--fps", options.fps, "frames per second (30)")
      ->type_name("F")
      ->check(numberIn(1e-3, 1e6), "FLOAT in [0.001 - 1e+06]");
  app.add_flag("--turntable", options.turntable, "with --frames: the camera goes once around the model");
  app.add_option("--camera-path", options.cameraPath,
                 "with --frames: the camera goes by those that the file names, one a line, as the window copies them")
      ->type_name("FILE");
}

bool isFilmName(const std::filesystem::path& output) {
  const FilmFormat* format = formatOf(output);
  return format && format->codec;
}

bool isFilm(const std::filesystem::path& output, const FilmOptions& options) {
  return options.frames > 0 && formatOf(output) && output.string().find('%') == std::string::npos;
}

Result<std::vector<Job>> listFrames(const Job& first, const FilmOptions& options) {
  if (Result<void> r = checkMoves(first, options); !r) return tl::unexpected(r.error());
  std::vector<frame::Viewpoint> path;
  if (!options.cameraPath.empty()) {
    auto read = cameraPath(options.cameraPath);
    if (!read) return tl::unexpected(read.error());
    path = std::move(*read);
  }
  const bool film = isFilm(first.output, options), animated = !first.settings.placement.animation.empty();
  std::vector<Job> jobs;
  for (int i = 0; i < options.frames; ++i) {
    Job job = first;
    if (i + 1 < options.frames) job.stats.clear();
    if (!film) {
      const Result<std::string> output = numberedName(first.output.string(), i);
      if (!output) return tl::unexpected(output.error());
      job.output = *output;
    }
    if (options.turntable) turn(job, static_cast<double>(i) / options.frames);
    if (!path.empty())
      job.settings.viewpoint =
          options::alongPath(path, options.frames > 1 ? static_cast<double>(i) / (options.frames - 1) : 0);
    if (animated) job.settings.placement.timeSeconds += i / options.fps;
    if (job.settings.placement.timeSeconds > 1e6)
      return fail({}, "--frames", "picture " + std::to_string(i) + " would be of a time beyond a million seconds",
                  "take fewer, or more a second (--fps)");
    jobs.push_back(std::move(job));
  }
  return jobs;
}

Result<Film> Film::begin(const Job& first, const FilmOptions& options, const OutputOptions& output) {
  const frame::FrameSettings& frame = first.settings.frame;
  const std::string name = first.output.string();
  const FilmFormat& format = *formatOf(first.output);
  if (options.fps > fastestFilm)
    return fail(name, "--fps", "no player shows " + number(options.fps) + " pictures a second",
                "give " + number(fastestFilm) + " at most");
  if (output.bits == 16) return fail(name, "--bits", "a film has 8 bits a channel", "leave it out");
  if (!format.codec)
    return io::WebpFilm::begin(frame.width, frame.height, output.quality).map([&](io::WebpFilm film) {
      return Film(first.output, std::move(film), options.fps);
    });
  if (frame.background == frame::Background::transparent)
    return fail(name, "--background", "this film has no transparency", "name it .webp, or give a colour");
  return io::FfmpegFilm::begin(first.output, *format.codec, {frame.width, frame.height, options.fps, output.quality})
      .map([&](io::FfmpegFilm film) { return Film(first.output, std::move(film), options.fps); });
}

int Film::milliseconds() const { return static_cast<int>(std::lround(1000 * pictures_ / fps_)); }

Result<void> Film::add(const io::Pixels& pixels) {
  const int from = milliseconds();
  ++pictures_;
  if (auto* own = std::get_if<io::WebpFilm>(&maker_)) return own->add(pixels, from);
  return std::get<io::FfmpegFilm>(maker_).add(pixels);
}

Result<void> Film::end() {
  if (auto* other = std::get_if<io::FfmpegFilm>(&maker_)) return other->end();
  const Result<std::vector<uint8_t>> bytes = std::get<io::WebpFilm>(maker_).end(milliseconds());
  return bytes ? writeWholeFile(file_, std::as_bytes(std::span(*bytes))) : tl::unexpected(bytes.error());
}

}  // namespace facet::commands
