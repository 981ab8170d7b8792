#include "base/sandbox.hpp"

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "base/whole_file.hpp"
#include "support/temporary_folder.hpp"

using namespace facet;

namespace {

namespace fs = std::filesystem;

bool reads(const fs::path& file) {
  std::ifstream in(file);
  return std::string(std::istreambuf_iterator<char>(in), {}) == "x";
}
bool writes(const fs::path& file) { return writeWholeFile(file, std::string_view("y")).has_value(); }
template <class Call>
bool refused(Call call) {
  errno = 0;
  return call() < 0 && errno == EPERM;
}

// In a process of its own, for good: what is not as it should be; "" where all is.
std::string tryIn(const fs::path& folder) {
  const Confined confined = confineProcess({{folder / "model", folder / "one.hdr"}, {folder / "out"}});
  std::string wrong;
  const auto expect = [&](bool holds, const char* what) {
    if (!holds) wrong += std::string(what) + "; ";
  };
  const bool files = !confined.files.starts_with("no"), calls = !confined.calls.starts_with("no");
  expect(reads(folder / "model/a.bin"), "reads the model's files");
  expect(reads(folder / "model/deep/b.bin"), "and those below");
  expect(reads(folder / "one.hdr"), "reads a file");
  expect(writes(folder / "out/a.png"), "writes");
  expect(writes(folder / "out/a.png"), "writes again");
  expect(reads(folder / "secret") == !files, "no other file");
  expect(reads(folder / "model/link") == !files, "nor through a link");
  expect(writes(folder / "model/new") == !files, "no writing beside the model");
  expect(writes(folder / "elsewhere") == !files, "nor elsewhere");
  expect(files ? ::rename((folder / "out/a.png").c_str(), (folder / "b.png").c_str()) != 0 : true, "no moving out");
  bool threads = false, threadReads = true;
  std::thread([&] { threads = true, threadReads = reads(folder / "secret"); }).join();
  expect(threads, "threads can be started");
  expect(threadReads == !files, "and read no more");
  if (calls) {
    expect(refused([] { return ::socket(AF_INET, SOCK_STREAM, 0); }), "no network");
    expect(refused([] { return ::socket(AF_UNIX, SOCK_STREAM, 0); }), "no sockets");
    expect(refused([] { return ::fork(); }), "no processes");
    expect(refused([] { return ::execl("/bin/true", "true", nullptr); }), "no programs");
    expect(refused([] { return ::kill(::getppid(), 0); }), "no signals to others");
    expect(refused([&] { return ::chmod((folder / "secret").c_str(), 0600); }), "no rights by name");
  }
  return wrong;
}

// The same of a program with a window.
std::string tryWithWindow(const fs::path& folder) {
  Needed needed;
  needed.written = {folder / "out"}, needed.window = true;
  const Confined confined = confineProcess(needed);
  std::string wrong;
  const auto expect = [&](bool holds, const char* what) {
    if (!holds) wrong += std::string(what) + "; ";
  };
  const bool files = !confined.files.starts_with("no"), calls = !confined.calls.starts_with("no");
  expect(reads(folder / "secret"), "reads what people choose");
  expect(writes(folder / "out/a.png"), "writes");
  expect(writes(folder / "elsewhere") == !files, "no writing elsewhere");
  expect(files ? ::unlink((folder / "one.hdr").c_str()) != 0 : true, "no removing elsewhere");
  const int local = ::socket(AF_UNIX, SOCK_STREAM, 0);
  expect(local >= 0, "talks to the display");
  if (calls) {
    for (const int family : {AF_INET, AF_INET6, AF_NETLINK, AF_PACKET})
      expect(refused([family] { return ::socket(family, SOCK_STREAM, 0); }), "no network");
  }
  // Processes are confined as it is.
  const auto shell = [](const std::string& line) { return std::system(line.c_str()) == 0; };
  expect(shell("exit 0"), "starts programs");
  expect(shell("mkdir " + (folder / "out/a").string() + " && rmdir " + (folder / "out/a").string()),
         "folders go again");
  expect(shell("echo y 2>/dev/null >" + (folder / "elsewhere").string()) == !files, "which write nowhere else");
  return wrong;
}

// What is wrong in a process of its own.
std::string wrongIn(std::string (*attempt)(const fs::path&), const fs::path& folder) {
  int ends[2];
  REQUIRE(::pipe(ends) == 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const std::string wrong = attempt(folder);
    const bool told = ::write(ends[1], wrong.data(), wrong.size()) == static_cast<ssize_t>(wrong.size());
    ::_exit(told ? 0 : 1);
  }
  ::close(ends[1]);
  std::string wrong(4096, '\0');
  const ssize_t length = ::read(ends[0], wrong.data(), wrong.size());
  ::close(ends[0]);
  int status = -1;
  ::waitpid(child, &status, 0);
  CHECK(status == 0);
  return wrong.substr(0, static_cast<size_t>(std::max<ssize_t>(0, length)));
}

}  // namespace

TEST_CASE("A confined process reaches what it needs and nothing else", "[base]") {
  const test::TemporaryFolder folder;
  for (const char* name : {"model/a.bin", "model/deep/b.bin", "one.hdr", "secret"})
    folder.write(name, std::string("x"));
  fs::create_symlink("../secret", folder.path() / "model/link");
  fs::create_directory(folder.path() / "out");
  CHECK(wrongIn(tryIn, folder.path()) == "");
  CHECK(wrongIn(tryWithWindow, folder.path()) == "");
}
