#include "base/disk_cache.hpp"

#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>

namespace facet {

namespace {

namespace fs = std::filesystem;

struct Header {
  char magic[8];
  uint64_t keyBytes, valueBytes, checksum;
};
constexpr char magic[8] = {'f', 'a', 'c', 'e', 't', ' ', 'c', '1'};

uint64_t fold(const std::array<uint64_t, 2>& hash) { return hash[0] ^ std::rotl(hash[1], 32); }
std::span<const std::byte> bytesOf(std::string_view text) { return std::as_bytes(std::span(text)); }

fs::path fileOf(const DiskCache& cache, std::string_view key) {
  return cache.folder / (hexText(fold(contentHash(bytesOf(key)))) + ".bin");
}

// One step of a lane; a bijection of the word, so that no single difference is lost.
uint64_t mixed(uint64_t lane, uint64_t word) {
  lane = (lane ^ word) * 0x9fb21c651e98df25ull;
  return lane ^ (lane >> 32);
}

// Now is the time of last use, whatever the file system does about access times.
void touch(const fs::path& file) { utimensat(AT_FDCWD, file.c_str(), nullptr, 0); }

struct CacheFile {
  fs::path path;
  fs::file_time_type used;
  uintmax_t bytes;
};

void removeOldest(const DiskCache& cache, const fs::path& written) {
  std::error_code ignored;
  std::vector<CacheFile> files;
  uintmax_t sum = 0;
  const auto now = fs::file_time_type::clock::now();
  constexpr auto hour = std::chrono::hours(1);
  for (fs::directory_iterator it(cache.folder, ignored), end; it != end; it.increment(ignored)) {
    std::error_code gone;
    CacheFile file{it->path(), it->last_write_time(gone), 0};
    if (!gone) file.bytes = it->file_size(gone);
    if (gone) continue;
    // A time to come is of a clock that went wrong: such a file must not outlive all others.
    if (file.used > now + hour) file.used = fs::file_time_type::min();
    // Left by a process that ended while writing.
    if (file.path.extension() != ".bin" && file.used < now - hour) fs::remove(file.path, gone);
    sum += file.bytes;
    if (file.path.extension() == ".bin" && file.path != written) files.push_back(std::move(file));
  }
  std::ranges::sort(files, {}, &CacheFile::used);
  for (const CacheFile& file : files) {
    if (sum <= cache.maxBytes) return;
    fs::remove(file.path, ignored);
    sum -= file.bytes;
  }
}

}  // namespace

namespace {

fs::path wantedFolder() {
  if (const char* xdg = std::getenv("XDG_CACHE_HOME"); xdg && *xdg == '/') return fs::path(xdg) / "facet";
  if (const char* home = std::getenv("HOME"); home && *home == '/') return fs::path(home) / ".cache" / "facet";
  return {};
}

}  // namespace

std::string userCacheProblem() {
  const fs::path folder = wantedFolder();
  struct stat status {};
  if (folder.empty() || stat(folder.c_str(), &status) != 0) return {};
  const bool foreign = status.st_uid != geteuid(), open = (status.st_mode & S_IWOTH) != 0;
  if (!foreign && !open) return {};
  return folder.string() + (foreign ? ": belongs to another user" : ": everybody may write to it") +
         ", so that no cache is used; set XDG_CACHE_HOME to a folder of your own.";
}

std::filesystem::path userCacheFolder() { return userCacheProblem().empty() ? wantedFolder() : fs::path(); }

std::array<uint64_t, 2> contentHash(std::span<const std::byte> bytes) {
  std::array<uint64_t, 4> lanes = {0x243f6a8885a308d3ull, 0x13198a2e03707344ull, 0xa4093822299f31d0ull,
                                   0x082efa98ec4e6c89ull};
  size_t at = 0;
  for (; at + 32 <= bytes.size(); at += 32)
    for (size_t lane = 0; lane < 4; ++lane) {
      uint64_t word;
      std::memcpy(&word, bytes.data() + at + 8 * lane, 8);
      lanes[lane] = mixed(lanes[lane], word);
    }
  for (size_t lane = 0; at < bytes.size(); at += 8, ++lane) {
    uint64_t word = 0;
    std::memcpy(&word, bytes.data() + at, std::min<size_t>(8, bytes.size() - at));
    lanes[lane] = mixed(lanes[lane], word);
  }
  std::array<uint64_t, 2> out = {bytes.size(), ~bytes.size()};
  for (int round = 0; round < 2; ++round)
    for (size_t lane = 0; lane < 4; ++lane) {
      out[0] = mixed(out[0], lanes[lane]);
      out[1] = mixed(out[1], std::rotl(lanes[3 - lane], 23));
    }
  return out;
}

std::string hexText(uint64_t value) {
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(value));
  return text;
}

std::optional<std::vector<std::byte>> readCached(const DiskCache& cache, std::string_view key) {
  if (cache.folder.empty()) return std::nullopt;
  const fs::path path = fileOf(cache, key);
  std::ifstream file(path, std::ios::binary);
  std::error_code problem;
  const uintmax_t size = fs::file_size(path, problem);
  Header header{};
  if (problem || !file.read(reinterpret_cast<char*>(&header), sizeof header)) return std::nullopt;
  if (std::memcmp(header.magic, magic, sizeof magic) != 0 || header.keyBytes != key.size()) return std::nullopt;
  if (header.valueBytes > size || size != sizeof header + header.keyBytes + header.valueBytes) return std::nullopt;
  std::string stored(key.size(), '\0');
  if (!file.read(stored.data(), static_cast<std::streamsize>(stored.size())) || stored != key) return std::nullopt;
  std::vector<std::byte> value(header.valueBytes);
  if (!file.read(reinterpret_cast<char*>(value.data()), static_cast<std::streamsize>(value.size())))
    return std::nullopt;
  if (fold(contentHash(value)) != header.checksum) return std::nullopt;
  touch(path);
  return value;
}

void writeCached(const DiskCache& cache, std::string_view key, std::span<const std::byte> value) {
  if (cache.folder.empty() || sizeof(Header) + key.size() + value.size() > cache.maxBytes) return;
  std::error_code ignored;
  fs::create_directories(cache.folder, ignored);
  const fs::path path = fileOf(cache, key);
  const fs::path temporary = path.string() + "." + std::to_string(getpid());
  Header header{{}, key.size(), value.size(), fold(contentHash(value))};
  std::memcpy(header.magic, magic, sizeof magic);
  {
    std::ofstream file(temporary, std::ios::binary);
    file.write(reinterpret_cast<const char*>(&header), sizeof header);
    file.write(key.data(), static_cast<std::streamsize>(key.size()));
    file.write(reinterpret_cast<const char*>(value.data()), static_cast<std::streamsize>(value.size()));
    file.close();
    if (!file) {
      fs::remove(temporary, ignored);
      return;
    }
  }
  fs::rename(temporary, path, ignored);
  removeOldest(cache, path);
}

std::string buildId() {
  std::string id;
  // Program or library: the one that holds this function.
  static constexpr auto isOurs = [](const dl_phdr_info& info) {
    const auto here = reinterpret_cast<ElfW(Addr)>(&buildId);
    for (int i = 0; i < info.dlpi_phnum; ++i) {
      const ElfW(Phdr)& segment = info.dlpi_phdr[i];
      if (segment.p_type == PT_LOAD && here - info.dlpi_addr - segment.p_vaddr < segment.p_memsz) return true;
    }
    return false;
  };
  const auto visit = [](dl_phdr_info* info, size_t, void* out) {
    if (!isOurs(*info)) return 0;
    for (int i = 0; i < info->dlpi_phnum; ++i) {
      const ElfW(Phdr)& segment = info->dlpi_phdr[i];
      if (segment.p_type != PT_NOTE) continue;
      const auto* at = reinterpret_cast<const unsigned char*>(info->dlpi_addr + segment.p_vaddr);
      const auto* end = at + segment.p_memsz;
      while (end - at >= static_cast<ptrdiff_t>(sizeof(ElfW(Nhdr)))) {
        ElfW(Nhdr) note;
        std::memcpy(&note, at, sizeof note);
        const auto* name = at + sizeof note;
        const auto* content = name + (note.n_namesz + 3) / 4 * 4;
        at = content + (note.n_descsz + 3) / 4 * 4;
        if (at > end) break;
        if (note.n_type != NT_GNU_BUILD_ID || note.n_namesz != 4 || std::memcmp(name, "GNU", 4) != 0) continue;
        for (ElfW(Word) k = 0; k < note.n_descsz; ++k) {
          char digits[3];
          std::snprintf(digits, sizeof digits, "%02x", content[k]);
          *static_cast<std::string*>(out) += digits;
        }
      }
    }
    return 1;
  };
  dl_iterate_phdr(visit, &id);
  return id;
}

}  // namespace facet
