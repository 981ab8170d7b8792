#pragma once

// A picture of any size, drawn beside the window by a process of its own: the file that the copied command writes.

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"
#include "frame/settings_fwd.hpp"

namespace facet::view {

class LargePicture {
 public:
  LargePicture() = default;
  LargePicture(const LargePicture&) = delete;
  LargePicture& operator=(const LargePicture&) = delete;
  ~LargePicture();  // ends it

  // Errors: no process can be started.
  Result<void> start(const frame::PictureSettings& settings, const std::string& model,
                     const std::filesystem::path& file);
  bool running() const { return process_ > 0; }
  // Once it has ended: its name, or what it said was wrong. Nothing before.
  std::optional<Result<std::string>> poll();
  void cancel();

 private:
  int process_ = -1;
  std::filesystem::path file_, said_;
};

}  // namespace facet::view
