#include "view/open_dialog.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "base/child_program.hpp"

namespace facet::view {

Result<OpenDialog> OpenDialog::open(const std::filesystem::path& folder) {
  int ends[2];
  if (::pipe2(ends, O_CLOEXEC | O_NONBLOCK) != 0)
    return fail("", "", std::string("no dialog can be opened: ") + std::strerror(errno), "try again");
  const std::string within = (folder / "").string();
  // Only the dialog's end waits.
  ::fcntl(ends[1], F_SETFL, 0);
  const std::array<std::vector<std::string>, 2> programs = {
      {{"zenity", "--file-selection", "--title=facet", "--filename=" + within},
       {"kdialog", "--getopenfilename", within}}};
  int process = -ENOENT;
  for (const std::vector<std::string>& words : programs)
    if (process < 0) process = startProgram(words, {.output = ends[1]});
  ::close(ends[1]);
  if (process > 0) return OpenDialog(process, ends[0]);
  ::close(ends[0]);
  return fail("", "", "the system's dialog needs zenity or kdialog, and neither is installed",
              "install one, or use the browser at the left, or drop a file");
}

OpenDialog::OpenDialog(OpenDialog&& other) noexcept
    : process_(std::exchange(other.process_, -1)),
      answer_(std::exchange(other.answer_, -1)),
      text_(std::move(other.text_)) {}

OpenDialog::~OpenDialog() {
  if (answer_ >= 0) ::close(answer_);
  if (process_ <= 0) return;
  ::kill(process_, SIGTERM);
  waitForProgram(process_);
}

std::optional<std::string> OpenDialog::poll() {
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
