#include "view/thumbnails.hpp"

#include <fcntl.h>
#include <signal.h>
#include <spawn.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <fstream>
#include <sstream>

#include "frame/settings.hpp"
#include "options/picture_options.hpp"
#include "view/file_watch.hpp"

namespace facet::view {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

namespace {

constexpr auto timeLimit = 60s;

bool isBuiltin(const std::string& source) { return source.starts_with("builtin:") || source == "none"; }

// Owns what posix_spawn wants to be told.
struct SpawnActions {
  posix_spawn_file_actions_t actions{};
  explicit SpawnActions(const std::string& output) {
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 2, output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  }
  ~SpawnActions() { posix_spawn_file_actions_destroy(&actions); }
  SpawnActions(const SpawnActions&) = delete;
  SpawnActions& operator=(const SpawnActions&) = delete;
};

struct TemporaryFolder {
  fs::path path;  // empty: none could be made
  TemporaryFolder() {
    std::error_code problem;
    std::string pattern = (fs::temp_directory_path(problem) / "facet-XXXXXX").string();
    if (mkdtemp(pattern.data())) path = pattern;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    if (!path.empty()) fs::remove_all(path, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

// Its exit status; what it says goes to the file. Errors: it cannot be started, takes too long, or is stopped.
Result<int> runQuietly(const std::vector<std::string>& command, const fs::path& said, const std::stop_token& stop) {
  std::vector<char*> arguments;
  for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
  arguments.push_back(nullptr);
  const SpawnActions actions(said.string());
  pid_t child = 0;
  if (const int problem = posix_spawn(&child, arguments[0], &actions.actions, nullptr, arguments.data(), environ))
    return fail(command[0], "", std::strerror(problem));
  setpriority(PRIO_PROCESS, static_cast<id_t>(child), 19);
  const auto end = std::chrono::steady_clock::now() + timeLimit;
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (!stop.stop_requested() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(10ms);
      continue;
    }
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
    return fail("", "", "a preview took more than " + std::to_string(timeLimit.count()) + " s");
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

// The sentence of the first error that the program told.
std::string toldError(const fs::path& said) {
  std::ifstream in(said);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("facet: error: ")) return line.substr(14);
  return "no preview could be made";
}

std::vector<std::byte> fileBytes(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  const std::string text = bytes.str();
  const auto view = std::as_bytes(std::span(text));
  return {view.begin(), view.end()};
}

Result<io::Pixels> decoded(std::span<const std::byte> png, const std::string& name) {
  return io::decodeImage({reinterpret_cast<const uint8_t*>(png.data()), png.size()}, name);
}

}  // namespace

std::string thumbnailKey(const ThumbnailRequest& request) {
  std::string key = "thumbnail 1\n" + request.source + "\n";
  if (isBuiltin(request.source)) return key + buildId();
  const FileStamp stamp = fileStamp(request.source);
  return key + std::to_string(stamp.time.time_since_epoch().count()) + "\n" + std::to_string(stamp.bytes);
}

std::string thumbnailModel(const ThumbnailRequest& request) {
  return request.kind == FileKind::model ? request.source : "builtin:furnace";
}

frame::PictureSettings thumbnailSettings(const ThumbnailRequest& request, int side) {
  frame::PictureSettings s;
  s.frame.width = s.frame.height = side;
  s.quality.visibility = frame::Visibility::none;  // what appears soon
  if (request.kind == FileKind::environment) {     // on the smooth metal sphere, no other
    s.sources.environment = request.source;
    s.look.lights = frame::Lights::none;
    s.viewpoint = {.camera = {}, .orbit = frame::Orbit{0, 90, 2.2}, .target = glm::dvec3(-5, 0.5, 0), .fovYDeg = 27};
    return s;
  }
  s.frame.background = frame::Background::transparent;
  if (request.kind == FileKind::brdf) {  // one sphere
    s.sources.brdf = request.source;
    s.sources.environment = "builtin:studio";
    s.look.lights = frame::Lights::none;
    s.viewpoint = {.camera = {}, .orbit = frame::Orbit{0, 90, 3}, .target = glm::dvec3(-5, 0.5, 0), .fovYDeg = 19};
    return s;
  }
  if (!isBuiltin(request.source)) s.sources.environment = "builtin:studio";
  return s;
}

std::vector<std::string> thumbnailArguments(const ThumbnailRequest& request, const fs::path& png) {
  return options::commandWords(thumbnailSettings(request), thumbnailModel(request), png.string());
}

DiskCache thumbnailCache() {
  const fs::path folder = userCacheFolder();
  return {folder.empty() ? folder : folder / "thumbnails", uintmax_t{64} << 20};
}

ThumbnailMaker::ThumbnailMaker(fs::path program, DiskCache cache, std::function<void()> made,
                               std::chrono::milliseconds retry)
    : program_(std::move(program)), cache_(std::move(cache)), made_(std::move(made)), retry_(retry) {
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

ThumbnailMaker::~ThumbnailMaker() {
  thread_.request_stop();
  thread_.join();
}

void ThumbnailMaker::want(const std::vector<ThumbnailRequest>& requests) {
  const std::lock_guard lock(mutex_);
  wanted_.assign(requests.begin(), requests.end());
  wake_.notify_one();
}

void ThumbnailMaker::forget() {
  const std::lock_guard lock(mutex_);
  begun_.clear();
}

std::vector<ThumbnailMade> ThumbnailMaker::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(done_, {});
}

bool ThumbnailMaker::busy() {
  const std::lock_guard lock(mutex_);
  return working_ || !wanted_.empty();
}

void ThumbnailMaker::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [&] { return !wanted_.empty(); })) {
    const ThumbnailRequest request = std::move(wanted_.front());
    wanted_.pop_front();
    working_ = true;
    lock.unlock();
    const std::string key = thumbnailKey(request);
    lock.lock();
    using Clock = std::chrono::steady_clock;
    const auto begun = begun_.find(key);
    const bool due = begun == begun_.end() || begun->second <= Clock::now();
    if (due) {
      begun_[key] = Clock::time_point::max();
      lock.unlock();
      Result<io::Pixels> pixels = make(request, key, stop);
      lock.lock();
      if (!pixels) begun_[key] = Clock::now() + retry_;
      done_.push_back({request.source, std::move(pixels)});
    }
    working_ = false;
    if (stop.stop_requested()) return;
    if (due) made_();
  }
}

Result<io::Pixels> ThumbnailMaker::make(const ThumbnailRequest& request, const std::string& key,
                                        const std::stop_token& stop) const {
  if (const auto kept = readCached(cache_, key)) return decoded(*kept, request.source);
  if (!isBuiltin(request.source) && fileStamp(request.source).bytes > largestPreviewed)
    return fail(request.source, "", "is too large for a preview");
  const TemporaryFolder folder;
  if (folder.path.empty()) return fail(request.source, "", "no folder for temporary files, so no preview");
  const fs::path png = folder.path / "preview.png", said = folder.path / "said";
  std::vector<std::string> command = thumbnailArguments(request, png);
  command.insert(command.begin(), program_.string());
  const Result<int> status = runQuietly(command, said, stop);
  if (!status) return tl::unexpected(status.error());
  const std::vector<std::byte> bytes = fileBytes(png);
  if (*status != 0 || bytes.empty()) return fail("", "", toldError(said));
  Result<io::Pixels> pixels = decoded(bytes, request.source);
  if (pixels) writeCached(cache_, key, bytes);
  return pixels;
}

}  // namespace facet::view
