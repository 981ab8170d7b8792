#include "base/whole_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

namespace facet {

namespace {

// 0, or what went wrong.
int writeAll(int fd, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = ::write(fd, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    bytes = bytes.subspan(static_cast<size_t>(n));
  }
  return 0;
}

int writeInto(const std::string& path, int flags, std::span<const std::byte> bytes) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
  if (fd < 0) return errno;
  int problem = writeAll(fd, bytes);
  // A quota may be noticed only now.
  if (problem == 0 && (flags & O_EXCL) && ::fsync(fd) != 0 && errno != EINVAL) problem = errno;
  if (::close(fd) != 0 && problem == 0) problem = errno;
  return problem;
}

int writeBeside(const std::string& target, const struct stat* before, std::span<const std::byte> bytes) {
  const std::string aside = target + "." + std::to_string(::getpid()) + ".part";
  ::unlink(aside.c_str());  // of a process that had our number and died
  int problem = writeInto(aside, O_EXCL, bytes);
  if (problem == 0 && before != nullptr) ::chmod(aside.c_str(), before->st_mode & 07777);
  if (problem == 0 && ::rename(aside.c_str(), target.c_str()) != 0) problem = errno;
  if (problem != 0) ::unlink(aside.c_str());
  return problem;
}

}  // namespace

Result<void> writeWholeFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  struct stat before {};
  const bool exists = ::stat(path.c_str(), &before) == 0;
  std::error_code code;
  const std::filesystem::path target = exists ? std::filesystem::canonical(path, code) : path;
  const bool special = exists && (code || !S_ISREG(before.st_mode));
  int problem = special ? writeInto(path.string(), 0, bytes) : writeBeside(target, exists ? &before : nullptr, bytes);
  if (!special && exists && (problem == EACCES || problem == EROFS) && ::access(target.c_str(), W_OK) == 0)
    problem = writeInto(target.string(), O_TRUNC, bytes);
  if (problem == 0) return {};
  return fail(path.string(), "", std::string("cannot be written: ") + std::strerror(problem),
              "check the folder, its permissions and the space left");
}

Result<void> writeWholeFile(const std::filesystem::path& path, std::string_view text) {
  return writeWholeFile(path, std::as_bytes(std::span(text)));
}

}  // namespace facet
