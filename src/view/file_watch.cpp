#include "view/file_watch.hpp"

#include <algorithm>
#include <utility>

namespace facet::view {

FileStamp fileStamp(const std::filesystem::path& file) {
  std::error_code problem;
  FileStamp stamp;
  stamp.time = std::filesystem::last_write_time(file, problem);
  if (!problem) stamp.bytes = std::filesystem::file_size(file, problem);
  stamp.there = !problem;
  return stamp.there ? stamp : FileStamp{};
}

FileWatch watchFiles(const std::vector<std::filesystem::path>& files, std::chrono::steady_clock::time_point now) {
  FileWatch watch{{}, now};
  for (size_t i = 0; i < std::min(files.size(), watchedFiles); ++i) {
    const FileStamp stamp = fileStamp(files[i]);
    watch.files.push_back({files[i], stamp, stamp});
  }
  return watch;
}

bool filesChanged(FileWatch& watch, std::chrono::steady_clock::time_point now) {
  if (watch.files.empty() || now - watch.looked < std::chrono::duration<double>(fileWatchSeconds)) return false;
  watch.looked = now;
  bool changed = false, resting = true;
  for (FileWatch::File& file : watch.files) {
    const FileStamp stamp = fileStamp(file.path);
    resting = resting && stamp == std::exchange(file.seen, stamp);
    changed = changed || (stamp.there && stamp != file.known);
  }
  if (!changed || !resting) return false;
  for (FileWatch::File& file : watch.files)
    if (file.seen.there) file.known = file.seen;
  return true;
}

}  // namespace facet::view
