#include "view/file_dialog.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/child_program.hpp"

namespace facet::view {

Result<FileDialog> FileDialog::open(const std::filesystem::path& folder) {
  const std::string within = (folder / "").string();
  return start({{{"zenity", "--file-selection", "--title=facet", "--filename=" + within},
                 {"kdialog", "--getopenfilename", within}}},
               false);
}

Result<FileDialog> FileDialog::save(const std::filesystem::path& proposed) {
  const std::string name = proposed.string();
  return start({{{"zenity", "--file-selection", "--save", "--confirm-overwrite", "--title=facet", "--filename=" + name},
                 {"kdialog", "--getsavefilename", name}}},
               true);
}

Result<FileDialog> FileDialog::start(const std::array<Words, 2>& programs, bool saves) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
    return fail("", "", std::string("no dialog can be opened: ") + std::strerror(errno), "try again");
  // Only the dialog's end waits.
  ::fcntl(ends[1], F_SETFL, 0);
  int process = -ENOENT;
  for (const Words& words : programs)
    if (process < 0) process = startProgram(words, {.output = ends[1]});
  ::close(ends[1]);
  if (process > 0) return FileDialog(process, ends[0], saves);
  ::close(ends[0]);
  return fail(
      "", "", "the system's dialog needs zenity or kdialog, and neither is installed",
      "install one; models also come by the browser and by being dropped, pictures are also written by their key");
}

FileDialog::FileDialog(FileDialog&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      answer_(std::exchange(other.answer_, -1)),
      saves_(other.saves_),
      text_(std::move(other.text_)) {}

FileDialog::~FileDialog() {
  if (answer_ >= 0) ::close(answer_);
  if (process_ > 0) endProgram(process_);
}

std::optional<std::string> FileDialog::poll() {
  char bytes[4096];
  for (;;) {
    const ssize_t n = ::read(answer_, bytes, sizeof bytes);
    if (n > 0) {
      text_.append(bytes, static_cast<size_t>(n));
      continue;
    }
    if (n < 0 && errno == EINTR) continue;
    if (n < 0 && errno == EAGAIN) return std::nullopt;
    break;
  }
  waitForProgram(std::exchange(process_, -1));
  return text_.substr(0, text_.find('\n'));
}

}  // namespace facet::view
