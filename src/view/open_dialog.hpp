#pragma once

// The system's own dialog for choosing a file, a program beside the window: zenity, else kdialog.

#include <filesystem>
#include <optional>
#include <string>

#include "base/error.hpp"

namespace facet::view {

class OpenDialog {
 public:
  // Errors: neither is installed.
  static Result<OpenDialog> open(const std::filesystem::path& folder);
  OpenDialog(OpenDialog&& other) noexcept;
  OpenDialog& operator=(OpenDialog&&) = delete;
  ~OpenDialog();  // it goes with it

  // The file that was chosen, empty where none was; nothing while it is open.
  std::optional<std::string> poll();

 private:
  OpenDialog(int process, int answer) : process_(process), answer_(answer) {}
  int process_, answer_;  // -1: none; the pipe's end that is read
  std::string text_;
};

}  // namespace facet::view
