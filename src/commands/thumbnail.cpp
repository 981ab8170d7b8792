#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "base/log.hpp"
#include "commands/commands.hpp"
#include "commands/confine.hpp"
#include "frame/session.hpp"
#include "frame/settings.hpp"
#include "io/image.hpp"
#include "io/sources.hpp"
#include "options/picture_options.hpp"
#include "view/thumbnails.hpp"

namespace facet::commands {

namespace {

struct ThumbnailArguments {
  std::string model, output;
  int side = 256;  // pixels
};

// A file manager asks for pictures of whatever it finds, and shows nothing before they are there.
constexpr unsigned timeLimit = 30;               // seconds
constexpr rlim_t memoryLimit = rlim_t{3} << 30;  // bytes of its own, not what a driver maps

void endLate(int) {
  constexpr std::string_view said = "facet: error: a thumbnail took more than 30 s.\n";
  static_assert(timeLimit == 30);
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, said.data(), said.size());
  _exit(exitBadInput);
}

void limitOneself() {
  struct sigaction action {};
  action.sa_handler = endLate;
  sigaction(SIGALRM, &action, nullptr);
  alarm(timeLimit);
  rlimit data{};
  if (getrlimit(RLIMIT_DATA, &data) == 0 && data.rlim_cur > memoryLimit) {
    data.rlim_cur = memoryLimit;
    setrlimit(RLIMIT_DATA, &data);
  }
  setpriority(PRIO_PROCESS, 0, 10);  // it may already be lower; then it stays
}

Result<io::Pixels> drawThumbnail(const ThumbnailArguments& arguments, frame::Session& session) {
  const bool builtin = arguments.model.starts_with(io::builtinPrefix);
  view::ThumbnailRequest request{view::FileKind::model, arguments.model};
  if (!builtin) {
    const Result<view::FileKind> kind = view::fileKind(arguments.model);
    if (!kind) return tl::unexpected(kind.error());
    if (*kind == view::FileKind::folder) return fail(arguments.model, "", "is a folder", "name a file");
    std::error_code none;
    if (const uintmax_t bytes = std::filesystem::file_size(arguments.model, none);
        !none && bytes > view::largestPreviewed)
      return fail(arguments.model, "", "is too large for a thumbnail");
    request.kind = *kind;
  }
  Notes notes;
  Stages stages;
  Result<frame::Picture> picture =
      session.render(view::thumbnailModel(request), view::thumbnailSettings(request, arguments.side),
                     {.display = true, .last = true}, notes, stages);
  if (!picture) return tl::unexpected(picture.error());
  return std::move(picture->display);
}

int runThumbnail(const ThumbnailArguments& arguments) {
  limitOneself();
  keepDriverCacheApart();
  Result<std::unique_ptr<frame::Session>> session = frame::Session::create({});
  if (!session) {
    log::error(describe(session.error()));
    return exitNoOpenGL;
  }
  Needed needed;
  needPicture(needed, arguments.model, {});
  needOutput(needed, arguments.output);
  confine(std::move(needed), true);
  const Result<io::Pixels> pixels = drawThumbnail(arguments, **session);
  if (!pixels) return badInput(pixels.error());
  const Result<void> written = io::writePng(arguments.output, *pixels);
  return written ? exitGood : badInput(written.error());
}

}  // namespace

std::function<int()> addThumbnail(CLI::App& app) {
  const auto arguments = std::make_shared<ThumbnailArguments>();
  app.add_option("MODEL", arguments->model, "a .gltf or .glb file, or builtin:NAME; also an environment or a BRDF")
      ->type_name("MODEL")
      ->required();
  app.add_option("OUT", arguments->output, "the picture, a PNG whatever it is called")
      ->type_name("OUT.png")
      ->required();
  app.add_option("--size", arguments->side, "pixels of its sides (256)")->type_name("N")->check(CLI::Range(16, 1024));
  return [arguments] { return runThumbnail(*arguments); };
}

}  // namespace facet::commands
