#include "io/safe_files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include "io/uri.hpp"

namespace facet::io {

namespace fs = std::filesystem;

namespace {

struct Descriptor {
  int fd = -1;
  explicit Descriptor(int value) : fd(value) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

Result<void> checkKind(const fs::path& path, const struct stat& status, uint64_t maxBytes) {
  if (S_ISDIR(status.st_mode)) return fail(path.string(), "", "is a folder, not a file", "name a file in it");
  if (!S_ISREG(status.st_mode)) return fail(path.string(), "", "is not a regular file", "name a regular file");
  const auto size = static_cast<uint64_t>(status.st_size);
  if (size > maxBytes) {
    return fail(path.string(), "",
                "has " + std::to_string(size) + " bytes, more than the limit of " + std::to_string(maxBytes),
                "use a smaller file");
  }
  return {};
}

Result<void> unreadable(const fs::path& path, int code) {
  if (code == ENOENT || code == ENOTDIR) return fail(path.string(), "", "no such file", "check the path");
  return fail(path.string(), "", std::string("cannot be read: ") + std::strerror(code), "check the permissions");
}

// Empty on errors such as a loop of links or a name that is too long.
fs::path canonicalOrEmpty(const fs::path& path) {
  std::error_code code;
  fs::path result = fs::weakly_canonical(path, code);
  return code ? fs::path() : result;
}

bool isBelow(const fs::path& folder, const fs::path& file) {
  const auto [end, unused] = std::mismatch(folder.begin(), folder.end(), file.begin(), file.end());
  return end == folder.end() && unused != file.end();
}

}  // namespace

Result<void> checkRegularFile(const fs::path& path, uint64_t maxBytes) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) return unreadable(path, errno);
  return checkKind(path, status, maxBytes);
}

Result<FileBytes> readRegularFile(const fs::path& path, uint64_t maxBytes) {
  struct stat status {};
  // Before opening, because opening a device may already do something; after it again, because names can change.
  if (auto kind = checkRegularFile(path, maxBytes); !kind) return tl::unexpected(kind.error());
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  if (file.fd < 0 || ::fstat(file.fd, &status) != 0) return tl::unexpected(unreadable(path, errno).error());
  if (auto kind = checkKind(path, status, maxBytes); !kind) return tl::unexpected(kind.error());

  FileBytes bytes;
  const auto size = static_cast<size_t>(status.st_size);
  bytes.data = std::make_unique_for_overwrite<uint8_t[]>(std::max<size_t>(size, 1));
  while (bytes.size < size) {
    const ssize_t got = ::read(file.fd, bytes.data.get() + bytes.size, size - bytes.size);
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) return tl::unexpected(unreadable(path, errno).error());
    if (got == 0) break;  // became shorter meanwhile
    bytes.size += static_cast<size_t>(got);
  }
  return bytes;
}

Result<fs::path> resolveBelow(const fs::path& folder, const std::string& uri, const fs::path& outside) {
  if (hasScheme(uri)) {
    return fail("", "", "the URI " + inQuotes(uri) + " is not a relative path",
                "only data: URIs and files below the model's folder are read");
  }
  if (folder.empty()) {
    return fail("", "", "the URI " + inQuotes(uri) + " names a file, but the model is not in a folder",
                "embed the data or load the model from a file");
  }
  const fs::path other = outside.empty() ? fs::path() : canonicalOrEmpty(outside);
  const auto allowed = [&](const fs::path& path) {
    return !path.empty() && (isBelow(folder, path) || (!other.empty() && isBelow(other, path)));
  };
  const auto leadsOut = [&] {
    return fail("", "", "the URI " + inQuotes(uri) + " leads out of the model's folder",
                other.empty() ? "put the file below that folder and name it by a relative path"
                              : "put the file below that folder or " + inQuotes(other.string()),
                Setting::allowOutside);
  };
  const std::string decoded = percentDecode(uri);
  if (decoded.find('\0') != std::string::npos) {
    return fail("", "", "the URI " + inQuotes(uri) + " holds a zero byte", "rename the file");
  }
  const bool absolute = fs::path(decoded).is_absolute() || fs::path(uri).is_absolute();
  if (absolute && other.empty()) return leadsOut();
  const fs::path path = canonicalOrEmpty(folder / decoded);
  if (!allowed(path)) return leadsOut();
  std::error_code code;
  if (fs::exists(path, code)) return path;
  // Some writers forget to encode, so that a per cent sign belongs to the name.
  const fs::path literal = canonicalOrEmpty(folder / uri);
  return allowed(literal) && fs::exists(literal, code) ? literal : path;
}

FileBytes copyOf(std::span<const uint8_t> bytes) {
  FileBytes copy{std::make_unique_for_overwrite<uint8_t[]>(bytes.size()), bytes.size()};
  std::ranges::copy(bytes, copy.data.get());
  return copy;
}

Result<FileBytes> readStandardInput(uint64_t maxBytes) {
  const std::string name = "standard input";
  if (::isatty(STDIN_FILENO)) return fail(name, "", "is a terminal", "write a file to it: facet ... - < model.glb");
  std::vector<uint8_t> bytes;
  constexpr size_t atOnce = size_t{1} << 20;
  for (;;) {
    const size_t before = bytes.size();
    bytes.resize(before + atOnce);
    const ssize_t n = ::read(STDIN_FILENO, &bytes[before], atOnce);
    bytes.resize(before + static_cast<size_t>(std::max<ssize_t>(n, 0)));
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return fail(name, "", std::string("cannot be read: ") + std::strerror(errno), "name a file");
    if (n == 0) break;
    if (bytes.size() > maxBytes)
      return fail(name, "", "has more than " + std::to_string(maxBytes) + " bytes", "name a smaller file");
  }
  if (bytes.empty()) return fail(name, "", "is empty", "write a file to it: facet ... - < model.glb");
  return copyOf(bytes);
}

}  // namespace facet::io
