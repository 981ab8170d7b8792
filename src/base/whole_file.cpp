#include "base/whole_file.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "base/interrupt.hpp"

namespace facet {

namespace {

constexpr const char* partEnding = ".part";

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

// before: of a file that is replaced; its rights are kept. null: none.
int writeInto(const std::string& path, int flags, std::span<const std::byte> bytes,
              const struct stat* before = nullptr) {
  const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
  if (fd < 0) return errno;
  int problem = writeAll(fd, bytes);
  // A quota may be noticed only now.
  if (problem == 0 && (flags & O_EXCL) && ::fsync(fd) != 0 && errno != EINVAL) problem = errno;
  if (problem == 0 && before != nullptr) ::fchmod(fd, before->st_mode & 07777);
  if (::close(fd) != 0 && problem == 0) problem = errno;
  return problem;
}

// Of no other process, nor of one in another container that has our number. Not longer for long names.
std::string nameBeside(const std::filesystem::path& target) {
  uint64_t chance = 0;
  if (::getrandom(&chance, sizeof chance, GRND_NONBLOCK) < 0) chance = reinterpret_cast<uintptr_t>(&chance);
  char name[64];
  std::snprintf(name, sizeof name, ".facet.%d.%016llx%s", static_cast<int>(::getpid()),
                static_cast<unsigned long long>(chance), partEnding);
  return (target.parent_path() / name).string();
}

int writeBeside(const std::filesystem::path& target, const struct stat* before, std::span<const std::byte> bytes) {
  const std::string aside = nameBeside(target);
  const SignalsHeld held;  // nothing is left beside
  int problem = writeInto(aside, O_EXCL, bytes, before);
  if (problem == 0 && ::rename(aside.c_str(), target.c_str()) != 0) problem = errno;
  if (problem != 0) ::unlink(aside.c_str());
  return problem;
}

// By the permissions alone, of which a process may have given up some.
bool mayUserWrite(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  return ::access(folder.empty() ? "." : folder.c_str(), W_OK) == 0;
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
  if (problem == EACCES && mayUserWrite(target))
    return fail(path.string(), "", "cannot be written: the program has confined itself to other folders",
                "choose the one in which it was started");
  return fail(path.string(), "", std::string("cannot be written: ") + std::strerror(problem),
              "check the folder, its permissions and the space left");
}

Result<void> writeWholeFile(const std::filesystem::path& path, std::string_view text) {
  return writeWholeFile(path, std::as_bytes(std::span(text)));
}

Result<void> writeOutputFile(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  if (path != "-") return writeWholeFile(path, bytes);
  const int problem = writeAll(STDOUT_FILENO, bytes);
  if (problem == 0) return {};
  return fail("standard output", "", std::string("cannot be written: ") + std::strerror(problem), "see what reads it");
}

Result<void> copyWholeFile(const std::filesystem::path& from, const std::filesystem::path& to) {
  std::ifstream in(from, std::ios::binary);
  const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
  if (!in.is_open() || in.bad())
    return fail(from.string(), "", std::string("cannot be read: ") + std::strerror(errno), "check the file");
  return writeWholeFile(to, std::as_bytes(std::span(bytes)));
}

void removeParts(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (std::filesystem::directory_iterator it(folder, ignored), end; it != end; it.increment(ignored)) {
    const std::string name = it->path().filename().string();
    std::error_code gone;
    if (name.starts_with(".facet.") && name.ends_with(partEnding)) std::filesystem::remove(it->path(), gone);
  }
}

}  // namespace facet
