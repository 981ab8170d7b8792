#pragma once

// Small pictures of models, environments and measured BRDFs, made beside the window: a process of its own, of the
// lowest priority, one at a time, with a time limit. Kept on disk by path, time and size of the file.

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/disk_cache.hpp"
#include "base/error.hpp"
#include "frame/settings_fwd.hpp"
#include "io/image.hpp"
#include "view/file_kind.hpp"

namespace facet::view {

inline constexpr int thumbnailSide = 96;                             // pixels
inline constexpr uintmax_t largestPreviewed = uintmax_t{400} << 20;  // bytes of a file; larger ones have no preview

struct ThumbnailRequest {
  FileKind kind = FileKind::model;
  std::string source;  // an absolute path, or builtin:NAME
};

struct ThumbnailMade {
  std::string source;
  Result<io::Pixels> pixels;  // RGBA, or why there is none
};

// Tells versions of a file apart. Built-ins change with the program, files by time and size.
std::string thumbnailKey(const ThumbnailRequest& request);

// How it is drawn, and which model. Environments: a mirror ball in front of them. Measured BRDFs: a ball under the
// studio.
std::string thumbnailModel(const ThumbnailRequest& request);
frame::PictureSettings thumbnailSettings(const ThumbnailRequest& request, int side = thumbnailSide);

// Arguments of `facet` that make the picture.
std::vector<std::string> thumbnailArguments(const ThumbnailRequest& request, const std::filesystem::path& png);

DiskCache thumbnailCache();  // of the user; 64 MB

class ThumbnailMaker {
 public:
  // program: its executable. made: called from another thread whenever there is something to take.
  // retry: what has failed and is still wanted is tried again after that time.
  ThumbnailMaker(std::filesystem::path program, DiskCache cache, std::function<void()> made,
                 std::chrono::milliseconds retry = std::chrono::seconds(30));
  ~ThumbnailMaker();  // ends the process that runs

  // In this order, in place of those that still wait. What is being made or was made is not made again, unless the file
  // has changed.
  void want(const std::vector<ThumbnailRequest>& requests);
  void forget();  // what was made may be wanted again
  std::vector<ThumbnailMade> take();
  bool busy();

 private:
  void work(const std::stop_token& stop);
  Result<io::Pixels> make(const ThumbnailRequest& request, const std::string& key, const std::stop_token& stop) const;

  std::filesystem::path program_;
  DiskCache cache_;
  std::function<void()> made_;
  std::mutex mutex_;
  std::condition_variable_any wake_;
  std::deque<ThumbnailRequest> wanted_;
  std::chrono::milliseconds retry_;
  // By key: when it may be tried again, if ever.
  std::map<std::string, std::chrono::steady_clock::time_point> begun_;
  std::vector<ThumbnailMade> done_;
  bool working_ = false;
  std::jthread thread_;  // last: ends first
};

}  // namespace facet::view
