#pragma once

// The system's own dialog for choosing a file, a program beside the window: zenity, else kdialog.

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace facet::view {

class FileDialog {
 public:
  // Errors: neither is installed.
  static Result<FileDialog> open(const std::filesystem::path& folder);
  static Result<FileDialog> save(const std::filesystem::path& proposed);  // asks before it takes a file that there is
  FileDialog(FileDialog&& other) noexcept;
  FileDialog& operator=(FileDialog&&) = delete;
  ~FileDialog();  // it goes with it

  // The file that was chosen, empty where none was; nothing while it is open.
  std::optional<std::string> poll();
  bool saves() const { return saves_; }

 private:
  using Words = std::vector<std::string>;
  static Result<FileDialog> start(const std::array<Words, 2>& programs, bool saves);
  FileDialog(int process, int answer, bool saves) : process_(process), answer_(answer), saves_(saves) {}
  int process_, answer_;  // -1: none; the pipe's end that is read
  bool saves_;
  std::string text_;
};

}  // namespace facet::view
