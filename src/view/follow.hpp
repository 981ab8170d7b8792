#pragma once

// Keeps to the files of what is shown: reads them again when they change on disk.

#include <chrono>
#include <string>

#include "view/file_watch.hpp"
#include "view/loader.hpp"
#include "view/viewport.hpp"

namespace facet::view {

struct Followed {
  const io::LoadedModel* model = nullptr;  // whose files are watched
  const scene::Environment* environment = nullptr;
  const frame::MeasuredOnGpu* measured = nullptr;
  FileWatch modelFiles, environmentFiles, measuredFiles;
};

struct FilesChanged {
  bool model = false, environment = false, measured = false;
};

// Starts to read again what has changed. A file that cannot be read then leaves what is shown, and is tried again at
// its next change.
FilesChanged follow(Followed& followed, const Viewport& viewport, Loader& loader,
                    std::chrono::steady_clock::time_point now);

}  // namespace facet::view
