#include "base/disk_cache.hpp"

#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <chrono>
#include <fstream>
#include <set>

#include "support/skip.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

namespace fs = std::filesystem;

std::vector<std::byte> value(size_t bytes, int seed) {
  std::vector<std::byte> out(bytes);
  for (size_t i = 0; i < bytes; ++i) out[i] = static_cast<std::byte>((i * 7 + static_cast<size_t>(seed)) % 251);
  return out;
}

std::set<fs::path> files(const fs::path& folder) {
  std::set<fs::path> out;
  for (const auto& file : fs::directory_iterator(folder)) out.insert(file.path());
  return out;
}

}  // namespace

TEST_CASE("disk cache: what was written under a key is read under it, and under no other") {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path() / "deep" / "er", 1 << 20};
  CHECK_FALSE(readCached(cache, "a"));
  const auto first = value(1000, 1), second = value(0, 2);
  writeCached(cache, "a", first);
  writeCached(cache, "", second);
  CHECK(readCached(cache, "a") == first);
  CHECK(readCached(cache, "") == second);
  CHECK_FALSE(readCached(cache, "b"));
  writeCached(cache, "a", value(500, 3));
  CHECK(readCached(cache, "a") == value(500, 3));
  CHECK(files(cache.folder).size() == 2);
  CHECK_FALSE(readCached(DiskCache{}, "a"));
  writeCached(DiskCache{}, "a", first);
}

TEST_CASE("disk cache: files of a clock that was ahead go first, and parts that it left, too") {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 2500};
  writeCached(cache, "ahead", value(1000, 1));
  const fs::path ahead = *files(folder.path()).begin();
  folder.write("left.part", std::string("x"));
  for (const fs::path& file : {ahead, folder.path() / "left.part"})
    fs::last_write_time(file, fs::file_time_type::clock::now() + std::chrono::hours(24 * 365));
  for (const char* key : {"a", "b"}) writeCached(cache, key, value(1000, 2));
  CHECK_FALSE(readCached(cache, "ahead"));
  CHECK(readCached(cache, "a"));
  CHECK(readCached(cache, "b"));
  CHECK_FALSE(fs::exists(folder.path() / "left.part"));
}

TEST_CASE("disk cache: a damaged, cut, longer or foreign file is not read") {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 1 << 20};
  writeCached(cache, "key", value(1000, 1));
  const fs::path file = *files(folder.path()).begin();
  std::vector<char> good(fs::file_size(file));
  std::ifstream(file, std::ios::binary).read(good.data(), static_cast<std::streamsize>(good.size()));
  const auto readsWith = [&](const std::vector<char>& bytes) {
    std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return readCached(cache, "key").has_value();
  };
  CHECK(readsWith(good));
  for (size_t i = 0; i < good.size(); i += i < 48 ? 1 : 97) {
    std::vector<char> damaged = good;
    damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
    INFO("byte " << i);
    CHECK_FALSE(readsWith(damaged));
  }
  for (const size_t length : {size_t{0}, size_t{7}, size_t{20}, size_t{34}, good.size() / 2, good.size() - 1})
    CHECK_FALSE(readsWith({good.begin(), good.begin() + static_cast<ptrdiff_t>(length)}));
  std::vector<char> longer = good;
  longer.push_back(0);
  CHECK_FALSE(readsWith(longer));
  std::vector<char> huge = good;  // lengths whose sum overflows to the file's
  for (size_t i = 16; i < 24; ++i) huge[i] = static_cast<char>(0xff);
  CHECK_FALSE(readsWith(huge));
  CHECK_FALSE(readsWith(std::vector<char>(5000, 'x')));
  writeCached(cache, "key", value(1000, 1));
  CHECK(readCached(cache, "key") == value(1000, 1));
}

TEST_CASE("disk cache: stays below its bound, and what was used last stays") {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 4500};
  const auto age = [&](std::string_view key, int hours) {  // as if it had been used so long ago
    for (const fs::path& file : files(folder.path())) {
      std::ifstream stream(file, std::ios::binary);
      const std::string text{std::istreambuf_iterator<char>(stream), {}};
      if (text.substr(32, key.size()) == key)
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    }
  };
  for (const char* key : {"one", "two", "three", "four"}) writeCached(cache, key, value(1000, 1));
  CHECK(files(folder.path()).size() == 4);
  age("one", 9), age("two", 8), age("three", 7), age("four", 6);
  CHECK(readCached(cache, "one"));  // used now
  writeCached(cache, "five", value(1000, 1));
  CHECK(readCached(cache, "one"));
  CHECK_FALSE(readCached(cache, "two"));
  CHECK(readCached(cache, "three"));
  CHECK(readCached(cache, "four"));
  CHECK(readCached(cache, "five"));
  writeCached(cache, "too large", value(4500, 1));
  CHECK_FALSE(readCached(cache, "too large"));
  CHECK(files(folder.path()).size() == 4);
  // Remains of a process that ended while it wrote.
  const fs::path remains = folder.write("0123.bin.77", std::string(100, 'x')),
                 fresh = folder.write("4567.bin.78", std::string(100, 'x'));
  fs::last_write_time(remains, fs::file_time_type::clock::now() - std::chrono::hours(2));
  writeCached(cache, "five", value(1000, 2));
  CHECK_FALSE(fs::exists(remains));
  CHECK(fs::exists(fresh));
}

TEST_CASE("disk cache: processes that write, read and remove at the same time never read half a file") {
  const test::TemporaryFolder folder;
  const DiskCache cache{folder.path(), 400'000};  // room for about six: they remove each other's, too
  std::vector<pid_t> children;
  for (int process = 0; process < 4; ++process) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      int wrong = 0;
      for (int i = 0; i < 60; ++i) {
        const int key = (i * 5 + process) % 9;
        writeCached(cache, "key " + std::to_string(key), value(60'000 + static_cast<size_t>(key), key));
        const int other = (i * 7 + process) % 9;
        const auto read = readCached(cache, "key " + std::to_string(other));
        if (read && *read != value(60'000 + static_cast<size_t>(other), other)) ++wrong;
      }
      _exit(wrong > 0 ? 1 : 0);
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = -1;
    waitpid(child, &status, 0);
    CHECK(status == 0);
  }
  uintmax_t sum = 0;
  for (const fs::path& file : files(folder.path())) {
    CHECK(file.extension() == ".bin");
    sum += fs::file_size(file);
  }
  CHECK(sum <= cache.maxBytes);
}

TEST_CASE("disk cache: a folder that cannot be written or is a file is no error") {
  const test::TemporaryFolder folder;
  folder.write("file", std::string("x"));
  const DiskCache file{folder.path() / "file", 1 << 20};
  writeCached(file, "a", value(10, 1));
  CHECK_FALSE(readCached(file, "a"));
  const DiskCache closed{folder.path() / "closed", 1 << 20};
  writeCached(closed, "a", value(10, 1));
  chmod(closed.folder.c_str(), 0500);
  const bool mayWrite = access(closed.folder.c_str(), W_OK) == 0;  // root may anyway
  writeCached(closed, "b", value(10, 2));
  CHECK(readCached(closed, "a") == value(10, 1));
  if (!mayWrite) CHECK_FALSE(readCached(closed, "b"));
  chmod(closed.folder.c_str(), 0700);
}

TEST_CASE("content hash: every byte, its place and the length count") {
  std::set<std::array<uint64_t, 2>> seen;
  size_t count = 0;
  for (size_t length : {0, 1, 7, 8, 31, 32, 33, 64, 100}) {
    std::vector<std::byte> bytes(length);
    seen.insert(contentHash(bytes)), ++count;
    for (size_t i = 0; i < length; ++i)
      for (const int bit : {1, 128}) {
        bytes[i] = static_cast<std::byte>(bit);
        seen.insert(contentHash(bytes)), ++count;
        bytes[i] = std::byte(0);
      }
  }
  CHECK(seen.size() == count);
  CHECK(hexText(0x1f) == "000000000000001f");
  CHECK(buildId().size() >= 16);
}
